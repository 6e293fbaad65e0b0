// SPDX-License-Identifier: BSD-3-Clause
#include "unit/terms/term_cloud.hpp"

namespace anvil {
namespace {

template <int D>
std::vector<Mat<D>> velocity_gradients(Cloud<D>& cloud) {
  std::vector<double> numbers(cloud.count * D * D);
  for (const auto& [begin, end] : {std::pair<std::size_t, std::size_t>{0, 13}, {13, cloud.count}})
    pair_loops<D>().velocity_gradient(cloud.tile(begin, end), cloud.records, &numbers[begin * D * D]);
  std::vector<Mat<D>> gradients(cloud.count);
  for (std::size_t i = 0; i < cloud.count; ++i)
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) gradients[i](a, b) = numbers[i * D * D + static_cast<std::size_t>(a * D + b)];
  return gradients;
}

template <int D>
ScalarSum<Mat<D>> scalar_gradient(Cloud<D>& cloud, std::size_t i) {
  ScalarSum<Mat<D>> sum;
  for (std::size_t j = 0; j < cloud.count; ++j) {
    if (i == j) continue;
    const auto pair = cloud.pair(i, j);
    sum.add(-cloud.volume(j) * pair.v * pair.gradient.transpose());
  }
  return sum;
}

template <class T>
class VelocityGradientIn : public InEachDimension<T> {};
TYPED_TEST_SUITE(VelocityGradientIn, Dimensions);

TYPED_TEST(VelocityGradientIn, EqualsAScalarLoop) {
  constexpr int D = TypeParam::value;
  Cloud<D> cloud;
  const auto gradients = velocity_gradients(cloud);
  for (std::size_t i = 0; i < cloud.count; ++i) {
    const auto expected = scalar_gradient(cloud, i);
    EXPECT_NEAR((gradients[i] - expected.value).norm(), 0.0, round_off * expected.magnitude);
  }
}

TYPED_TEST(VelocityGradientIn, DoesNotNoticeAMovingFrame) {
  constexpr int D = TypeParam::value;
  Cloud<D> cloud;
  const auto before = velocity_gradients(cloud);
  board_a_train(cloud);
  const auto after = velocity_gradients(cloud);
  // Velocities of 600 m/s instead of 100 m/s are rounded six times as coarsely.
  for (std::size_t i = 0; i < cloud.count; ++i)
    EXPECT_NEAR((after[i] - before[i]).norm(), 0.0, 10.0 * round_off * scalar_gradient(cloud, i).magnitude);
}

TYPED_TEST(VelocityGradientIn, HasTheSignOfAnExpansion) {
  constexpr int D = TypeParam::value;
  Cloud<D> cloud;
  for (std::size_t i = 0; i < cloud.count; ++i) cloud.velocity()[i] = 1000.0 * cloud.position()[i];
  cloud.pack();
  const auto gradients = velocity_gradients(cloud);
  for (const auto& gradient : gradients) EXPECT_GT(gradient.trace(), 0.0);
}

}  // namespace
}  // namespace anvil
