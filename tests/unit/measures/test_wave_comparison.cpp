// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/wave_comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "anvil/core/error.hpp"
#include "anvil/scene/reader.hpp"

namespace anvil {
namespace {

constexpr double spacing = 0.1e-3;
constexpr double time = 3e-6;
constexpr double front = 18e-3;  // elastic waves of 6000 m/s

/// 30 mm of an elastic material with c = 6000 m/s and rho c = 6e6, under 60 MPa from the left.
Scene make_scene() {
  return read_scene_text(
      "domain = { dimension = 1 }\ndiscretisation = { spacing = 0.1e-3 }\ntime = { end = 3e-6 }\n"
      "[[body]]\nname = 'plate'\nshape = { type = 'interval', min = 0, max = 30e-3 }\nmaterial = 'm'\n"
      "[material.m]\ndensity = 1000\neos = { type = 'linear', bulk_modulus = 24e9 }\n"
      "strength = { type = 'elastic', shear_modulus = 9e9 }\n"
      "[[boundary]]\nname = 'load'\ntype = 'pressure'\nbody = 'plate'\nhistory = 'rectangular'\nvalue = 60e6\n"
      "duration = 1\n",
      "step");
}

Frame make_frame(const std::function<double(double)>& stress) {
  Frame frame;
  frame.time = time;
  frame.dimension = 1;
  FrameArray initial{"initial_position", "m", 3, false, {}};
  FrameArray velocity{"velocity", "m/s", 3, false, {}};
  FrameArray tensor{"stress", "Pa", 6, false, {}};
  for (int i = 0; i < 300; ++i) {
    const double x = (i + 0.5) * spacing;
    frame.positions.insert(frame.positions.end(), {x, 0.0, 0.0});
    initial.values.insert(initial.values.end(), {x, 0.0, 0.0});
    velocity.values.insert(velocity.values.end(), {-stress(x) / 6e6, 0.0, 0.0});
    tensor.values.insert(tensor.values.end(), {stress(x), 0, 0, 0, 0, 0});
  }
  frame.arrays = {initial, velocity, tensor};
  return frame;
}

ComparedQuantity compared(const std::string& name, const std::function<double(double)>& stress) {
  const SceneReference reference(make_scene(), {time}, StrainMeasure::small);
  for (const auto& quantity : compare_waves(make_frame(stress), reference, 0, spacing))
    if (quantity.name == name) return quantity;
  ADD_FAILURE() << name << " is not compared";
  return {};
}

double exact(double x) { return x < front ? -60e6 : 0.0; }

TEST(WaveComparison, FindsNothingWrongWithTheExactSolution) {
  for (const char* name : {"stress_l1", "stress_l2", "velocity_l1", "velocity_l2", "stress_overshoot", "plateau_error"})
    EXPECT_NEAR(compared(name, exact).value, 0.0, 1e-9) << name;
  EXPECT_NEAR(compared("peak_stress", exact).value, -60e6, 1.0);
  EXPECT_EQ(compared("peak_stress", exact).time, time);
  EXPECT_NEAR(compared("rise_width", exact).value, 0.8, 1e-9);  // straight between two particles, 10 to 90 %
}

TEST(WaveComparison, MeasuresNormsOverThePeak) {
  // A front 30 particles late: a tenth of the plate is wrong by the whole jump.
  const auto late = [](double x) { return exact(x + 30 * spacing); };
  EXPECT_NEAR(compared("stress_l1", late).value, 0.1, 1e-9);
  EXPECT_NEAR(compared("stress_l2", late).value, std::sqrt(0.1), 1e-9);
  EXPECT_NEAR(compared("velocity_l1", late).value, 0.1, 1e-6);
}

TEST(WaveComparison, MeasuresTheWidthOfAFront) {
  const auto ramp = [](double x) { return -60e6 * std::clamp(0.5 - (x - front) / (20 * spacing), 0.0, 1.0); };
  EXPECT_NEAR(compared("rise_width", ramp).value, 16.0, 1e-6);  // 80 % of 20 spacings
  EXPECT_TRUE(std::isnan(compared("rise_width", [](double) { return 0.0; }).value));
}

TEST(WaveComparison, SeesOvershootAndPlateaus) {
  const auto off = [](double x) { return exact(x) * (x < front - 1e-3 ? 0.98 : 1.05); };
  EXPECT_NEAR(compared("stress_overshoot", off).value, 0.05, 1e-9);
  EXPECT_NEAR(compared("peak_stress", off).deviation, -0.05, 1e-9);
  EXPECT_NEAR(compared("plateau_1", off).deviation, 0.02, 1e-9);
  EXPECT_NEAR(compared("plateau_error", off).value, 0.02, 1e-9);
}

TEST(WaveComparison, RefusesFramesItCannotJudge) {
  const SceneReference reference(make_scene(), {0.0, time}, StrainMeasure::small);
  Frame frame = make_frame(exact);
  frame.arrays.pop_back();
  EXPECT_THROW(compare_waves(frame, reference, 1, spacing), InputError);
}

}  // namespace
}  // namespace anvil
