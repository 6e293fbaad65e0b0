// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/terms/viscosity.hpp"

#include "unit/terms/term_cloud.hpp"

namespace anvil {
namespace {

constexpr ViscosityCoefficients coefficients{.linear = 0.7, .quadratic = 1.3, .softening = 0.1};

template <int D>
double scalar_pi(Cloud<D>& cloud, std::size_t i, std::size_t j) {
  const auto pair = cloud.pair(i, j);
  const double approach = pair.v.dot(pair.x);
  if (approach >= 0.0) return 0.0;
  const double mu = pair.h * approach / (pair.x.squaredNorm() + coefficients.softening * pair.h * pair.h);
  const double sound_speed = 0.5 * (cloud.sound_speed[i] + cloud.sound_speed[j]);
  const double density = 0.5 * (cloud.scalar(field::density, i) + cloud.scalar(field::density, j));
  return (-coefficients.linear * sound_speed * mu + coefficients.quadratic * mu * mu) / density;
}

template <class T>
class ViscosityIn : public InEachDimension<T> {};
TYPED_TEST_SUITE(ViscosityIn, Dimensions);

TYPED_TEST(ViscosityIn, EqualsAScalarLoop) {
  constexpr int D = TypeParam::value;
  Cloud<D> cloud;
  const auto forces = forces_of<D>(Viscosity<D>(coefficients), cloud);
  for (std::size_t i = 0; i < cloud.count; ++i) {
    ScalarSum<Vec<D>> acceleration;
    double loss = 0.0, loss_magnitude = 0.0;
    for (std::size_t j = 0; j < cloud.count; ++j) {
      if (i == j) continue;
      const auto pair = cloud.pair(i, j);
      const double strength = cloud.scalar(field::mass, j) * scalar_pi(cloud, i, j);
      acceleration.add(-strength * pair.gradient);
      loss += 0.5 * strength * pair.v.dot(pair.gradient);
      loss_magnitude += 0.5 * strength * pair.v.norm() * pair.gradient.norm();
    }
    EXPECT_NEAR((forces.acceleration[i] - acceleration.value).norm(), 0.0, round_off * acceleration.magnitude);
    EXPECT_NEAR(forces.loss[i], loss, round_off * loss_magnitude);
  }
}

TYPED_TEST(ViscosityIn, ActsOnApproachingPairsOnly) {
  constexpr int D = TypeParam::value;
  Cloud<D> cloud;
  for (std::size_t i = 0; i < cloud.count; ++i) cloud.velocity()[i] = 1000.0 * cloud.position()[i];
  cloud.pack();
  for (const auto& acceleration : forces_of<D>(Viscosity<D>(coefficients), cloud).acceleration)
    EXPECT_EQ(acceleration.norm(), 0.0);
}

TYPED_TEST(ViscosityIn, PushesApproachingPairsApart) {
  constexpr int D = TypeParam::value;
  // Along the last axis, so that in 2D and 3D the first component of the pair's gradient is zero.
  Cloud<D> cloud(CubicSpline(),
                 {Vec<D>::Zero(), Vec<D>(1e-3 * Vec<D>::Unit(D - 1)), Vec<D>::Constant(1.0), Vec<D>::Constant(2.0),
                  Vec<D>::Constant(3.0), Vec<D>::Constant(4.0), Vec<D>::Constant(5.0), Vec<D>::Constant(6.0),
                  Vec<D>::Constant(7.0), Vec<D>::Constant(8.0), Vec<D>::Constant(9.0), Vec<D>::Constant(10.0),
                  Vec<D>::Constant(11.0), Vec<D>::Constant(12.0)});
  cloud.velocity()[0] = 10.0 * Vec<D>::Unit(D - 1);
  cloud.velocity()[1] = -10.0 * Vec<D>::Unit(D - 1);
  cloud.pack();
  const auto forces = forces_of<D>(Viscosity<D>(coefficients), cloud);
  EXPECT_LT(forces.acceleration[0][D - 1], 0.0);
  EXPECT_GT(forces.acceleration[1][D - 1], 0.0);
  EXPECT_EQ(forces.acceleration[2].norm(), 0.0);
}

TYPED_TEST(ViscosityIn, TurnsIntoHeatWhatItTakesFromMotion) {
  constexpr int D = TypeParam::value;
  Cloud<D> cloud;
  const auto forces = forces_of<D>(Viscosity<D>(coefficients), cloud);
  double power = 0.0, heat = 0.0;
  for (std::size_t i = 0; i < cloud.count; ++i) {
    EXPECT_GE(forces.loss[i], 0.0);
    power += cloud.scalar(field::mass, i) * cloud.velocity()[i].dot(forces.acceleration[i]);
    heat += cloud.scalar(field::mass, i) * forces.loss[i];
  }
  EXPECT_LT(power, 0.0);
  EXPECT_NEAR(power, -heat, 10.0 * round_off * heat);
}

TYPED_TEST(ViscosityIn, KeepsMomentumAndAngularMomentum) {
  constexpr int D = TypeParam::value;
  Cloud<D> cloud;
  const auto acceleration = forces_of<D>(Viscosity<D>(coefficients), cloud).acceleration;
  const auto linear = momentum_of(cloud, acceleration);
  EXPECT_NEAR(linear.value.norm(), 0.0, round_off * linear.magnitude);
  const auto angular = angular_momentum_of(cloud, acceleration);
  EXPECT_NEAR(angular.value.norm(), 0.0, round_off * angular.magnitude);
}

TYPED_TEST(ViscosityIn, DoesNotNoticeAMovingFrame) {
  constexpr int D = TypeParam::value;
  Cloud<D> cloud;
  const Viscosity<D> term(coefficients);
  const auto before = forces_of<D>(term, cloud);
  board_a_train(cloud);
  const auto after = forces_of<D>(term, cloud);
  double scale = 0.0;
  for (const auto& acceleration : before.acceleration) scale = std::max(scale, acceleration.norm());
  // Velocities of 600 m/s are rounded to 1e-13 m/s: 1e-15 of their differences.
  for (std::size_t i = 0; i < cloud.count; ++i)
    EXPECT_NEAR((after.acceleration[i] - before.acceleration[i]).norm(), 0.0, 1e-13 * scale);
}

}  // namespace
}  // namespace anvil
