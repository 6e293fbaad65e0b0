// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/particle_interpolation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "anvil/core/error.hpp"
#include "anvil/measures/sample_places.hpp"

namespace anvil {
namespace {

constexpr double spacing = 0.1;
constexpr int across = 12;

/// A cube, square or line of particles from 0 to 1.1 in each direction, moved by up to `jitter` spacings.
Frame make_lattice(int dimension, double jitter) {
  Frame frame;
  frame.dimension = dimension;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-jitter * spacing, jitter * spacing);
  const int rows = dimension > 1 ? across : 1;
  const int layers = dimension > 2 ? across : 1;
  for (int k = 0; k < layers; ++k)
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < across; ++i)
        frame.positions.insert(frame.positions.end(),
                               {i * spacing + shift(random), dimension > 1 ? j * spacing + shift(random) : 0.0,
                                dimension > 2 ? k * spacing + shift(random) : 0.0});
  frame.arrays = {{"smoothing_length", "m", 1, false, std::vector<double>(frame.particle_count(), 1.3 * spacing)}};
  return frame;
}

/// 2 + 3 x - y + 0.5 z
double linear(const double* x) { return 2.0 + 3.0 * x[0] - x[1] + 0.5 * x[2]; }

std::vector<double> linear_field(const Frame& frame) {
  std::vector<double> values;
  for (std::size_t i = 0; i < frame.positions.size(); i += 3) values.push_back(linear(&frame.positions[i]));
  return values;
}

/// Places inside the lattice that lie on no particle.
std::vector<double> inner_points(int dimension) {
  std::vector<double> points;
  for (int i = 0; i < 40; ++i)
    points.insert(points.end(),
                  {0.31 + 0.011 * i, dimension > 1 ? 0.42 + 0.007 * i : 0.0, dimension > 2 ? 0.77 - 0.009 * i : 0.0});
  return points;
}

TEST(ParticleInterpolation, IsExactForConstantFieldsOnAnyParticles) {
  for (const int dimension : {1, 2, 3})
    for (const int order : {0, 1}) {
      const Frame frame = make_lattice(dimension, 0.3);
      const std::vector<double> field(frame.particle_count(), 7.25);
      const ParticleInterpolation interpolation(frame, {.order = order});
      const auto sampled = interpolation.at(inner_points(dimension), std::array{field});
      // Sums of some fifty terms: a few roundings of 1e-16.
      for (const double value : sampled.values[0]) EXPECT_NEAR(value, 7.25, 1e-13) << dimension << " " << order;
    }
}

TEST(ParticleInterpolation, IsExactForLinearFieldsInFirstOrder) {
  for (const int dimension : {1, 2, 3}) {
    const Frame frame = make_lattice(dimension, 0.3);
    const auto points = inner_points(dimension);
    const ParticleInterpolation interpolation(frame, {.order = 1});
    const auto sampled = interpolation.at(points, std::array{linear_field(frame)});
    for (std::size_t i = 0; i < sampled.filling.size(); ++i)
      EXPECT_NEAR(sampled.values[0][i], linear(&points[3 * i]), 1e-11) << dimension;
  }
}

TEST(ParticleInterpolation, IsExactForLinearFieldsWhereALatticeIsSymmetricAround) {
  const Frame frame = make_lattice(3, 0.0);
  const std::vector<double> points = {0.5, 0.5, 0.5, 0.55, 0.45, 0.65};  // on a particle, and in the middle of eight
  const auto sampled = ParticleInterpolation(frame, {}).at(points, std::array{linear_field(frame)});
  EXPECT_NEAR(sampled.values[0][0], linear(&points[0]), 1e-13);
  EXPECT_NEAR(sampled.values[0][1], linear(&points[3]), 1e-13);
}

TEST(ParticleInterpolation, ConvergesForSmoothFieldsOnALattice) {
  // sin over shrinking lattices: the Shepard mean with fixed h/dx is of second order there at least; at single points
  // the leading error may vanish.
  double previous = 0.0;
  for (const double scale : {1.0, 0.5}) {
    Frame frame = make_lattice(1, 0.0);
    for (double& x : frame.positions) x *= scale;
    for (double& h : frame.arrays[0].values) h *= scale;
    std::vector<double> field;
    for (std::size_t i = 0; i < frame.particle_count(); ++i) field.push_back(std::sin(frame.positions[3 * i]));
    const std::vector<double> point = {0.537 * scale, 0.0, 0.0};
    const auto sampled = ParticleInterpolation(frame, {}).at(point, std::array{field});
    const double error = std::abs(sampled.values[0][0] - std::sin(point[0])) / std::sin(point[0]);
    if (previous > 0.0) {
      EXPECT_GT(std::log2(previous / error), 1.8);
    }
    previous = error;
  }
}

