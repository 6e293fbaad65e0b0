// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/terms/hllc.hpp"

#include <random>

#include "anvil/terms/hllc_star.hpp"
#include "unit/terms/term_cloud.hpp"

namespace anvil {
namespace {

Strength steel() {
  Parameters keys;
  keys.set("shear_modulus", 27.6e9);
  keys.set("yield_stress", 2e9);  // beyond most of the cloud's stresses
  keys.set("hardening_modulus", 0.0);
  keys.set("isotropic_fraction", 1.0);
  return make_strength({"j2", keys});
}

/// The cloud with the term's fields, filled, and its records.
template <int D>
struct HllcCloud {
  explicit HllcCloud(const HllcChoices& choices)
      : strength(make_strength_update<D>(steel(), cloud.fields)),
        term(cloud.fields, {{{0, static_cast<std::int32_t>(cloud.count)}, strength.get()}}, choices) {
    if (choices.gradient == PairGradient::symmetrised) fill_corrections();
    pack();
  }

  /// Symmetric and near the unit matrix, another one for every particle.
  void fill_corrections() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-0.2, 0.2);
    const auto packed = cloud.fields.template vector<symmetric_components<D>>(field::gradient_correction);
    for (std::size_t i = 0; i < cloud.count; ++i)
      for (int c = 0; c < symmetric_components<D>; ++c) packed[i][c] = (c < D ? 1.0 : 0.0) + unit(random);
  }
  [[nodiscard]] Mat<D> correction(std::size_t i) {
    return symmetric_matrix<D>(
        cloud.fields.template vector<symmetric_components<D>>(field::gradient_correction)[i].data());
  }

  void pack() {
    cloud.pack();
    cloud.records.response.resize(cloud.count);
    cloud.records.slope.resize(cloud.count);
    cloud.records.correction.resize(cloud.count);
    for (const int field : {response_density, response_elastic_speed, response_plastic_speed})
      cloud.records.response[cloud.count][field] = 1.0;
  }

  Forces<D> forces() { return forces_of<D>(term, cloud); }
  [[nodiscard]] Eigen::Map<const Vec<D * D>> star_gradient(std::size_t i) {
    return Eigen::Map<const Vec<D * D>>(cloud.fields.template vector<D * D>(field::star_gradient).raw() + i * D * D);
  }

  Cloud<D> cloud;
  std::unique_ptr<StrengthUpdate<D>> strength;
  Hllc<D> term;
};

template <class T>
class HllcIn : public InEachDimension<T> {};
TYPED_TEST_SUITE(HllcIn, Dimensions);

/// The side of particle i in a Riemann problem along n, from the fields.
template <int D>
RiemannSide<double> side_of(HllcCloud<D>& hllc, std::size_t i, const Vec<D>& n) {
  Cloud<D>& cloud = hllc.cloud;
  const double shear = 4.0 / 3.0 * 27.6e9, density = cloud.scalar(field::density, i), speed = cloud.sound_speed[i];
  const double stress = n.dot(cloud.stress(i) * n);
  return {.velocity = n.dot(Vec<D>(cloud.velocity()[i])),
          .stress = stress,
          .deviator = stress + cloud.scalar(field::pressure, i),
          .density = density,
          .elastic_speed = std::sqrt(speed * speed + shear / density),
          .plastic_speed = speed,
          .inverse_elastic_speed = 1.0 / std::sqrt(speed * speed + shear / density),
          .inverse_shear = 1.0 / shear,
          .limit = 2.0 / 3.0 * 2e9};
}

