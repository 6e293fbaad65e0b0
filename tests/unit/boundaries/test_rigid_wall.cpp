// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/boundaries/rigid_wall.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

namespace anvil {
namespace {

constexpr double spacing = 1e-3;            // m, of the particles
constexpr double standoff = 0.5 * spacing;  // m, of their centres from the faces of the body
constexpr double time_step = 1e-6;          // s

/// The velocity of one particle after the wall has corrected it.
template <int D>
Vec<D> corrected(const RigidWall<D>& wall, Vec<D> position, Vec<D> velocity) {
  wall.correct_velocities({0, 1}, VectorView<D>(position.data()), VectorView<D>(velocity.data()), standoff, time_step);
  return velocity;
}

TEST(RigidWall, StopsAFaceAtThePlane) {
  const RigidWall<1> wall("wall", Vec<1>(0.0), Vec<1>(1.0), spacing);
  EXPECT_EQ(corrected<1>(wall, Vec<1>(standoff), Vec<1>(-10.0))[0], 0.0);
  EXPECT_EQ(corrected<1>(wall, Vec<1>(0.9 * standoff), Vec<1>(-10.0))[0], 0.0);
}

TEST(RigidWall, NeverPulls) {
  const RigidWall<1> wall("wall", Vec<1>(0.0), Vec<1>(1.0), spacing);
  for (const double gap : {-0.2e-3, 0.0, 1e-9, 1e-3})
    EXPECT_EQ(corrected<1>(wall, Vec<1>(standoff + gap), Vec<1>(10.0))[0], 10.0) << "gap " << gap;
  // Nor does it touch one that comes, but not within this step.
  EXPECT_EQ(corrected<1>(wall, Vec<1>(standoff + 1e-3), Vec<1>(-999.0))[0], -999.0);
}

TEST(RigidWall, LeavesAsMuchApproachAsBringsTheFaceToThePlane) {
  const RigidWall<1> wall("wall", Vec<1>(0.0), Vec<1>(1.0), spacing);
  const double gap = 4e-6;
  // Half the gap's distance per step is not corrected, twice is: to gap / time_step = 4 m/s. The gap is a difference of
  // numbers 100 times as large: 1e-13 of it is lost to rounding.
  EXPECT_EQ(corrected<1>(wall, Vec<1>(standoff + gap), Vec<1>(-2.0))[0], -2.0);
  EXPECT_NEAR(corrected<1>(wall, Vec<1>(standoff + gap), Vec<1>(-8.0))[0], -4.0, 1e-12);
}

TEST(RigidWall, ChangesOnlyThePartOfVelocityAlongAnObliqueNormal) {
  const Vec<3> normal = Vec<3>(1.0, 2.0, -2.0) / 3.0;
  const Vec<3> point(0.1, -0.2, 0.3);
  const RigidWall<3> wall("wall", point, normal, spacing);
  const Vec<3> tangential = normal.cross(Vec<3>(20.0, 5.0, 7.0));
  const Vec<3> after = corrected<3>(wall, point + standoff * normal, tangential - 100.0 * normal);
  // Positions of 0.1 m are rounded to 1e-17 m, which is 1e-11 m/s in a step of 1e-6 s.
  EXPECT_NEAR((after - tangential).norm(), 0.0, 1e-10);
}

TEST(RigidWall, LetsNoFaceOfManyPassAndPushesOnlyAlongTheNormal) {
  const Vec<2> normal(0.6, 0.8), point(1e-3, -2e-3);
  const RigidWall<2> wall("wall", point, normal, spacing);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int pushed = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const double gap = 0.5e-3 * (1.0 + unit(random));
    const Vec<2> position = point + (standoff + gap) * normal + 1e-2 * unit(random) * Vec<2>(-0.8, 0.6);
    const Vec<2> velocity(1000.0 * unit(random), 1000.0 * unit(random));
    const Vec<2> after = corrected<2>(wall, position, velocity);
    const Vec<2> change = after - velocity;
    const double face = normal.dot(position + time_step * after - point) - standoff;
    EXPECT_GE(face, -1e-17);  // m: rounding of positions of 1e-2 m
    EXPECT_GE(normal.dot(change), 0.0);
    EXPECT_NEAR(normal[0] * change[1] - normal[1] * change[0], 0.0, 1e-12);  // of 1000 m/s
    pushed += change.norm() > 0.0 ? 1 : 0;
  }
  EXPECT_GT(pushed, 100);
  EXPECT_LT(pushed, 900);
}

TEST(RigidWall, ForbidsWhatLiesBehindThePlane) {
  const RigidWall<2> wall("wall", Vec<2>(0.0, 1.0), Vec<2>(0.0, 1.0), spacing);
  EXPECT_FALSE(wall.forbids(Vec<2>(5.0, 1.0)));
  EXPECT_FALSE(wall.forbids(Vec<2>(5.0, 1.1)));
  EXPECT_TRUE(wall.forbids(Vec<2>(5.0, 0.9999)));
}

TEST(RigidWall, LetsParticlesStandOnThePlane) {
  const RigidWall<2> wall("wall", Vec<2>(0.0, 1.0), Vec<2>(0.6, 0.8), spacing);
  const Vec<2> on_the_plane = Vec<2>(0.0, 1.0) + 0.3 * Vec<2>(-0.8, 0.6);
  EXPECT_FALSE(wall.forbids(on_the_plane - 1e-15 * Vec<2>(0.6, 0.8)));
  EXPECT_TRUE(wall.forbids(on_the_plane - 2e-9 * Vec<2>(0.6, 0.8)));
}

}  // namespace
}  // namespace anvil
