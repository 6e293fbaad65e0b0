// SPDX-License-Identifier: BSD-3-Clause
#include "unit/pairs/cloud.hpp"

namespace anvil {
namespace {

template <class T>
class GradientCorrectionIn : public InEachDimension<T> {};
TYPED_TEST_SUITE(GradientCorrectionIn, Dimensions);

/// sum_j V_j (f_j - f_i) grad_ij over the pairs of a tile that starts at particle 0, for f = slope . x.
template <int D>
Vec<D> gradient_of_linear_field(Cloud<D>& cloud, const PairTile<D>& tile, std::size_t i, const Vec<D>& slope) {
  Vec<D> sum = Vec<D>::Zero();
  for (std::int64_t k = cloud.list.row_begin(i); k < cloud.list.row_end(i); ++k) {
    const auto j = static_cast<std::size_t>(cloud.list.neighbours()[k]);
    if (j >= cloud.count) break;  // padding
    const double difference = slope.dot(cloud.position()[j] - cloud.position()[i]);
    for (int a = 0; a < D; ++a) sum[a] += cloud.volume(j) * difference * tile.gradient[static_cast<std::size_t>(a)][k];
  }
  return sum;
}

TYPED_TEST(GradientCorrectionIn, IsExactForLinearFieldsUpToTheFaces) {
  constexpr int D = TypeParam::value;
  Cloud<D> cloud;
  const PairTile<D> tile = cloud.tile();
  EXPECT_EQ(pair_loops<D>().correct_gradients(tile, cloud.records), 0);
  const Vec<D> slope = Vec<D>::LinSpaced(1.0, -2.0);
  for (std::size_t i = 0; i < cloud.count; ++i) {
    // Round-off of some fifty terms, times the condition of the moment: 30 at a jittered corner.
    EXPECT_NEAR((gradient_of_linear_field(cloud, tile, i, slope) - slope).norm(), 0.0, 1e-11) << "particle " << i;
  }
}

TYPED_TEST(GradientCorrectionIn, KeepsThePlainGradientsApart) {
  constexpr int D = TypeParam::value;
  Cloud<D> cloud;
  PairTile<D> tile = cloud.tile();
  const auto plain = cloud.gradient[0];
  std::vector<double> corrected[D];
  for (std::size_t a = 0; a < D; ++a) {
    corrected[a].resize(plain.size());
    tile.gradient[a] = corrected[a].data();
  }
  (void)pair_loops<D>().correct_gradients(tile, cloud.records);
  EXPECT_EQ(cloud.gradient[0], plain);
  EXPECT_NE(corrected[0], plain);
}

/// Two particles in more than one dimension span a line, one alone nothing: their moments have no inverse.
TYPED_TEST(GradientCorrectionIn, LeavesParticlesThatLackNeighboursAlone) {
  constexpr int D = TypeParam::value;
  Vec<D> right = Vec<D>::Zero(), far = Vec<D>::Zero();
  right[0] = Cloud<D>::spacing;
  far[0] = 100.0 * Cloud<D>::spacing;
  Cloud<D> cloud(CubicSpline(), {Vec<D>::Zero(), right, far});
  const PairTile<D> tile = cloud.tile();
  const auto plain = cloud.gradient[0];
  EXPECT_EQ(pair_loops<D>().correct_gradients(tile, cloud.records), D == 1 ? 1 : 3);
  if (D > 1) {
    EXPECT_EQ(cloud.gradient[0], plain);
  }
}

}  // namespace
}  // namespace anvil
