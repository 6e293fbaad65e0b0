// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/terms/non_affine_damping.hpp"

#include "anvil/total_lagrangian/deformation.hpp"
#include "unit/terms/term_cloud.hpp"

namespace anvil {
namespace {

constexpr double coefficient = 0.2;

template <int D>
struct DampedCloud : Cloud<D> {
  DampedCloud() : term(this->fields, coefficient) { this->records.slope.resize(this->count); }
  Eigen::Map<Square<D>> gradient(std::size_t i) {
    return Eigen::Map<Square<D>>(this->fields.template vector<D * D>(field::velocity_gradient).raw() + i * D * D);
  }
  void set_random_gradients() {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (std::size_t i = 0; i < this->count; ++i)
      for (double& component : gradient(i).reshaped()) component = 1e4 * unit(random);
  }
  NonAffineDamping<D> term;
};

template <class T>
class NonAffineDampingIn : public InEachDimension<T> {};
TYPED_TEST_SUITE(NonAffineDampingIn, Dimensions);

TYPED_TEST(NonAffineDampingIn, IsTheSumOverItsPairs) {
  constexpr int D = TypeParam::value;
  DampedCloud<D> cloud;
  cloud.set_random_gradients();
  const auto forces = forces_of<D>(cloud.term, cloud);
  int approaching = 0, parting = 0;
  for (std::size_t i = 0; i < cloud.count; ++i) {
    ScalarSum<Vec<D>> wanted;
    for (std::size_t j = 0; j < cloud.count; ++j) {
      if (i == j) continue;
      const ScalarPair<D> pair = cloud.pair(i, j);
      if (pair.gradient.isZero(0.0)) continue;
      const Vec<D> explained = 0.5 * (cloud.gradient(i) + cloud.gradient(j)) * pair.x;
      const double mu = pair.h * (pair.v - explained).dot(pair.x) / (pair.x.squaredNorm() + 0.01 * pair.h * pair.h);
      const double sound = 0.5 * (cloud.sound_speed[i] + cloud.sound_speed[j]);
      const double density = 0.5 * (cloud.scalar(field::density, i) + cloud.scalar(field::density, j));
      wanted.add(cloud.scalar(field::mass, j) * coefficient * sound * mu / density * pair.gradient);
      ++(mu < 0.0 ? approaching : parting);
    }
    EXPECT_LE((forces.acceleration[i] - wanted.value).norm(), round_off * 10.0 * wanted.magnitude) << i;
  }
  EXPECT_GT(approaching, 0);
  EXPECT_GT(parting, 0);
}

TYPED_TEST(NonAffineDampingIn, KeepsMomentaAndCountsWhatTheMotionLoses) {
  constexpr int D = TypeParam::value;
  DampedCloud<D> cloud;
  cloud.set_random_gradients();
  const auto forces = forces_of<D>(cloud.term, cloud);
  const auto linear = momentum_of<D>(cloud, forces.acceleration);
  const auto angular = angular_momentum_of<D>(cloud, forces.acceleration);
  EXPECT_LT(linear.value.norm(), round_off * linear.magnitude);
  EXPECT_LE(angular.value.norm(), round_off * angular.magnitude);
  double power = 0.0, loss = 0.0, magnitude = 0.0;
  for (std::size_t i = 0; i < cloud.count; ++i) {
    const double part = cloud.scalar(field::mass, i) * forces.acceleration[i].dot(cloud.velocity()[i]);
    power += part;
    magnitude += std::abs(part);
    loss += cloud.scalar(field::mass, i) * forces.loss[i];
  }
  EXPECT_NEAR(-power, loss, 1e-12 * magnitude);
}

TYPED_TEST(NonAffineDampingIn, SlowsWhatNoGradientExplains) {
  constexpr int D = TypeParam::value;
  DampedCloud<D> cloud;  // random velocities, gradients of zero
  double loss = 0.0;
  const auto forces = forces_of<D>(cloud.term, cloud);
  for (std::size_t i = 0; i < cloud.count; ++i) loss += cloud.scalar(field::mass, i) * forces.loss[i];
  EXPECT_GT(loss, 0.0);
}

TYPED_TEST(NonAffineDampingIn, FeelsNothingOfAnEvenFlow) {
  constexpr int D = TypeParam::value;
  DampedCloud<D> cloud;
  const Mat<D> rate = Mat<D>::Constant(3e4) - 5e4 * Mat<D>::Identity();
  for (std::size_t i = 0; i < cloud.count; ++i) {
    cloud.velocity()[i] = rate * cloud.position()[i];
    cloud.gradient(i) = rate;
  }
  cloud.pack();
  // A viscosity on all of the approach, of 50 m/s at a spacing, would give 1e9 m/s2 and more.
  for (const auto& acceleration : forces_of<D>(cloud.term, cloud).acceleration) EXPECT_LT(acceleration.norm(), 1.0);
}

}  // namespace
}  // namespace anvil
