// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/terms/adjoint_momentum.hpp"

#include "unit/terms/term_cloud.hpp"

namespace anvil {
namespace {

/// Each particle has a correction of its own, which the term has to take.
template <int D>
struct CorrectedCloud : Cloud<D> {
  CorrectedCloud() : term(this->fields) {
    this->records.nominal.resize(this->count);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-0.3, 0.3);
    for (std::size_t i = 0; i < this->count; ++i)
      for (int c = 0; c < symmetric_components<D>; ++c) correction(i)[c] = (c < D ? 1.0 : 0.0) + unit(random);
  }
  double* correction(std::size_t i) {
    return this->fields.template vector<symmetric_components<D>>(field::gradient_correction).raw() +
           i * symmetric_components<D>;
  }
  /// sigma_i B_i.
  Mat<D> corrected_stress(std::size_t i) { return this->stress(i) * symmetric_matrix<D>(correction(i)); }
  AdjointMomentum<D> term;
};

template <class T>
class AdjointMomentumIn : public InEachDimension<T> {};
TYPED_TEST_SUITE(AdjointMomentumIn, Dimensions);

TYPED_TEST(AdjointMomentumIn, EqualsAScalarLoop) {
  constexpr int D = TypeParam::value;
  CorrectedCloud<D> cloud;
  const auto forces = forces_of<D>(cloud.term, cloud);
  for (std::size_t i = 0; i < cloud.count; ++i) {
    ScalarSum<Vec<D>> wanted;
    for (std::size_t j = 0; j < cloud.count; ++j)
      if (i != j)
        wanted.add(cloud.volume(j) / cloud.scalar(field::density, i) *
                   (cloud.corrected_stress(i) + cloud.corrected_stress(j)) * cloud.pair(i, j).gradient);
    EXPECT_LE((forces.acceleration[i] - wanted.value).norm(), round_off * wanted.magnitude) << i;
  }
}

TYPED_TEST(AdjointMomentumIn, AddsToWhatOtherTermsWrote) {
  constexpr int D = TypeParam::value;
  CorrectedCloud<D> cloud;
  const auto once = forces_of<D>(cloud.term, cloud);
  std::vector<Vec<D>> twice = once.acceleration;
  std::vector<double> loss(cloud.count, 0.0);
  for (const auto& [begin, end] : {std::pair<std::size_t, std::size_t>{0, 13}, {13, cloud.count}})
    cloud.term.accumulate(cloud.tile(begin, end), cloud.records, twice[begin].data(), &loss[begin]);
  for (std::size_t i = 0; i < cloud.count; ++i) EXPECT_EQ(twice[i], 2.0 * once.acceleration[i]);
}

// What the forces take from the motion is what the corrected velocity gradient L_i strains the particles with:
// sum_i m_i a_i . v_i = -sum_i V_i sigma_i : L_i with L_i = sum_j V_j (v_j - v_i) (x) B_i grad_ij.
TYPED_TEST(AdjointMomentumIn, TakesFromTheMotionWhatStrainsTheParticles) {
  constexpr int D = TypeParam::value;
  CorrectedCloud<D> cloud;
  const auto forces = forces_of<D>(cloud.term, cloud);
  double power = 0.0, strain_power = 0.0, magnitude = 0.0;
  for (std::size_t i = 0; i < cloud.count; ++i) {
    power += cloud.scalar(field::mass, i) * forces.acceleration[i].dot(cloud.velocity()[i]);
    for (std::size_t j = 0; j < cloud.count; ++j) {
      if (i == j) continue;
      const Vec<D> jump = cloud.velocity()[j] - cloud.velocity()[i];
      const double part =
          cloud.volume(i) * cloud.volume(j) * jump.dot(cloud.corrected_stress(i) * cloud.pair(i, j).gradient);
      strain_power += part;
      magnitude += std::abs(part);
    }
  }
  EXPECT_NEAR(power, -strain_power, round_off * magnitude);
}

TYPED_TEST(AdjointMomentumIn, SumsToZero) {
  constexpr int D = TypeParam::value;
  CorrectedCloud<D> cloud;
  const auto sum = momentum_of(cloud, forces_of<D>(cloud.term, cloud).acceleration);
  EXPECT_LE(sum.value.norm(), round_off * sum.magnitude);
}

}  // namespace
}  // namespace anvil
