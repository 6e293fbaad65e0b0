// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/terms/line_transport.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>

#include "anvil/core/field_keys.hpp"

namespace anvil {
namespace {

constexpr double spacing = 1e-3;    // m
constexpr double time_step = 1e-8;  // s
constexpr std::int32_t half = 30, count = 2 * half;

/// Two bodies of thirty particles and of unlike material side by side, stressed and strained a little at random.
struct Line {
  Line() : fields(count), ranges{{0, half}, {half, count}} {
    for (const FieldKey* key : {&field::position, &field::velocity, &field::mass, &field::density,
                                &field::smoothing_length, &field::pressure})
      fields.require(*key);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t body = i < half ? 0 : 1;
      fields.scalar(field::position)[i] = spacing * (static_cast<double>(i) + 0.5);
      fields.scalar(field::density)[i] = density[body];
      fields.scalar(field::mass)[i] = spacing * density[body];
      fields.scalar(field::smoothing_length)[i] = spacing;
    }
    std::vector<std::int32_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    transport = std::make_unique<LineTransport>(fields, order, ranges, modulus, 2.0,
                                                TransportCoefficients{.diffusion = 0.2, .antidiffusion = 0.2});
    std::mt19937 random(4);
    std::uniform_real_distribution<double> strain(-1e-3, 1e-3);
    for (std::size_t i = 0; i < count; ++i) {
      rate.push_back(strain(random) / time_step);
      fields.scalar(field::pressure)[i] = modulus[0] * strain(random);
    }
  }

  void filter() { transport->filter_strain(rate, time_step); }

  const std::vector<double> density = {2700.0, 7800.0};  // kg/m3
  const std::vector<double> modulus = {1e11, 3e11};      // Pa
  FieldStore fields;
  std::vector<ParticleRange> ranges;
  std::unique_ptr<LineTransport> transport;
  std::vector<double> rate;  // 1/s
};

TEST(LineTransport, KeepsTheLengthOfTheLine) {
  Line line;
  const auto before = line.rate;
  line.filter();
  double length = 0.0, expected = 0.0, changed = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    length += time_step * line.rate[i];
    expected += time_step * before[i];
    changed += time_step * std::abs(line.rate[i] - before[i]);
  }
  EXPECT_NEAR(length, expected, 1e-15);  // round-off of sixty numbers near 1e-3
  EXPECT_GT(changed, 1e-3);
}

/// The distance of two particles grows by the mean of what their lengths grow.
TEST(LineTransport, MovesParticlesWithTheirFaces) {
  Line line;
  const auto before = line.rate;
  line.filter();
  const auto growth = [&](std::size_t i) { return spacing * time_step * (line.rate[i] - before[i]); };
  const auto position = line.fields.scalar(field::position);
  EXPECT_NEAR(position[0], 0.5 * spacing + 0.5 * growth(0), 1e-17);  // the end of the line stays at zero
  for (std::size_t i = 0; i + 1 < count; ++i)
    EXPECT_NEAR(position[i + 1] - position[i], spacing + 0.5 * (growth(i) + growth(i + 1)), 1e-17);
}

TEST(LineTransport, LetsUniformStrainOfAStressPass) {
  Line line;
  std::fill(line.fields.scalar(field::pressure).begin(), line.fields.scalar(field::pressure).end(), 1e8);
  for (std::size_t i = 0; i < count; ++i) line.rate[i] = -1e8 / line.modulus[i < half ? 0 : 1] / time_step;
  const auto before = line.rate;
  line.filter();
  for (std::size_t i = 0; i < count; ++i) EXPECT_NEAR(line.rate[i], before[i], 1e-12 * std::abs(before[i]));
}

/// A lone stressed particle shares its stress and so gives up energy.
TEST(LineTransport, CountsWhatTheFilterTakes) {
  Line line;
  constexpr std::size_t lone = 10;
  const auto pressure = line.fields.scalar(field::pressure);
  std::fill(pressure.begin(), pressure.end(), 0.0);
  std::fill(line.rate.begin(), line.rate.end(), 0.0);
  pressure[lone] = 1e8;
  const auto energy = [&] {
    double sum = 0.0;
    for (const double stress : pressure) sum += 0.5 * spacing * stress * stress / line.modulus[0];
    return sum;
  };
  const double before = energy();
  line.filter();
  for (std::size_t i = 0; i < half; ++i) pressure[i] -= line.modulus[0] * time_step * line.rate[i];
  EXPECT_DOUBLE_EQ(pressure[lone], 0.6e8);  // 1 - 2 eta
  EXPECT_DOUBLE_EQ(pressure[lone + 1], 0.2e8);
  EXPECT_NEAR(line.transport->strain_loss(), before - energy(), 1e-12 * before);
}

}  // namespace
}  // namespace anvil
