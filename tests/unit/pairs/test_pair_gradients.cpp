// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <string>

#include "unit/pairs/cloud.hpp"

namespace anvil {
namespace {

/// Vector loops take fused multiply-adds and an exponential of their own: some ten roundings away from the scalar
/// kernel.
constexpr double round_off = 1e-14;

template <class T>
class PairGradientsIn : public InEachDimension<T> {};
TYPED_TEST_SUITE(PairGradientsIn, Dimensions);

TYPED_TEST(PairGradientsIn, EqualTheScalarKernelForEachKernelAndTile) {
  constexpr int D = TypeParam::value;
  for (const auto name : kernel_names()) {
    Cloud<D> cloud(make_kernel(name));
    const ScalarPair<D> close = cloud.pair(0, 0);  // W at distance zero: the scale of values
    const double h = close.h;
    for (const auto& [begin, end] : {std::pair<std::size_t, std::size_t>{0, cloud.count}, {5, cloud.count - 3}}) {
      const PairTile<D> tile = cloud.tile(begin, end);
      for (std::size_t i = begin; i < end; ++i) {
        for (auto k = cloud.list.row_begin(i); k < cloud.list.row_end(i); ++k) {
          const auto j = static_cast<std::size_t>(cloud.list.neighbours()[k]);
          const auto at = k - cloud.list.row_begin(begin);
          if (j == cloud.count) {  // padding adds nothing
            EXPECT_EQ(tile.value[at], 0.0);
            for (std::size_t a = 0; a < D; ++a) EXPECT_EQ(tile.gradient[a][at], 0.0);
            continue;
          }
          const ScalarPair<D> expected = cloud.pair(i, j);
          EXPECT_NEAR(tile.value[at], expected.value, round_off * close.value) << name;
          for (std::size_t a = 0; a < D; ++a)
            EXPECT_NEAR(tile.gradient[a][at], expected.gradient[static_cast<int>(a)], round_off * close.value / h)
                << name;
        }
      }
    }
  }
}

TYPED_TEST(PairGradientsIn, AreFilledAloneAsTogether) {
  constexpr int D = TypeParam::value;
  for (const auto name : kernel_names()) {
    Cloud<D> cloud(make_kernel(name));
    const double largest = cloud.pair(0, 0).value;
    const PairTile<D> tile = cloud.tile();
    const auto gradient = cloud.gradient[0];
    const auto value = cloud.value;
    const auto& loops = pair_loops<D>().kernels[cloud.kernel.index()];
    std::fill(cloud.gradient[0].begin(), cloud.gradient[0].end(), 7.0);
    loops.values(tile, cloud.records);
    // Not to the last bit: the compiler fuses other multiply-adds when only one of the two is wanted.
    for (std::size_t k = 0; k < value.size(); ++k) EXPECT_NEAR(cloud.value[k], value[k], round_off * largest) << name;
    EXPECT_EQ(cloud.gradient[0].front(), 7.0) << "a gradient was written that nobody wanted";
    std::fill(cloud.value.begin(), cloud.value.end(), 7.0);
    loops.gradients(tile, cloud.records);
    for (std::size_t k = 0; k < value.size(); ++k)
      EXPECT_NEAR(cloud.gradient[0][k], gradient[k], round_off * largest / cloud.pair(0, 0).h) << name;
    EXPECT_EQ(cloud.value.front(), 7.0) << "a value was written that nobody wanted";
  }
}

TYPED_TEST(PairGradientsIn, AreAntisymmetricToTheLastBit) {
  constexpr int D = TypeParam::value;
  for (const auto name : kernel_names()) {
    Cloud<D> cloud(make_kernel(name));
    const PairTile<D> tile = cloud.tile();
    std::map<std::pair<std::size_t, std::size_t>, std::int64_t> place;
    for (std::size_t i = 0; i < cloud.count; ++i)
      for (auto k = cloud.list.row_begin(i); k < cloud.list.row_end(i); ++k)
        place[{i, static_cast<std::size_t>(cloud.list.neighbours()[k])}] = k;
    for (const auto& [pair, k] : place) {
      if (pair.second == cloud.count) continue;
      const auto back = place.at({pair.second, pair.first});
      EXPECT_EQ(tile.value[k], tile.value[back]) << name;
      for (std::size_t a = 0; a < D; ++a) EXPECT_EQ(tile.gradient[a][k], -tile.gradient[a][back]) << name;
    }
  }
}

}  // namespace
}  // namespace anvil