template <int D>
void expect_scalar_loop(PairGradient gradient_of_pairs) {
  HllcCloud<D> hllc({.gradient = gradient_of_pairs, .reconstructs = false});
  Cloud<D>& cloud = hllc.cloud;
  const auto forces = hllc.forces();
  for (std::size_t i = 0; i < cloud.count; ++i) {
    ScalarSum<Vec<D>> acceleration;
    ScalarSum<Mat<D>> gradient;
    double power = 0.0, power_magnitude = 0.0;
    for (std::size_t j = 0; j < cloud.count; ++j) {
      if (i == j) continue;
      const auto pair = cloud.pair(i, j);
      const Vec<D> n = -pair.x.normalized();
      Mat<D> stress = 0.5 * (cloud.stress(i) + cloud.stress(j));
      const Vec<D> mean = 0.5 * (cloud.velocity()[i] + cloud.velocity()[j]);
      Vec<D> velocity = mean;
      if (pair.v.dot(n) > 0.0) {
        const auto star = hllc_star(side_of<D>(hllc, i, n), side_of<D>(hllc, j, n));
        stress += (star.stress - n.dot(stress * n)) * n * n.transpose();
        velocity += (star.velocity - n.dot(velocity)) * n;
      }
      Vec<D> weight = 2.0 * cloud.volume(j) * pair.gradient;
      if (gradient_of_pairs == PairGradient::symmetrised)
        weight = 0.5 * (hllc.correction(i) + hllc.correction(j)) * weight;
      const Vec<D> force = stress * weight / cloud.scalar(field::density, i);
      acceleration.add(force);
      gradient.add((velocity - mean) * weight.transpose());
      power += velocity.dot(force);
      power_magnitude += velocity.norm() * force.norm();
    }
    EXPECT_NEAR((forces.acceleration[i] - acceleration.value).norm(), 0.0, 10.0 * round_off * acceleration.magnitude);
    EXPECT_NEAR(forces.loss[i], power, 10.0 * round_off * power_magnitude);
    const Eigen::Map<const Eigen::Matrix<double, D, D, D == 1 ? Eigen::ColMajor : Eigen::RowMajor>> star(
        hllc.star_gradient(i).data());
    EXPECT_NEAR((star - gradient.value).norm(), 0.0, 1e-11 * gradient.magnitude + 1e-6);  // a difference of velocities
  }
}

TYPED_TEST(HllcIn, EqualsAScalarLoop) {
  expect_scalar_loop<TypeParam::value>(PairGradient::plain);
  expect_scalar_loop<TypeParam::value>(PairGradient::symmetrised);
}

/// With gradients alike for both sides the forces of a pair are opposite and both sides see the same velocity: what one
/// side gains in momentum and energy the other loses.
TYPED_TEST(HllcIn, KeepsMomentumAndEnergy) {
  constexpr int D = TypeParam::value;
  for (const HllcChoices choices : {HllcChoices{PairGradient::plain, false}, HllcChoices{PairGradient::plain, true},
                                    HllcChoices{PairGradient::symmetrised, true}}) {
    HllcCloud<D> hllc(choices);
    const auto forces = hllc.forces();
    const auto momentum = momentum_of(hllc.cloud, forces.acceleration);
    EXPECT_NEAR(momentum.value.norm(), 0.0, 10.0 * round_off * momentum.magnitude);
    double energy = 0.0, magnitude = 0.0;
    for (std::size_t i = 0; i < hllc.cloud.count; ++i) {
      energy += hllc.cloud.scalar(field::mass, i) * forces.loss[i];
      magnitude += hllc.cloud.scalar(field::mass, i) * std::abs(forces.loss[i]);
    }
    EXPECT_GT(magnitude, 0.0);
    EXPECT_NEAR(energy, 0.0, 10.0 * round_off * magnitude);
  }
}

TYPED_TEST(HllcIn, LeavesPartingPairsToTheMean) {
  constexpr int D = TypeParam::value;
  HllcCloud<D> hllc({.reconstructs = true});
  for (std::size_t i = 0; i < hllc.cloud.count; ++i) hllc.cloud.velocity()[i] = 1000.0 * hllc.cloud.position()[i];
  hllc.pack();
  const auto forces = hllc.forces();
  const auto mean = forces_of<D>(Momentum<D>(hllc.cloud.fields, MomentumForm::sum), hllc.cloud);
  for (std::size_t i = 0; i < hllc.cloud.count; ++i) {
    EXPECT_NEAR((forces.acceleration[i] - mean.acceleration[i]).norm(), 0.0, 1e-11 * mean.acceleration[i].norm());
    EXPECT_EQ(hllc.star_gradient(i).norm(), 0.0);
  }
}

