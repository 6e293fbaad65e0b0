// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/terms/conservative_smoothing.hpp"

#include "unit/terms/term_cloud.hpp"

namespace anvil {
namespace {

constexpr SmoothingForm forms[] = {SmoothingForm::plain, SmoothingForm::pairwise, SmoothingForm::scaled};
constexpr double coefficient = 0.2, reference_step = 2e-8, time_step = 3e-8;

template <int D>
ScalarSum<Vec<D>> scalar_change(Cloud<D>& cloud, SmoothingForm form, std::size_t i) {
  ScalarSum<Vec<D>> sum;
  double weights = 0.0;
  for (std::size_t j = 0; j < cloud.count; ++j) {
    if (i == j) continue;
    const auto pair = cloud.pair(i, j);
    const double densities = cloud.scalar(field::density, i) + cloud.scalar(field::density, j);
    const double weight =
        pair.value * (form == SmoothingForm::plain ? cloud.volume(j) : 2.0 * cloud.scalar(field::mass, j) / densities);
    sum.add(-weight * pair.v);
    weights += weight;
  }
  double strength = coefficient;
  if (form == SmoothingForm::plain) strength /= weights;
  if (form == SmoothingForm::scaled) strength *= time_step / reference_step;
  return {strength * sum.value, strength * sum.magnitude};
}

template <class T>
class ConservativeSmoothingIn : public InEachDimension<T> {};
TYPED_TEST_SUITE(ConservativeSmoothingIn, Dimensions);

TYPED_TEST(ConservativeSmoothingIn, EqualsAScalarLoop) {
  constexpr int D = TypeParam::value;
  for (const auto form : forms) {
    Cloud<D> cloud;
    const auto changes = changes_by<D>(ConservativeSmoothing<D>(form, coefficient, reference_step), cloud, time_step);
    for (std::size_t i = 0; i < cloud.count; ++i) {
      const auto expected = scalar_change(cloud, form, i);
      EXPECT_NEAR((changes[i] - expected.value).norm(), 0.0, round_off * expected.magnitude);
    }
  }
}

TYPED_TEST(ConservativeSmoothingIn, KeepsMomentumInThePairwiseForms) {
  constexpr int D = TypeParam::value;
  for (const auto form : {SmoothingForm::pairwise, SmoothingForm::scaled}) {
    Cloud<D> cloud;
    const ConservativeSmoothing<D> filter(form, coefficient, reference_step);
    const auto sum = momentum_of(cloud, changes_by<D>(filter, cloud, time_step));
    EXPECT_NEAR(sum.value.norm(), 0.0, round_off * sum.magnitude);
  }
}

TYPED_TEST(ConservativeSmoothingIn, TakesEnergyFromMotion) {
  constexpr int D = TypeParam::value;
  for (const auto form : forms) {
    Cloud<D> cloud;
    const auto changes = changes_by<D>(ConservativeSmoothing<D>(form, coefficient, reference_step), cloud, time_step);
    double before = 0.0, after = 0.0;
    for (std::size_t i = 0; i < cloud.count; ++i) {
      before += 0.5 * cloud.scalar(field::mass, i) * cloud.velocity()[i].squaredNorm();
      after += 0.5 * cloud.scalar(field::mass, i) * (cloud.velocity()[i] + changes[i]).squaredNorm();
    }
    EXPECT_LT(after, before);
  }
}

TYPED_TEST(ConservativeSmoothingIn, DoesNotNoticeAMovingFrame) {
  constexpr int D = TypeParam::value;
  for (const auto form : forms) {
    Cloud<D> cloud;
    const ConservativeSmoothing<D> filter(form, coefficient, reference_step);
    const auto before = changes_by<D>(filter, cloud, time_step);
    board_a_train(cloud);
    const auto after = changes_by<D>(filter, cloud, time_step);
    // Of velocity differences of 200 m/s between numbers rounded to 1e-13 m/s.
    for (std::size_t i = 0; i < cloud.count; ++i) EXPECT_NEAR((after[i] - before[i]).norm(), 0.0, 1e-11);
  }
}

TYPED_TEST(ConservativeSmoothingIn, LeavesUniformMotionAloneToTheLastBit) {
  constexpr int D = TypeParam::value;
  for (const auto form : forms) {
    Cloud<D> cloud;
    for (std::size_t i = 0; i < cloud.count; ++i) cloud.velocity()[i] = Vec<D>::Constant(227.1);
    cloud.pack();
    const ConservativeSmoothing<D> filter(form, coefficient, reference_step);
    for (const auto& change : changes_by<D>(filter, cloud, time_step)) EXPECT_EQ(change.norm(), 0.0);
  }
}

TYPED_TEST(ConservativeSmoothingIn, ScaledFormIsBoundedByOneHalf) {
  constexpr int D = TypeParam::value;
  Cloud<D> cloud;
  const auto bounded = changes_by<D>(ConservativeSmoothing<D>(SmoothingForm::scaled, coefficient, reference_step),
                                     cloud, 1000.0 * reference_step);
  const auto half =
      changes_by<D>(ConservativeSmoothing<D>(SmoothingForm::pairwise, 0.5, reference_step), cloud, time_step);
  for (std::size_t i = 0; i < cloud.count; ++i) EXPECT_EQ(bounded[i], half[i]);
}

TYPED_TEST(ConservativeSmoothingIn, LeavesALonelyParticleAlone) {
  constexpr int D = TypeParam::value;
  std::vector<Vec<D>> points;
  for (int i = 0; i < 20; ++i) points.push_back(Vec<D>::Constant(i));
  for (const auto form : forms) {
    Cloud<D> cloud(CubicSpline(), points);
    const ConservativeSmoothing<D> filter(form, coefficient, reference_step);
    for (const auto& change : changes_by<D>(filter, cloud, time_step)) EXPECT_EQ(change.norm(), 0.0);
  }
}

}  // namespace
}  // namespace anvil
