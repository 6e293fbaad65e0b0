// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/terms/flux_corrected_transport.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace anvil {
namespace {

constexpr std::size_t count = 60;
constexpr FluxLimiter limiters[] = {FluxLimiter::standard, FluxLimiter::six_arguments};

struct Line {
  std::vector<double> before, after, weight, link;

  explicit Line(double weight_spread = 0.0) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (std::size_t k = 0; k < count; ++k) {
      before.push_back(unit(random));
      after.push_back(before[k] + 0.1 * unit(random));
      weight.push_back(1.0 + weight_spread * unit(random));
    }
    for (std::size_t k = 0; k + 1 < count; ++k) link.push_back(std::min(weight[k], weight[k + 1]));
  }
  void filter(const TransportCoefficients& coefficients) {
    FluxCorrectedTransport(coefficients).apply(before, after, weight, link);
  }
  [[nodiscard]] double sum() const { return std::inner_product(weight.begin(), weight.end(), after.begin(), 0.0); }
};

TEST(FluxCorrectedTransport, KeepsTheWeightedSum) {
  for (const auto limiter : limiters) {
    Line line(0.5);
    const double sum = line.sum();
    const auto unfiltered = line.after;
    line.filter({.limiter = limiter});
    EXPECT_NE(line.after, unfiltered);
    EXPECT_NEAR(line.sum(), sum, 1e-14 * count);  // round-off of sixty numbers of order one
  }
}

TEST(FluxCorrectedTransport, LetsNothingThroughACut) {
  Line line(0.5);
  constexpr std::size_t cut = 20;
  line.link[cut] = 0.0;
  const auto left_sum = [&] {
    return std::inner_product(line.weight.begin(), line.weight.begin() + cut + 1, line.after.begin(), 0.0);
  };
  const double before = left_sum();
  line.filter({});
  EXPECT_NEAR(left_sum(), before, 1e-14 * count);
}

/// Without limiter the filter would be the identity on a field that does not change; where the limiter acts it only
/// leaves diffusion behind.
TEST(FluxCorrectedTransport, LeavesASmoothMonotoneFieldAlone) {
  Line line;
  for (std::size_t k = 0; k < count; ++k) line.before[k] = line.after[k] = 3.0 * static_cast<double>(k) - 7.0;
  const auto expected = line.after;
  for (const auto limiter : limiters) {
    line.filter({.limiter = limiter});
    // The ends are diffused and gathered like the rest: nothing but round-off of numbers of order a hundred.
    for (std::size_t k = 0; k < count; ++k) EXPECT_NEAR(line.after[k], expected[k], 1e-12);
  }
}

/// What the limiter is for: the gathered field has no extremum that the diffused one did not have.
TEST(FluxCorrectedTransport, MakesNoNewExtremum) {
  for (const auto limiter : limiters) {
    for (const double eta : {0.125, 0.2}) {
      Line line, diffused;
      for (std::size_t k = 0; k < count; ++k)
        line.before[k] = line.after[k] = diffused.before[k] = diffused.after[k] = k < 30 ? 1.0 : 0.0;
      line.filter({.diffusion = eta, .antidiffusion = eta, .limiter = limiter});
      diffused.filter({.diffusion = eta, .antidiffusion = 0.0});
      for (std::size_t k = 1; k + 1 < count; ++k) {
        const auto [low, high] = std::minmax({diffused.after[k - 1], diffused.after[k], diffused.after[k + 1]});
        EXPECT_GE(line.after[k], low - 1e-15) << "at " << k;
        EXPECT_LE(line.after[k], high + 1e-15) << "at " << k;
      }
    }
  }
}

/// A lone peak is diffused and not gathered: step 5 with D of either sign on its sides.
TEST(FluxCorrectedTransport, DoesNotGatherALonePeak) {
  Line line;
  std::fill(line.before.begin(), line.before.end(), 0.0);
  line.before[30] = 1.0;
  line.after = line.before;
  line.filter({});
  EXPECT_DOUBLE_EQ(line.after[30], 0.75);  // 1 - 2 eta
  EXPECT_DOUBLE_EQ(line.after[29], 0.125);
  EXPECT_DOUBLE_EQ(line.after[31], 0.125);
}

}  // namespace
}  // namespace anvil