/// Approaching pairs of equal stress: the star compresses more than the mean, which pushes them apart, and less slowly
/// than it heats.
TYPED_TEST(HllcIn, TurnsIntoHeatWhatItTakesFromMotion) {
  constexpr int D = TypeParam::value;
  HllcCloud<D> hllc({.reconstructs = false});
  const auto forces = hllc.forces();
  const auto mean = forces_of<D>(Momentum<D>(hllc.cloud.fields, MomentumForm::sum), hllc.cloud);
  double power = 0.0;
  for (std::size_t i = 0; i < hllc.cloud.count; ++i)
    power +=
        hllc.cloud.scalar(field::mass, i) * hllc.cloud.velocity()[i].dot(forces.acceleration[i] - mean.acceleration[i]);
  EXPECT_LT(power, 0.0);
}

/// A linear velocity and a linear stress have the same value at the middle of a pair from both sides: nothing is left
/// to a shock.
TYPED_TEST(HllcIn, ReconstructsLinearFields) {
  constexpr int D = TypeParam::value;
  HllcCloud<D> hllc({.reconstructs = true});
  Cloud<D>& cloud = hllc.cloud;
  const Vec<D> slope = Vec<D>::LinSpaced(D, 1e12, 2e12);  // Pa/m, of a tension that is the same in all directions
  const auto gradients = cloud.fields.template vector<D * D>(field::velocity_gradient);
  const auto accelerations = cloud.fields.template vector<D>(field::pair_acceleration);
  for (std::size_t i = 0; i < cloud.count; ++i) {
    cloud.velocity()[i] = -1000.0 * cloud.position()[i];
    cloud.sound_speed[i] = 5000.0;
    cloud.fields.scalar(field::density)[i] = 8000.0;
    cloud.fields.scalar(field::pressure)[i] = -slope.dot(Vec<D>(cloud.position()[i]));
    std::fill_n(cloud.deviator(i), Cloud<D>::components, 0.0);
    for (int a = 0; a < D; ++a) gradients[i][a * (D + 1)] = -1000.0;
    accelerations[i] = slope / 8000.0;
  }
  hllc.pack();
  const auto forces = hllc.forces();
  const auto mean = forces_of<D>(Momentum<D>(cloud.fields, MomentumForm::sum), cloud);
  double scale = 0.0;
  for (const auto& acceleration : mean.acceleration) scale = std::max(scale, acceleration.norm());
  for (std::size_t i = 0; i < cloud.count; ++i)
    EXPECT_NEAR((forces.acceleration[i] - mean.acceleration[i]).norm(), 0.0, 1e-9 * scale);
}

TYPED_TEST(HllcIn, DoesNotNoticeAMovingFrame) {
  constexpr int D = TypeParam::value;
  HllcCloud<D> hllc({.reconstructs = true});
  const auto before = hllc.forces();
  std::vector<double> heat;
  for (std::size_t i = 0; i < hllc.cloud.count; ++i)
    heat.push_back(before.loss[i] - before.acceleration[i].dot(Vec<D>(hllc.cloud.velocity()[i])));
  const auto slopes = hllc.cloud.fields.template vector<D>(field::pair_acceleration);
  for (std::size_t i = 0; i < hllc.cloud.count; ++i) slopes[i].setZero();  // as they were before
  board_a_train(hllc.cloud);
  hllc.pack();
  const auto after = hllc.forces();
  double scale = 0.0;
  for (const auto& acceleration : before.acceleration) scale = std::max(scale, acceleration.norm());
  for (std::size_t i = 0; i < hllc.cloud.count; ++i) {
    EXPECT_NEAR((after.acceleration[i] - before.acceleration[i]).norm(), 0.0, 1e-12 * scale);
    EXPECT_NEAR(after.loss[i] - after.acceleration[i].dot(Vec<D>(hllc.cloud.velocity()[i])), heat[i],
                1e-12 * scale * 600.0);
  }
}

}  // namespace
}  // namespace anvil
