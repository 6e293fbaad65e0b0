// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/shell.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

ShellShape shape_of_two(double spacing) { return {spacing, Vec<2>::Zero(), 80e-3, 100e-3}; }

/// Layers of 400 particles each, moved to the radius and by the shift given.
Frame make_ring(double spacing, const std::function<double(double radius, double angle)>& radius_at_end,
                const Vec<2>& shift = Vec<2>::Zero(), double last_angle = 2.0 * std::numbers::pi) {
  Frame frame;
  FrameArray initial{"initial_position", "m", 3, false, {}};
  for (double radius = 80e-3 + 0.5 * spacing; radius < 100e-3; radius += spacing)
    for (int k = 0; k < 400; ++k) {
      const double angle = last_angle * (k + 0.5) / 400.0, end = radius_at_end(radius, angle);
      for (const double x : {radius * std::cos(angle), radius * std::sin(angle), 0.0}) initial.values.push_back(x);
      for (const double x : {end * std::cos(angle) + shift[0], end * std::sin(angle) + shift[1], 0.0})
        frame.positions.push_back(x);
    }
  frame.arrays = {initial};
  return frame;
}

/// r^2 falls by the same for all: areas stay.
double collapse(double radius) { return std::sqrt(radius * radius - 80e-3 * 80e-3 + 50e-3 * 50e-3); }

TEST(Shell, FindsItsFacesWhateverTheSpacing) {
  for (const double spacing : {0.5e-3, 1e-3, 2e-3}) {
    const Frame frame = make_ring(spacing, [](double radius, double) { return collapse(radius); });
    const Shell shell(frame, shape_of_two(spacing));
    EXPECT_NEAR(shell.inner_radius(), 50e-3, 1e-14);
    EXPECT_NEAR(shell.outer_radius(), collapse(100e-3), 1e-14);
    EXPECT_NEAR(shell.circularity(), 0.0, 1e-12);
  }
}

TEST(Shell, MeasuresHowRoundItIs) {
  const Frame frame =
      make_ring(1e-3, [](double radius, double angle) { return radius * (1.0 + 0.01 * std::cos(2.0 * angle)); });
  // The face follows its particles: 1 % either way, to the order of a spacing over the radius.
  EXPECT_NEAR(Shell(frame, shape_of_two(1e-3)).circularity(), 0.02, 0.02 * 0.02);
}

TEST(Shell, MovesWithTheRing) {
  const Frame frame = make_ring(1e-3, [](double radius, double) { return collapse(radius); }, {0.4, -0.1});
  EXPECT_NEAR(Shell(frame, shape_of_two(1e-3)).inner_radius(), 50e-3, 1e-12);
  EXPECT_NEAR(Shell(frame, shape_of_two(1e-3)).circularity(), 0.0, 1e-10);
}

TEST(Shell, MeasuresASectorFromItsCorner) {
  const Frame frame = make_ring(
      1e-3, [](double radius, double) { return collapse(radius); }, Vec<2>::Zero(), 0.5 * std::numbers::pi);
  EXPECT_NEAR(Shell(frame, shape_of_two(1e-3)).inner_radius(), 50e-3, 1e-14);
}

TEST(Shell, AsksForWhatItNeeds) {
  Frame frame = make_ring(1e-3, [](double radius, double) { return radius; });
  frame.arrays.clear();
  EXPECT_THROW(Shell(frame, shape_of_two(1e-3)), InputError);
}

}  // namespace
}  // namespace anvil
