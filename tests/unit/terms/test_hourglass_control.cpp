// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/terms/hourglass_control.hpp"

#include "unit/terms/term_cloud.hpp"
#include "unit/total_lagrangian/frozen_block.hpp"

namespace anvil {
namespace {

constexpr double modulus = 1e10;  // Pa, alpha E

template <int D>
struct ControlledBlock : FrozenBlock<D> {
  ControlledBlock() {
    this->fields.require(field::smoothing_length);
    for (double& h : this->fields.scalar(field::smoothing_length)) h = 0.8 * this->spacing;
    control = std::make_unique<HourglassControl<D>>(
        this->fields, this->deformation, CubicSpline(),
        std::vector<typename HourglassControl<D>::Stiffness>{{this->all(), modulus}});
  }
  std::vector<Vec<D>> accelerations() {
    std::vector<Vec<D>> acceleration(this->count, Vec<D>::Zero());
    loss.assign(this->count, 0.0);
    control->accumulate(this->tile(), this->records, acceleration[0].data(), loss.data());
    return acceleration;
  }
  double mass(std::size_t i) { return this->fields.scalar(field::mass)[i]; }

  std::unique_ptr<HourglassControl<D>> control;
  std::vector<double> loss;
  /// Of a pair that is a hundredth of a spacing away from where it should be, m/s2.
  static constexpr double scale = 0.01 * modulus / (FrozenBlock<D>::density * FrozenBlock<D>::spacing);
};

template <class T>
class HourglassControlIn : public InEachDimension<T> {};
TYPED_TEST_SUITE(HourglassControlIn, Dimensions);

TYPED_TEST(HourglassControlIn, FeelsNothingOfAnEvenDeformation) {
  constexpr int D = TypeParam::value;
  ControlledBlock<D> block;
  const Mat<D> rate = Mat<D>::Identity() * 1e3 + Mat<D>::Constant(2e3);
  for (std::size_t i = 0; i < block.count; ++i) block.velocity()[i] = rate * block.start[i];
  (void)block.move(1e-4);
  for (const auto& acceleration : block.accelerations())
    EXPECT_LT(acceleration.norm(), 1e-9 * ControlledBlock<D>::scale);
}

TYPED_TEST(HourglassControlIn, IsTheSumOverItsPairs) {
  constexpr int D = TypeParam::value;
  ControlledBlock<D> block;
  block.move_at_random(1e-7, 200.0);
  const auto found = block.accelerations();
  const double h = 0.8 * block.spacing;
  for (std::size_t i = 0; i < block.count; ++i) {
    Vec<D> wanted = Vec<D>::Zero();
    for (std::size_t j = 0; j < block.count; ++j) {
      const Vec<D> start = block.start[i] - block.start[j];
      if (i == j || start.norm() >= 2.0 * h) continue;
      const Vec<D> apart = block.position()[i] - block.position()[j], along = apart.normalized();
      const double own = (block.deformation.gradient(i) * start - apart).dot(along);
      const double other = (block.deformation.gradient(j) * start - apart).dot(along);
      const double value = CubicSpline::normalisation(D) / std::pow(h, D) * CubicSpline::value(start.norm() / h);
      wanted += 0.5 * block.deformation.volume(i) * block.deformation.volume(j) * value / start.squaredNorm() *
                modulus * (own + other) * along / block.mass(i);
    }
    EXPECT_LT((found[i] - wanted).norm(), 1e-10 * ControlledBlock<D>::scale) << i;
  }
}

TYPED_TEST(HourglassControlIn, KeepsMomenta) {
  constexpr int D = TypeParam::value;
  ControlledBlock<D> block;
  block.move_at_random(1e-7, 200.0);
  const auto accelerations = block.accelerations();
  ScalarSum<Vec<D>> linear;
  ScalarSum<Vec<3>> angular;
  for (std::size_t i = 0; i < block.count; ++i) {
    linear.add(block.mass(i) * accelerations[i]);
    Vec<3> arm = Vec<3>::Zero(), vector = Vec<3>::Zero();
    arm.head(D) = block.position()[i];
    vector.head(D) = accelerations[i];
    angular.add(block.mass(i) * arm.cross(vector));
  }
  EXPECT_GT(linear.magnitude, 0.0);
  EXPECT_LT(linear.value.norm(), 1e-13 * linear.magnitude);
  EXPECT_LE(angular.value.norm(), 1e-13 * angular.magnitude);
}

// One particle beside its place, of which the gradients know nothing: it is driven back.
TYPED_TEST(HourglassControlIn, DrivesAParticleBack) {
  constexpr int D = TypeParam::value;
  ControlledBlock<D> block;
  const std::size_t middle = block.count / 2;
  const Vec<D> displacement = 0.01 * block.spacing * Vec<D>::Unit(0);
  block.position()[middle] += displacement;
  const auto accelerations = block.accelerations();
  EXPECT_LT(accelerations[middle].dot(displacement), -0.01 * ControlledBlock<D>::scale * displacement.norm());
}

TYPED_TEST(HourglassControlIn, CountsTheMeanOfTheLastForceAndThis) {
  constexpr int D = TypeParam::value;
  ControlledBlock<D> block;
  block.move_at_random(1e-7, 200.0);
  const auto first = block.accelerations();
  block.position()[0] += 0.01 * block.spacing * Vec<D>::Unit(0);
  const auto second = block.accelerations();
  for (std::size_t i = 0; i < block.count; ++i)
    EXPECT_NEAR(block.loss[i], -0.5 * (first[i] + second[i]).dot(block.velocity()[i]),
                1e-12 * ControlledBlock<D>::scale * 200.0);
}

}  // namespace
}  // namespace anvil
