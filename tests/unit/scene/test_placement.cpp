// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/placement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

constexpr double pi = std::numbers::pi;
using Keys = std::map<std::string, Value>;

BodyDescription body_of(const std::string& type, const Keys& keys) {
  BodyDescription body{"body", {type, {}}, "cubic", "copper", {}};
  for (const auto& [key, value] : keys) body.shape.parameters.set(key, value);
  return body;
}

BodyDescription box(const std::vector<double>& min, const std::vector<double>& max) {
  return body_of("box", {{"min", min}, {"max", max}});
}
BodyDescription interval(double min, double max) { return body_of("interval", {{"min", min}, {"max", max}}); }
BodyDescription ring(const std::vector<double>& centre, double inner, double outer) {
  return body_of("ring", {{"centre", centre}, {"inner_radius", inner}, {"outer_radius", outer}});
}
BodyDescription cylinder(const std::vector<double>& base, const std::string& axis, double radius, double length) {
  return body_of("cylinder", {{"base", base}, {"axis", axis}, {"radius", radius}, {"length", length}});
}

template <int D>
double total_volume(const PlacedBody<D>& placed) {
  return std::accumulate(placed.volumes.begin(), placed.volumes.end(), 0.0);
}

/// All volumes are the same double; their sum carries one rounding per particle at most.
template <int D>
void expect_exact_volume(const BodyDescription& body, double spacing, double exact) {
  const auto placed = place_body<D>(body, spacing);
  ASSERT_EQ(placed.positions.size(), placed.volumes.size());
  const double rounding = 1e-16 * static_cast<double>(placed.volumes.size()) + 1e-15;
  EXPECT_NEAR(total_volume(placed) / exact, 1.0, rounding) << body.shape.type << " at " << spacing;
}

/// Mirrors the body at its middle, axis by axis, and expects the same particles; `middle` is zero, so that no position
/// is rounded and the mirror image is exact.
template <int D>
void expect_mirror_symmetry(const BodyDescription& body, double spacing) {
  const auto placed = place_body<D>(body, spacing);
  const auto sorted = [](std::vector<Vec<D>> positions) {
    std::sort(positions.begin(), positions.end(), [](const auto& a, const auto& b) {
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    });
    return positions;
  };
  for (int axis = 0; axis < D; ++axis) {
    auto mirrored = placed.positions;
    for (auto& position : mirrored) position[axis] = 0.0 - position[axis];
    EXPECT_EQ(sorted(mirrored), sorted(placed.positions)) << body.shape.type << " along axis " << axis;
  }
}

TEST(Placement, VolumeIsExactForEveryShapeAndSpacing) {
  for (const double spacing : {0.8e-3, 0.4e-3, 0.533333e-3, 0.37e-3}) {
    expect_exact_volume<3>(box({-3.2e-3, -3.2e-3, 0}, {3.2e-3, 3.2e-3, 32e-3}), spacing, 6.4e-3 * 6.4e-3 * 32e-3);
    expect_exact_volume<2>(box({0, 0}, {4e-3, 6e-3}), spacing, 24e-6);
    expect_exact_volume<1>(interval(-1e-3, 7e-3), spacing, 8e-3);
    expect_exact_volume<2>(ring({0.1, 0}, 4e-3, 5e-3), spacing, pi * 9e-6);
    expect_exact_volume<2>(ring({0, 0}, 0.0, 5e-3), spacing, pi * 25e-6);
    for (const auto* axis : {"x", "y", "z"})
      expect_exact_volume<3>(cylinder({0, 0, 0}, axis, 3.2e-3, 32e-3), spacing, pi * 3.2e-3 * 3.2e-3 * 32e-3);
  }
}

TEST(Placement, LatticeIsMirrorSymmetric) {
  for (const double spacing : {0.8e-3, 0.7e-3, 0.37e-3}) {  // even and odd numbers of cells
    expect_mirror_symmetry<3>(box({-3.2e-3, -3.2e-3, -4e-3}, {3.2e-3, 3.2e-3, 4e-3}), spacing);
    expect_mirror_symmetry<3>(cylinder({0, -4e-3, 0}, "y", 3.2e-3, 8e-3), spacing);
    expect_mirror_symmetry<2>(ring({0, 0}, 2e-3, 5e-3), spacing);
    expect_mirror_symmetry<1>(interval(-4e-3, 4e-3), spacing);
  }
}