TEST(ParticleInterpolation, SaysHowFullSpaceIs) {
  for (const int dimension : {1, 2, 3}) {
    const Frame frame = make_lattice(dimension, 0.0);
    const double y = dimension > 1 ? 0.5 : 0.0;
    const double z = dimension > 2 ? 0.5 : 0.0;
    // In the middle, half a spacing beyond the last particle, and far away.
    const std::vector<double> points = {0.5, y, z, 1.15, y, z, 5.0, y, z};
    const std::vector<double> field(frame.particle_count(), 1.0);
    const auto sampled = ParticleInterpolation(frame, {}).at(points, std::array{field});
    EXPECT_NEAR(sampled.filling[0], 1.0, 0.02);  // the sum over a lattice is not quite the integral
    EXPECT_NEAR(sampled.filling[1], 0.55, 0.12);
    EXPECT_EQ(sampled.filling[2], 0.0);
    EXPECT_TRUE(std::isnan(sampled.values[0][2]));
  }
}

TEST(ParticleInterpolation, TakesVolumesFromMassAndDensity) {
  Frame frame = make_lattice(3, 0.0);
  frame.arrays.push_back({"mass", "kg", 1, false, std::vector<double>(frame.particle_count(), 2.0 * 1e-3)});
  frame.arrays.push_back({"density", "kg/m3", 1, false, std::vector<double>(frame.particle_count(), 2.0)});
  // A particle alone takes up its own volume times the peak of the kernel, whatever its neighbours would say.
  const std::vector<double> surface = {-0.05, 0.5, 0.5};
  EXPECT_NEAR(ParticleInterpolation(frame, {}).at(surface, {}).filling[0], 0.5, 0.03);
}

TEST(ParticleInterpolation, EstimatesTheSmoothingLength) {
  Frame frame = make_lattice(2, 0.0);
  frame.arrays.clear();
  EXPECT_NEAR(usual_spacing(frame.positions, 2), spacing, 1e-15);
  const auto sampled = ParticleInterpolation(frame, {}).at(std::vector{0.5, 0.52, 0.0}, {});
  EXPECT_NEAR(sampled.filling[0], 1.0, 0.02);
}

TEST(ParticleInterpolation, RefusesWhatCannotBeInterpolated) {
  Frame frame = make_lattice(2, 0.0);
  frame.arrays[0].values[3] = 0.0;
  EXPECT_THROW(ParticleInterpolation(frame, {}), InputError);
  frame = make_lattice(2, 0.0);
  frame.positions[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(ParticleInterpolation(frame, {}), InputError);
}

TEST(ParticleInterpolation, SurvivesParticlesFarAway) {
  Frame frame = make_lattice(3, 0.0);
  frame.positions[0] = 1e9;
  const auto sampled = ParticleInterpolation(frame, {}).at(std::vector{0.5, 0.5, 0.5}, std::array{linear_field(frame)});
  EXPECT_NEAR(sampled.values[0][0], 2.0 + 2.5 * 0.5, 1e-12);
}

TEST(SamplePlane, CutsABox) {
  const auto plane = make_sample_plane({{0.0, 0.0, 0.5}, {0.0, 0.0, 3.0}}, {0.0, 2.0, -1.0, 1.0, 0.0, 1.0}, 0.5);
  EXPECT_EQ(plane.nodes, (std::array<int, 2>{5, 5}));
  EXPECT_EQ(plane.origin, (Point{0.0, -1.0, 0.5}));
  EXPECT_EQ(plane.u, (Point{1.0, 0.0, 0.0}));
  const auto points = points_of(plane);
  EXPECT_EQ(points.size(), 75U);
  EXPECT_NEAR(points[72], 2.0, 1e-15);
  EXPECT_NEAR(points[73], 1.0, 1e-15);
  EXPECT_NEAR(points[74], 0.5, 1e-15);
  EXPECT_THROW(make_sample_plane({{0.0, 0.0, 1.5}, {0.0, 0.0, 1.0}}, {0, 1, 0, 1, 0, 1}, 0.1), InputError);
  EXPECT_THROW(make_sample_plane({{0.0, 0.0, 0.5}, {0.0, 0.0, 0.0}}, {0, 1, 0, 1, 0, 1}, 0.1), InputError);
  EXPECT_THROW(make_sample_plane({{0.0, 0.0, 0.5}, {0.0, 0.0, 1.0}}, {0, 1, 0, 1, 0, 1}, 1e-9), InputError);
}

TEST(SamplePlane, LiesInAnObliquePlane) {
  const Plane wanted{{0.5, 0.5, 0.5}, {1.0, 1.0, 1.0}};
  const auto plane = make_sample_plane(wanted, {0, 1, 0, 1, 0, 1}, 0.1);
  const auto points = points_of(plane);
  for (std::size_t i = 0; i < points.size(); i += 3) EXPECT_NEAR(points[i] + points[i + 1] + points[i + 2], 1.5, 1e-12);
}

TEST(SampleLine, IncludesBothEnds) {
  const SampleGrid line = make_sample_line({0.0, 1.0, 0.0}, {3.0, 5.0, 0.0}, 6);
  const auto points = points_of(line);
  EXPECT_EQ(points.size(), 18U);
  EXPECT_NEAR(points[15], 3.0, 1e-14);
  EXPECT_NEAR(points[16], 5.0, 1e-14);
  EXPECT_DOUBLE_EQ(line.step[0], 1.0);
  EXPECT_TRUE(line.is_line());
  EXPECT_THROW(make_sample_line({1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 6), InputError);
  EXPECT_THROW(make_sample_line({1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, 1), InputError);
}

}  // namespace
}  // namespace anvil
