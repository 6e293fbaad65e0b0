// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "anvil/boundaries/wall_laws.hpp"
#include "anvil/boundaries/wall_surface.hpp"
#include "anvil/core/error.hpp"

namespace anvil {
namespace {

constexpr double spacing = 1e-3;

Parameters path_keys(const Points& path, bool closed = false) {
  Parameters keys;
  keys.set("path", path);
  keys.set("closed", closed);
  return keys;
}

template <int D>
double nearest_pair(const std::vector<WallPoint<D>>& points) {
  double nearest = 1.0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, (points[i].position - points[j].position).norm());
  return nearest;
}

template <int D>
bool holds_point(const std::vector<WallPoint<D>>& points, const Vec<D>& place) {
  return std::any_of(points.begin(), points.end(),
                     [&](const auto& point) { return (point.position - place).norm() < 1e-9; });
}

/// A floor of 8 and a wall of 5 spacings in three rows, with the 3 x 3 points of the corner.
TEST(WallSurface, FillsTheCornerOfAnL) {
  const WallSurface<2> wall(path_keys({{0.0, 5e-3}, {0.0, 0.0}, {8e-3, 0.0}}));
  const auto points = wall.rows(spacing, 0.5, 3);
  EXPECT_EQ(points.size(), 3U * (8 + 5) + 9U);
  EXPECT_NEAR(nearest_pair(points), spacing, 1e-9);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_TRUE(holds_point<2>(points, Vec<2>(-(i + 0.5) * spacing, -(j + 0.5) * spacing))) << i << j;
  EXPECT_TRUE(holds_point<2>(points, Vec<2>(7.5e-3, -2.5e-3)));
  EXPECT_TRUE(holds_point<2>(points, Vec<2>(-1.5e-3, 4.5e-3)));
  for (const auto& point : points) EXPECT_TRUE(point.position[0] < 0.0 || point.position[1] < 0.0);
}

/// A closed box: the rows lie around it, and around a block on the other side of the path inside it.
TEST(WallSurface, SurroundsABoxAndFillsABlock) {
  const Points box = {{0.0, 0.0}, {10e-3, 0.0}, {10e-3, 6e-3}, {0.0, 6e-3}};
  const auto around = WallSurface<2>(path_keys(box, true)).rows(spacing, 0.5, 3);
  EXPECT_EQ(around.size(), 16U * 12U - 10U * 6U);
  const Points block(box.rbegin(), box.rend());
  const auto inside = WallSurface<2>(path_keys(block, true)).rows(spacing, 0.5, 3);
  EXPECT_EQ(inside.size(), 60U);
  for (const auto& point : inside) EXPECT_GT(point.position[0], 0.0);
  EXPECT_NEAR(nearest_pair(inside), spacing, 1e-9);
}

/// Rows beside an oblique wall and around a bend keep their spacing within a tenth and their distance exactly.
TEST(WallSurface, KeepsItsDistanceAroundABend) {
  Points bend;
  const double radius = 40e-3;
  for (int k = 0; k <= 23; ++k) {
    const double angle = 0.5 * std::numbers::pi * k / 23;
    bend.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  const auto points = WallSurface<2>(path_keys(bend)).rows(spacing, 0.5, 3);
  EXPECT_GT(nearest_pair(points), 0.9 * spacing);
  for (const auto& point : points) {
    // The chords of the path lie up to 0.02 spacings inside the arc.
    EXPECT_NEAR(point.position.norm(), radius + (point.row + 0.5) * spacing, 0.05 * spacing);
    EXPECT_LT(point.normal.dot(point.position), 0.0);
  }
}

/// From an end round a bend to a corner, and from a corner round a bend to an end: the mould's first piece and its
/// last.
TEST(WallSurface, KeepsItsDistanceAroundABendBesideACorner) {
  const double radius = 40e-3;
  Points path = {{0.0, -radius}};
  for (int k = -22; k <= 0; ++k) {
    const double angle = 0.5 * std::numbers::pi * k / 23;
    path.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  path.push_back({0.0, 0.0});
  for (const bool backwards : {false, true}) {
    Points drawn = path;
    if (backwards) std::reverse(drawn.begin(), drawn.end());
    const auto points = WallSurface<2>(path_keys(drawn)).rows(spacing, 0.5, 3);
    int beside_the_bend = 0;
    for (const auto& point : points) {
      const double beyond = point.position.norm() - radius, off = (point.row + 0.5) * spacing;
      if (point.position[1] > -4e-3 || point.position[0] < 4e-3) continue;
      EXPECT_NEAR(beyond, backwards ? -off : off, 0.05 * spacing);
      ++beside_the_bend;
    }
    EXPECT_GT(beside_the_bend, 140);  // 3 rows of 53
  }
}

TEST(WallSurface, CountsWaysThroughItFromTheSideOfTheParticles) {
  const WallSurface<2> wall(path_keys({{0.0, 5e-3}, {0.0, 0.0}, {8e-3, 0.0}}));
  EXPECT_TRUE(wall.crossed(Vec<2>(4e-3, 1e-4), Vec<2>(4e-3, -1e-4)));
  EXPECT_FALSE(wall.crossed(Vec<2>(4e-3, -1e-4), Vec<2>(4e-3, 1e-4))) << "back";
  EXPECT_FALSE(wall.crossed(Vec<2>(9e-3, 1e-4), Vec<2>(9e-3, -1e-4))) << "beyond the end";
  EXPECT_TRUE(wall.crossed(Vec<2>(1e-4, 2e-4), Vec<2>(-1e-4, -1e-4))) << "at the corner";
}

TEST(WallSurface, SurroundsATankInThreeDimensions) {
  Parameters keys;
  keys.set("min", std::vector<double>{0.0, 0.0, 0.0});
  keys.set("max", std::vector<double>{4e-3, 3e-3, 5e-3});
  keys.set("particles", std::string("inside"));
  keys.set("open", Texts{"+z"});
  const WallSurface<3> tank(keys);
  EXPECT_EQ(tank.facets().size(), 5U);
  const auto points = tank.rows(spacing, 0.5, 3);
  EXPECT_NEAR(nearest_pair(points), spacing, 1e-9);
  EXPECT_TRUE(holds_point<3>(points, Vec<3>(1.5e-3, 1.5e-3, -0.5e-3)));
  EXPECT_TRUE(holds_point<3>(points, Vec<3>(-2.5e-3, -2.5e-3, -2.5e-3)));
  for (const auto& point : points) {
    const Vec<3>& x = point.position;
    const bool inside = x[0] > 0.0 && x[0] < 4e-3 && x[1] > 0.0 && x[1] < 3e-3 && x[2] > 0.0;
    EXPECT_FALSE(inside) << x.transpose();
  }
  EXPECT_TRUE(tank.crossed(Vec<3>(1e-3, 1e-3, 1e-4), Vec<3>(1e-3, 1e-3, -1e-4)));
  EXPECT_FALSE(tank.crossed(Vec<3>(1e-3, 1e-3, 4.9e-3), Vec<3>(1e-3, 1e-3, 5.1e-3))) << "open above";
}

TEST(WallSurface, RefusesWhatIsNoWall) {
  EXPECT_THROW(WallSurface<2>(path_keys({{0.0, 0.0}})), InputError);
  EXPECT_THROW(WallSurface<2>(path_keys({{0.0, 0.0}, {0.0, 0.0}})), InputError);
  EXPECT_THROW(WallSurface<2>(path_keys({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}})), InputError);
  EXPECT_THROW(WallSurface<3>(path_keys({{0.0, 0.0}, {1.0, 0.0}})), InputError);
}

template <class Law>
void expect_force_is_slope_of_energy(const Law& law) {
  for (const double part : {0.1, 0.3, 0.6, 0.9, 0.99}) {
    const double r = part * law.reach(), step = 1e-5 * r, volume = 1e-6, density = 1000.0;
    const double slope = (law.energy(r + step, volume, density) - law.energy(r - step, volume, density)) / (2.0 * step);
    EXPECT_NEAR(-slope, law.acceleration(r, volume, density),
                1e-7 * law.acceleration(0.1 * law.reach(), volume, density))
        << part;
    EXPECT_GT(law.acceleration(r, volume, density), 0.0) << "a wall repels";
  }
  EXPECT_NEAR(law.energy(law.reach(), 1e-6, 1000.0), 0.0, 1e-12);
  EXPECT_NEAR(law.acceleration(law.reach(), 1e-6, 1000.0), 0.0, 1e-12);
}

TEST(WallLaws, ForcesAreTheSlopesOfTheirEnergies) {
  expect_force_is_slope_of_energy(PeridynamicForce(2, 1e6, spacing, 0.7, 0.9 * spacing));
  expect_force_is_slope_of_energy(PeridynamicForce(3, 1e6, spacing, 0.7, 0.9 * spacing));
  expect_force_is_slope_of_energy(MonaghanRepulsion(4.0, spacing));
}

/// Energy equivalence of the bond force: under uniform dilation s the bonds of a point store as much as an elastic
/// solid, in plane strain with nu = 1/4, (1/2) c0 integral (1 - q^2)^2 s^2 r / 2 dV = 1/2 (K + G/3) (2 s)^2 with G = 3
/// K/5.
TEST(WallLaws, TheMicromodulusStoresTheEnergyOfASolid) {
  const double modulus = 2e6, horizon = 3e-3;
  const double c0 = PeridynamicForce::micromodulus(2, modulus, horizon);
  double integral = 0.0;  // of (1 - q^2)^2 r over the disc
  const int parts = 20000;
  for (int k = 0; k < parts; ++k) {
    const double q = (k + 0.5) / parts, factor = 1.0 - q * q;
    integral += factor * factor * 2.0 * std::numbers::pi * q * q * horizon * horizon * horizon / parts;
  }
  EXPECT_NEAR(0.25 * c0 * integral, 2.0 * (modulus + 0.2 * modulus), 1e-4 * modulus);
}

/// Midway between two dummies one reach apart: 1.79 times the speed of sound.
TEST(WallLaws, TheBarrierMidwayBetweenTwoDummies) {
  const double modulus = 1.176e6, density = 1000.0, sound = std::sqrt(modulus / density);
  const PeridynamicForce law(2, modulus, spacing, 1.0, spacing);
  const double barrier = 2.0 * law.energy(0.5 * spacing, spacing * spacing, density);
  EXPECT_NEAR(std::sqrt(2.0 * barrier) / sound, 1.79, 0.005);
}

}  // namespace
}  // namespace anvil
