// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/pairs/neighbour_list.hpp"

#include <algorithm>

#include "anvil/core/threads.hpp"
#include "unit/pairs/cloud.hpp"

namespace anvil {
namespace {

using Rows = std::vector<std::vector<std::int32_t>>;

constexpr double reach = 2.0, skin = 0.3;

template <int D>
NeighbourList<D> list_of(std::vector<Vec<D>> points, const std::vector<double>& smoothing_length) {
  NeighbourList<D> list;
  list.build(VectorView<D>(points.empty() ? nullptr : points[0].data()), smoothing_length, reach, skin,
             pair_loops<D>());
  return list;
}

/// The rows without their padding, each sorted.
template <int D>
Rows rows_of(const NeighbourList<D>& list, std::size_t particles) {
  Rows rows(particles);
  for (std::size_t i = 0; i < particles; ++i) {
    for (auto k = list.row_begin(i); k < list.row_end(i); ++k)
      if (list.neighbours()[k] != static_cast<std::int32_t>(particles)) rows[i].push_back(list.neighbours()[k]);
    std::ranges::sort(rows[i]);
  }
  return rows;
}

template <int D>
Rows brute_force(const std::vector<Vec<D>>& points, const std::vector<double>& smoothing_length) {
  Rows rows(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < points.size(); ++j)
      if (i != j && (points[i] - points[j]).norm() < 0.5 * reach * (smoothing_length[i] + smoothing_length[j]) + skin)
        rows[i].push_back(static_cast<std::int32_t>(j));
  return rows;
}

template <int D>
void expect_complete(const std::vector<Vec<D>>& points, const std::vector<double>& smoothing_length) {
  const auto list = list_of<D>(points, smoothing_length);
  const Rows expected = brute_force<D>(points, smoothing_length);
  EXPECT_EQ(rows_of(list, points.size()), expected);
  std::int64_t pairs = 0;
  for (const auto& row : expected) pairs += static_cast<std::int64_t>(row.size());
  EXPECT_EQ(list.listed(), pairs);
}

template <int D>
void expect_complete(const std::vector<Vec<D>>& points) {
  expect_complete<D>(points, std::vector<double>(points.size(), 1.0));
}

/// Uniformly spread, about eight per unit volume.
template <int D>
std::vector<Vec<D>> random_points(int count) {
  std::mt19937 random(3);
  const double side = 0.5 * std::pow(count, 1.0 / D);
  std::uniform_real_distribution<double> coordinate(-side, side);
  std::vector<Vec<D>> points(static_cast<std::size_t>(count));
  for (auto& point : points)
    for (int a = 0; a < D; ++a) point[a] = coordinate(random);
  return points;
}

template <class T>
class NeighbourListIn : public InEachDimension<T> {};
TYPED_TEST_SUITE(NeighbourListIn, Dimensions);

TYPED_TEST(NeighbourListIn, HoldsWhatBruteForceFinds) {
  constexpr int D = TypeParam::value;
  expect_complete<D>(random_points<D>(600));
}

TYPED_TEST(NeighbourListIn, IsCompleteOnALatticeWhosePointsLieOnCellFaces) {
  constexpr int D = TypeParam::value;
  // No distance of the lattice equals the limit 2.3 of the list: neither side depends on rounding.
  expect_complete<D>(jittered_lattice<D>(D == 3 ? 8 : 20, 1.0, 0.0));
}

TYPED_TEST(NeighbourListIn, UsesTheMeanOfUnlikeSmoothingLengths) {
  constexpr int D = TypeParam::value;
  const auto points = random_points<D>(400);
  std::vector<double> smoothing_length;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> length(0.2, 2.0);
  for (std::size_t i = 0; i < points.size(); ++i) smoothing_length.push_back(length(random));
  expect_complete<D>(points, smoothing_length);
}

TYPED_TEST(NeighbourListIn, ListsCoincidentParticlesButNobodyAsItsOwnNeighbour) {
  constexpr int D = TypeParam::value;
  auto points = random_points<D>(50);
  points[7] = points[30] = points[41];
  expect_complete<D>(points);
}

TYPED_TEST(NeighbourListIn, ServesOneParticleThatHasFlownFar) {
  constexpr int D = TypeParam::value;
  for (const double far : {1e12, -1e12, 1e300}) {
    auto points = random_points<D>(300);
    points[100] = Vec<D>::Constant(far);
    expect_complete<D>(points);
  }
}

TYPED_TEST(NeighbourListIn, ServesFewParticles) {
  constexpr int D = TypeParam::value;
  const auto lattice = jittered_lattice<D>(4, 1.0, 0.0);
  for (int count = 0; count <= 3; ++count) expect_complete<D>({lattice.begin(), lattice.begin() + count});
}

TYPED_TEST(NeighbourListIn, PadsRowsAtTheirEndToWholeVectors) {
  constexpr int D = TypeParam::value;
  const auto points = random_points<D>(300);
  const auto particles = static_cast<std::int32_t>(points.size());
  const int lanes = pair_loops<D>().lanes;
  const auto list = list_of<D>(points, std::vector<double>(points.size(), 1.0));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto begin = list.neighbours() + list.row_begin(i), end = list.neighbours() + list.row_end(i);
    EXPECT_EQ((end - begin) % lanes, 0);
    const auto padding = std::find(begin, end, particles);
    EXPECT_LT(end - padding, lanes);
    EXPECT_TRUE(std::all_of(padding, end, [&](std::int32_t j) { return j == particles; }));
  }
}

TYPED_TEST(NeighbourListIn, IsTheSameForAnyNumberOfThreads) {
  constexpr int D = TypeParam::value;
  const auto points = random_points<D>(2000);  // several pieces of work
  const std::vector<double> smoothing_length(points.size(), 1.0);
  const int before = thread_count();
  set_thread_count(1);
  const auto one = list_of<D>(points, smoothing_length);
  set_thread_count(2);
  const auto two = list_of<D>(points, smoothing_length);
  set_thread_count(before);
  const std::vector<std::int64_t> first(one.first(), one.first() + points.size() + 1);
  ASSERT_EQ(first, std::vector<std::int64_t>(two.first(), two.first() + points.size() + 1));
  EXPECT_TRUE(std::equal(one.neighbours(), one.neighbours() + first.back(), two.neighbours()));
}

TYPED_TEST(NeighbourListIn, ForgetsTheParticlesOfTheBuildBefore) {
  constexpr int D = TypeParam::value;
  auto points = random_points<D>(300);
  NeighbourList<D> list;
  const std::vector<double> smoothing_length(points.size(), 1.0);
  const auto build = [&] {
    list.build(VectorView<D>(points[0].data()), smoothing_length, reach, skin, pair_loops<D>());
  };
  build();
  for (auto& point : points) point *= 1.5;
  build();
  EXPECT_EQ(rows_of(list, points.size()), brute_force<D>(points, smoothing_length));
}

}  // namespace
}  // namespace anvil
