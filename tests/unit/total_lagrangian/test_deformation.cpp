// SPDX-License-Identifier: BSD-3-Clause
#include "unit/total_lagrangian/frozen_block.hpp"

namespace anvil {
namespace {

template <class T>
class DeformationIn : public InEachDimension<T> {};
TYPED_TEST_SUITE(DeformationIn, Dimensions);

/// A deformation gradient far from the unit matrix.
template <int D>
Square<D> strong_deformation() {
  Square<D> f = Square<D>::Identity();
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) f(a, b) += 0.3 * std::cos(1.0 + 2.0 * a + 3.0 * b);
  return f;
}

TYPED_TEST(DeformationIn, CofactorAndDeterminantInvert) {
  constexpr int D = TypeParam::value;
  const Square<D> f = strong_deformation<D>(), c = cofactor<D>(f);
  EXPECT_NEAR((c.transpose() / determinant<D>(f, c) - Square<D>(f.inverse())).norm(), 0.0, 1e-14);
  EXPECT_NEAR(determinant<D>(f, c), f.determinant(), 1e-14);
}

// To the faces, edges and corners of the block, where half of the neighbours and more are missing.
TYPED_TEST(DeformationIn, LinearMotionIsExactEverywhere) {
  constexpr int D = TypeParam::value;
  FrozenBlock<D> block;
  EXPECT_EQ(block.uncorrected, 0);
  const Square<D> f = strong_deformation<D>();
  constexpr double time_step = 1e-6;
  for (std::size_t i = 0; i < block.count; ++i)
    block.velocity()[i] = (f - Square<D>::Identity()) * block.start[i] / time_step;
  (void)block.move(time_step);
  for (std::size_t i = 0; i < block.count; ++i) {
    EXPECT_NEAR((block.deformation.gradient(i) - f).norm(), 0.0, 1e-12);
    EXPECT_NEAR(block.fields.scalar(field::density)[i] * f.determinant(), FrozenBlock<D>::density, 1e-8);
  }
}

TYPED_TEST(DeformationIn, VelocityGradientBelongsToTheMiddleOfTheStep) {
  constexpr int D = TypeParam::value;
  FrozenBlock<D> block;
  const Square<D> f = strong_deformation<D>();
  constexpr double time_step = 1e-6;
  for (std::size_t i = 0; i < block.count; ++i)
    block.velocity()[i] = (f - Square<D>::Identity()) * block.start[i] / time_step;
  const auto gradients = block.move(time_step);
  const Square<D> rate = (f - Square<D>::Identity()) / time_step;
  const Square<D> middle = 0.5 * (f + Square<D>::Identity());
  const Square<D> expected = rate * middle.inverse();
  for (std::size_t i = 0; i < block.count; ++i)
    EXPECT_NEAR((ConstSquareMap<D>(&gradients[i * D * D]) - expected).norm(), 0.0, 1e-11 * expected.norm());
}

// The step rule may rest on it: never longer than the smallest principal stretch allows by more than sqrt(D).
TYPED_TEST(DeformationIn, LeastStretchBoundsTheSmallestPrincipalStretch) {
  constexpr int D = TypeParam::value;
  FrozenBlock<D> block;
  const double squeeze = 0.05;
  for (std::size_t i = 0; i < block.count; ++i) {
    block.velocity()[i].setZero();
    block.velocity()[i][D - 1] = (squeeze - 1.0) * block.start[i][D - 1];
  }
  (void)block.move(1.0);
  std::vector<double> stretch(block.count);
  block.deformation.find_least_stretches(block.all(), stretch.data());
  for (std::size_t i = 0; i < block.count; ++i) {
    EXPECT_GE(stretch[i], squeeze * (1.0 - 1e-12));
    EXPECT_LE(stretch[i], squeeze * std::sqrt(static_cast<double>(D)) * (1.0 + 1e-12));
  }
}

}  // namespace
}  // namespace anvil
