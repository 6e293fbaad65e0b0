// SPDX-License-Identifier: BSD-3-Clause
// Pressure histories: values, and the steps that stand for them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "anvil/core/error.hpp"
#include "anvil/exact/load.hpp"

namespace anvil {
namespace {

constexpr double end = 20e-6;

double impulse_of(const std::vector<PressureHistory::Step>& steps) {
  double sum = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i)
    sum += steps[i].pressure * ((i + 1 < steps.size() ? steps[i + 1].time : end) - steps[i].time);
  return sum;
}

TEST(PressureHistory, IsZeroBeforeAndAfter) {
  const PressureHistory load = PressureHistory::rectangular(2.0, 5e-6);
  EXPECT_EQ(load.at(-1e-9), 0.0);
  EXPECT_EQ(load.at(0.0), 2.0);
  EXPECT_EQ(load.at(4.999e-6), 2.0);
  EXPECT_EQ(load.at(5e-6), 0.0);
  EXPECT_EQ(PressureHistory().at(1.0), 0.0);
}

TEST(PressureHistory, FollowsItsFormula) {
  EXPECT_NEAR(PressureHistory::exponential(6e9, 7e-6).at(14e-6), 6e9 * std::exp(-2.0), 1.0);
  const PressureHistory sine = PressureHistory::half_sine(800e6, 12e-6);
  EXPECT_NEAR(sine.at(3e-6), 800e6 * std::numbers::sqrt2 / 2.0, 1.0);
  EXPECT_NEAR(sine.at(9e-6), 800e6 * std::numbers::sqrt2 / 2.0, 1.0);
  EXPECT_EQ(sine.at(12.1e-6), 0.0);
}

TEST(PressureHistory, JoinsPointsOfATable) {
  const PressureHistory load = PressureHistory::tabulated({1e-6, 3e-6, 3e-6, 5e-6}, {0.0, 4.0, 1.0, 1.0});
  EXPECT_EQ(load.at(0.5e-6), 0.0);
  EXPECT_NEAR(load.at(2e-6), 2.0, 1e-12);
  EXPECT_EQ(load.at(3e-6), 1.0);
  EXPECT_EQ(load.at(5e-6), 0.0);
  EXPECT_EQ(load.peak(), 4.0);
}

TEST(PressureHistory, RectangularLoadIsTwoSteps) {
  const auto steps = PressureHistory::rectangular(5e9, 5e-6).steps(end, 1e7);
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0].time, 0.0);
  EXPECT_EQ(steps[0].pressure, 5e9);
  EXPECT_EQ(steps[1].time, 5e-6);
  EXPECT_EQ(steps[1].pressure, 0.0);
}

TEST(PressureHistory, StepsAreSmallAndKeepTheImpulse) {
  const auto steps = PressureHistory::exponential(6e9, 7e-6).steps(end, 6e7);
  for (std::size_t i = 1; i < steps.size(); ++i) EXPECT_LE(std::abs(steps[i].pressure - steps[i - 1].pressure), 6e7);
  const double exact = 6e9 * 7e-6 * (1.0 - std::exp(-20.0 / 7.0));
  // Simpson's rule is off by h^4 / 2880 per interval; the last intervals, longest, are a tenth of the decay time.
  EXPECT_NEAR(impulse_of(steps) / exact, 1.0, 1e-8);
}

TEST(PressureHistory, RefusesImpossibleTables) {
  EXPECT_THROW(PressureHistory::tabulated({0.0}, {1.0}), InputError);
  EXPECT_THROW(PressureHistory::tabulated({0.0, 1.0}, {1.0}), InputError);
  EXPECT_THROW(PressureHistory::tabulated({1.0, 0.5}, {1.0, 1.0}), InputError);
  EXPECT_THROW(PressureHistory::tabulated({-1.0, 0.5}, {1.0, 1.0}), InputError);
  EXPECT_THROW(PressureHistory::rectangular(1.0, 0.0), InputError);
}

}  // namespace
}  // namespace anvil
