// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/rod.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

using Point = std::array<double, 3>;

constexpr RodShape shape{0.8e-3, 3.2e-3, 32e-3};

enum class Lattice { cells, faces };
enum class Part { whole, quarter };

/// The bar's particles, moved by `deform`, with a plastic strain that falls with the initial height.
Frame make_bar(Lattice lattice, Part part, const std::function<Point(const Point&)>& deform) {
  const double offset = lattice == Lattice::cells ? 0.5 * shape.spacing : 0.0;
  const int extra = lattice == Lattice::cells ? 0 : 1;
  const int first = part == Part::whole ? -4 : 0;
  Frame frame;
  FrameArray initial{"initial_position", "m", 3, false, {}};
  FrameArray strain{"plastic_strain", "", 1, false, {}};
  for (int i = first; i < 4 + extra; ++i)
    for (int j = first; j < 4 + extra; ++j)
      for (int k = 0; k < 40 + extra; ++k) {
        const Point start = {i * shape.spacing + offset, j * shape.spacing + offset, k * shape.spacing + offset};
        const Point end = deform(start);
        initial.values.insert(initial.values.end(), start.begin(), start.end());
        frame.positions.insert(frame.positions.end(), end.begin(), end.end());
        strain.values.push_back(4.0 - 100.0 * start[2]);
      }
  frame.arrays = {initial, strain};
  return frame;
}

Point stay(const Point& point) { return point; }

struct EveryBar : public ::testing::TestWithParam<std::tuple<Lattice, Part>> {
  Frame deformed(const std::function<Point(const Point&)>& deform) const {
    return make_bar(std::get<0>(GetParam()), std::get<1>(GetParam()), deform);
  }
};

// Rounding of coordinates of some centimetres.
constexpr double rounding = 1e-15;

TEST_P(EveryBar, AtTheStartHasTheSizeOfItsShape) {
  const Frame frame = deformed(stay);
  const Rod rod(frame, shape);
  EXPECT_NEAR(rod.length(), 32e-3, rounding);
  EXPECT_NEAR(rod.foot_half_width_side(), 3.2e-3, rounding);
  EXPECT_NEAR(rod.foot_half_width_corner(), 3.2e-3 * std::numbers::sqrt2, rounding);
  for (const double z : {0.0, 1e-3, 16e-3, 32e-3}) EXPECT_NEAR(value_at(rod.half_width(), z), 3.2e-3, rounding);
}

TEST_P(EveryBar, FootRadiusGrowsWithTheFoot) {
  const auto radius = [&](double factor) {
    const Frame frame = deformed([&](const Point& p) { return Point{factor * p[0], factor * p[1], p[2]}; });
    return Rod(frame, shape).foot_radius();
  };
  EXPECT_NEAR(radius(1.0), 3.2e-3, rounding);
  // Between the middle of a side and a corner.
  EXPECT_GT(radius(2.0), 6.4e-3 - 0.4e-3);
  EXPECT_LT(radius(2.0), 3.2e-3 * (1.0 + std::numbers::sqrt2));
  EXPECT_NEAR(radius(2.0) - 3.2e-3, 2.0 * (radius(1.5) - 3.2e-3), rounding);
}

TEST_P(EveryBar, GrowsByWhatItsFacesMove) {
  const Frame frame = deformed([](const Point& p) {
    return Point{p[0] + std::copysign(1e-3, p[0]), p[1] + std::copysign(1e-3, p[1]), p[2] - 5e-3};
  });
  const Rod rod(frame, shape);
  EXPECT_NEAR(rod.length(), 27e-3, rounding);
  EXPECT_NEAR(rod.foot_half_width_side(), 4.2e-3, rounding);
  EXPECT_NEAR(rod.foot_half_width_corner(), 4.2e-3 * std::numbers::sqrt2, rounding);
}

TEST_P(EveryBar, WidthFollowsTheHeight) {
  // A face that leans inward by 0.05 per height, from 1 mm outside at the foot.
  const Frame frame = deformed([](const Point& p) {
    const double move = 1e-3 - 0.05 * p[2];
    return Point{p[0] + std::copysign(move, p[0]), p[1] + std::copysign(move, p[1]), p[2]};
  });
  const Rod rod(frame, shape);
  for (const double z : {4e-3, 8e-3, 12e-3})
    EXPECT_NEAR(value_at(rod.half_width(), z), 4.2e-3 - 0.05 * z, rounding) << z;
}

TEST_P(EveryBar, AxisStrainGoesWithTheMaterial) {
  const Frame frame = deformed([](const Point& p) { return Point{p[0], p[1], 0.5 * p[2]}; });
  const Curve strain = Rod(frame, shape).axis_plastic_strain();
  for (const double z : {1e-3, 2e-3, 4e-3}) EXPECT_NEAR(value_at(strain, z), 4.0 - 100.0 * z, 1e-12) << z;
}

INSTANTIATE_TEST_SUITE_P(Rod, EveryBar,
                         ::testing::Combine(::testing::Values(Lattice::cells, Lattice::faces),
                                            ::testing::Values(Part::whole, Part::quarter)));

TEST(Rod, LooksAtTheMiddleOfTheSidesOnly) {
  const Frame frame = make_bar(Lattice::cells, Part::whole, [](const Point& p) {
    const bool corner = std::abs(p[0]) > 1e-3 && std::abs(p[1]) > 1e-3;
    return corner ? Point{2.0 * p[0], 2.0 * p[1], p[2]} : p;
  });
  const Rod rod(frame, shape);
  EXPECT_NEAR(rod.foot_half_width_side(), 3.2e-3, rounding);
  // The outermost centre, at 2.8 mm, has moved to 5.6 mm; its half cell is added.
  EXPECT_NEAR(rod.foot_half_width_corner(), (5.6e-3 + 0.4e-3) * std::numbers::sqrt2, rounding);
}

TEST(Rod, RefusesWhatIsNoRod) {
  Frame flat = make_bar(Lattice::cells, Part::whole, stay);
  flat.dimension = 2;
  EXPECT_THROW(Rod(flat, shape), InputError);
  Frame bare = make_bar(Lattice::cells, Part::whole, stay);
  bare.arrays.clear();
  EXPECT_THROW(Rod(bare, shape), InputError);
}

}  // namespace
}  // namespace anvil
