// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/terms/momentum.hpp"

#include "unit/terms/term_cloud.hpp"

namespace anvil {
namespace {

// The forms that conserve momentum.
constexpr MomentumForm forms[] = {MomentumForm::sum, MomentumForm::density_squared};

template <int D>
ScalarSum<Vec<D>> scalar_acceleration(Cloud<D>& cloud, MomentumForm form, std::size_t i) {
  ScalarSum<Vec<D>> sum;
  const double rho_i = cloud.scalar(field::density, i);
  for (std::size_t j = 0; j < cloud.count; ++j) {
    if (i == j) continue;
    const double rho_j = cloud.scalar(field::density, j);
    const Vec<D> grad_ij = cloud.pair(i, j).gradient;
    if (form == MomentumForm::difference)
      sum.add(cloud.volume(j) / rho_i * (cloud.stress(j) - cloud.stress(i)) * grad_ij);
    else if (form == MomentumForm::sum)
      sum.add(cloud.volume(j) / rho_i * (cloud.stress(i) + cloud.stress(j)) * grad_ij);
    else
      sum.add(cloud.scalar(field::mass, j) * (cloud.stress(i) / (rho_i * rho_i) + cloud.stress(j) / (rho_j * rho_j)) *
              grad_ij);
  }
  return sum;
}

template <class T>
class MomentumIn : public InEachDimension<T> {};
TYPED_TEST_SUITE(MomentumIn, Dimensions);

TYPED_TEST(MomentumIn, EqualsAScalarLoop) {
  constexpr int D = TypeParam::value;
  for (const auto form : {MomentumForm::sum, MomentumForm::density_squared, MomentumForm::difference}) {
    Cloud<D> cloud;
    const auto forces = forces_of<D>(Momentum<D>(cloud.fields, form), cloud);
    for (std::size_t i = 0; i < cloud.count; ++i) {
      const auto expected = scalar_acceleration(cloud, form, i);
      EXPECT_NEAR((forces.acceleration[i] - expected.value).norm(), 0.0, round_off * expected.magnitude);
    }
  }
}

TYPED_TEST(MomentumIn, AddsToWhatOtherTermsWrote) {
  constexpr int D = TypeParam::value;
  Cloud<D> cloud;
  const Momentum<D> term(cloud.fields, MomentumForm::sum);
  const auto once = forces_of<D>(term, cloud);
  std::vector<Vec<D>> twice = once.acceleration;
  std::vector<double> loss(cloud.count, 0.0);
  term.accumulate(cloud.tile(), cloud.records, twice[0].data(), loss.data());
  for (std::size_t i = 0; i < cloud.count; ++i) EXPECT_EQ(twice[i], 2.0 * once.acceleration[i]);
}

TYPED_TEST(MomentumIn, SumsToZero) {
  constexpr int D = TypeParam::value;
  for (const auto form : forms) {
    Cloud<D> cloud;
    const auto sum = momentum_of(cloud, forces_of<D>(Momentum<D>(cloud.fields, form), cloud).acceleration);
    EXPECT_NEAR(sum.value.norm(), 0.0, round_off * sum.magnitude);
  }
}

// Only a pair force along the line between the two keeps angular momentum: pressure acts so, shear does not.
TYPED_TEST(MomentumIn, KeepsAngularMomentumUnderPressureAlone) {
  constexpr int D = TypeParam::value;
  if constexpr (D > 1) {
    for (const auto form : forms) {
      Cloud<D> cloud;
      for (std::size_t i = 0; i < cloud.count; ++i) std::fill_n(cloud.deviator(i), cloud.components, 0.0);
      const auto sum = angular_momentum_of(cloud, forces_of<D>(Momentum<D>(cloud.fields, form), cloud).acceleration);
      EXPECT_NEAR(sum.value.norm(), 0.0, round_off * sum.magnitude);
    }
  }
}

TYPED_TEST(MomentumIn, FollowsATranslation) {
  constexpr int D = TypeParam::value;
  Cloud<D> cloud;
  const Momentum<D> term(cloud.fields, MomentumForm::sum);
  const auto before = forces_of<D>(term, cloud).acceleration;
  for (std::size_t i = 0; i < cloud.count; ++i) cloud.position()[i] += Vec<D>::Constant(0.0625);
  cloud.pack();
  const auto after = forces_of<D>(term, cloud).acceleration;
  // Positions of 0.06 m are rounded to 1e-17 m: 1e-14 of a spacing, which the curvature of the kernel multiplies.
  for (std::size_t i = 0; i < cloud.count; ++i)
    EXPECT_NEAR((after[i] - before[i]).norm(), 0.0, 1e-12 * scalar_acceleration(cloud, MomentumForm::sum, i).magnitude);
}

// The pair of discrete operators behind the energy balance: what the stresses do to the velocities is what they do to
// the strain, sum_i m_i v_i . a_i = -sum_i V_i sigma_i : grad v_i.
TYPED_TEST(MomentumIn, SumFormIsAdjointToTheVelocityGradient) {
  constexpr int D = TypeParam::value;
  Cloud<D> cloud;
  const auto forces = forces_of<D>(Momentum<D>(cloud.fields, MomentumForm::sum), cloud);
  std::vector<double> gradient(cloud.count * D * D);
  pair_loops<D>().velocity_gradient(cloud.tile(), cloud.records, gradient.data());
  double power = 0.0, strain_power = 0.0, magnitude = 0.0;
  for (std::size_t i = 0; i < cloud.count; ++i) {
    const double part = cloud.scalar(field::mass, i) * cloud.velocity()[i].dot(forces.acceleration[i]);
    const Eigen::Map<const Eigen::Matrix<double, D, D, D == 1 ? Eigen::ColMajor : Eigen::RowMajor>> grad_v(
        &gradient[i * D * D]);
    strain_power += cloud.volume(i) * cloud.stress(i).cwiseProduct(grad_v).sum();
    power += part;
    magnitude += std::abs(part);
  }
  EXPECT_NEAR(power, -strain_power, round_off * magnitude);
  EXPECT_GT(std::abs(power), 1e-3 * magnitude);
}

// Drops of a spray: pressure alone, and every second particle a fifth as dense as the others. What the motion loses is
// what the rates of density store, sum_i m_i p_i/rho_i^2 drho_i/dt with drho_i/dt = rho_i sum_j V_j v_ij . grad_ij. The
// form with squared densities is adjoint to another rate, and misses this one by more than a tenth.
TYPED_TEST(MomentumIn, SumFormStoresInDropsWhatItTakesFromTheirMotion) {
  constexpr int D = TypeParam::value;
  const auto unstored = [](MomentumForm form) {
    Cloud<D> cloud;
    for (std::size_t i = 0; i < cloud.count; ++i) {
      std::fill_n(cloud.deviator(i), cloud.components, 0.0);
      cloud.fields.scalar(field::pressure)[i] = std::abs(cloud.scalar(field::pressure, i));
      if (i % 2 == 1) cloud.fields.scalar(field::density)[i] /= 5.0;
    }
    cloud.pack();
    const auto forces = forces_of<D>(Momentum<D>(cloud.fields, form), cloud);
    double power = 0.0, stored = 0.0, magnitude = 0.0;
    for (std::size_t i = 0; i < cloud.count; ++i) {
      power += cloud.scalar(field::mass, i) * cloud.velocity()[i].dot(forces.acceleration[i]);
      for (std::size_t j = 0; j < cloud.count; ++j) {
        if (i == j) continue;
        const auto pair = cloud.pair(i, j);
        const double part =
            cloud.volume(i) * cloud.scalar(field::pressure, i) * cloud.volume(j) * pair.v.dot(pair.gradient);
        stored += part;
        magnitude += std::abs(part);
      }
    }
    EXPECT_GT(std::abs(stored), 1e-3 * magnitude);
    return std::pair(std::abs(power + stored) / magnitude, std::abs(power + stored) / std::abs(stored));
  };
  EXPECT_LE(unstored(MomentumForm::sum).first, round_off);
  EXPECT_GT(unstored(MomentumForm::density_squared).second, 0.1);
}

}  // namespace
}  // namespace anvil