TEST(Placement, ParticlesFillTheBar) {
  const auto placed = place_body<3>(box({-3.2e-3, -3.2e-3, 0}, {3.2e-3, 3.2e-3, 32e-3}), 0.8e-3);
  EXPECT_EQ(placed.positions.size(), 2560u);
  Vec<3> lowest = placed.positions.front();
  Vec<3> highest = lowest;
  for (const auto& position : placed.positions) {
    lowest = lowest.cwiseMin(position);
    highest = highest.cwiseMax(position);
  }
  // Half a spacing inside every face, to the rounding of the coordinates.
  EXPECT_TRUE(lowest.isApprox(Vec<3>(-2.8e-3, -2.8e-3, 0.4e-3), 1e-14));
  EXPECT_TRUE(highest.isApprox(Vec<3>(2.8e-3, 2.8e-3, 31.6e-3), 1e-14));
  // 0.8e-3^3 m3 each
  EXPECT_NEAR(placed.volumes.front(), 5.12e-10, 1e-23);
}

TEST(Placement, NeighboursAreOneSpacingApart) {
  const auto placed = place_body<1>(interval(0.0, 8e-3), 0.1e-3);
  ASSERT_EQ(placed.positions.size(), 80u);
  for (std::size_t i = 1; i < placed.positions.size(); ++i)
    EXPECT_NEAR(placed.positions[i][0] - placed.positions[i - 1][0], 0.1e-3, 1e-17);  // rounding of 8e-3
}

TEST(Placement, RingLeavesTheHoleFree) {
  const auto placed = place_body<2>(ring({1.0, 2.0}, 80e-3, 100e-3), 2e-3);
  for (const auto& position : placed.positions) {
    const double distance = (position - Vec<2>(1.0, 2.0)).norm();
    EXPECT_GT(distance, 80e-3 - 1e-12);
    EXPECT_LT(distance, 100e-3 + 1e-12);
  }
  // The number of cells in a region approaches its area in cells; 2 % is the share of the cells cut by the two circles.
  EXPECT_NEAR(static_cast<double>(placed.positions.size()), pi * (1e4 - 6.4e3) / 4.0, 0.02 * pi * 3.6e3 / 4.0);
}

TEST(Placement, RefusesMoreParticlesThanFit) {
  EXPECT_THROW(place_body<3>(box({0, 0, 0}, {1, 1, 1}), 1e-9), InputError);
  EXPECT_THROW(place_body<3>(box({0, 0, 0}, {1e300, 1e300, 1e300}), 1e-300), InputError);
}

TEST(Placement, RefusesBodiesWithoutParticles) {
  EXPECT_THROW(place_body<2>(ring({0, 0}, 9.9e-3, 10e-3), 9e-3), InputError);
}

TEST(Placement, RefusesShapesOfAnotherDimension) {
  EXPECT_THROW(place_body<2>(interval(0.0, 1.0), 0.1), InputError);
  EXPECT_THROW(place_body<3>(ring({0, 0}, 0.0, 1.0), 0.1), InputError);
}

/// The farthest point of a shape in a direction, against the particles of a fine lattice.
TEST(Shape, ReachEnclosesItsParticles) {
  const auto body = cylinder({1e-3, 2e-3, 3e-3}, "x", 2e-3, 5e-3);
  const auto shape = make_shape<3>(body.shape);
  const double spacing = 0.1e-3;
  const auto placed = place_body<3>(body, spacing);
  for (const Vec<3>& direction : {Vec<3>(1, 0, 0), Vec<3>(0, 1, 0), Vec<3>(0, 0, -1), Vec<3>(0.6, 0.0, 0.8)}) {
    double farthest = 0.0;
    for (const auto& position : placed.positions)
      farthest = std::max(farthest, direction.dot(position - shape->centre()));
    EXPECT_GE(shape->reach(direction), farthest);
    EXPECT_LE(shape->reach(direction), farthest + 2.0 * spacing);  // centres stay up to two half diagonals inside
  }
}

}  // namespace
}  // namespace anvil
