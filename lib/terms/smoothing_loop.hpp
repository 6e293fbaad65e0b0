// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/pairs/lane_loop.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

/// change_i = sum_j V_j (v_j - v_i) W_ij / sum_j V_j W_ij over the neighbours without i itself (Long 2007): the step to
/// their weighted mean. D per particle of the tile, m/s; zero for a particle without neighbours.
template <int D>
void sum_plain_smoothing(const PairTile<D>& tile, const PairRecords<D>& records, double* change) {
  using L = Lanes<lanes<D>>;
  for_each_row(tile, [&](std::int32_t i, std::int64_t begin, std::int64_t end) ANVIL_INLINE_LAMBDA {
    const double* own = records.motion[static_cast<std::size_t>(i)];
    L sum[D], weights(0.0);
    for (auto& component : sum) component = L(0.0);
    for (std::int64_t k = begin; k < end; k += lanes<D>) {
      L other[PairRecords<D>::small];
      load_record(records.motion, tile.neighbour + k, other);
      const L weight = other[D] * L::load(tile.value + (k - tile.first[tile.begin]));
      weights += weight;
      for (int a = 0; a < D; ++a) sum[a] += weight * (other[a] - L(own[a]));
    }
    const double total = weights.sum();
    for (int a = 0; a < D; ++a) change[(i - tile.begin) * D + a] = total > 0.0 ? sum[a].sum() / total : 0.0;
  });
}

/// change_i = sum_j 2 m_j / (rho_i + rho_j) (v_j - v_i) W_ij: what i gains in momentum, j loses.
template <int D>
void sum_pairwise_smoothing(const PairTile<D>& tile, const PairRecords<D>& records, double* change) {
  using L = Lanes<lanes<D>>;
  for_each_row(tile, [&](std::int32_t i, std::int64_t begin, std::int64_t end) ANVIL_INLINE_LAMBDA {
    const double* own = records.motion[static_cast<std::size_t>(i)];
    const double own_density = records.medium[static_cast<std::size_t>(i)][1];
    L sum[D];
    for (auto& component : sum) component = L(0.0);
    for (std::int64_t k = begin; k < end; k += lanes<D>) {
      L other[PairRecords<D>::small], medium[4];
      load_record(records.motion, tile.neighbour + k, other);
      load_record(records.medium, tile.neighbour + k, medium);
      const L value = L::load(tile.value + (k - tile.first[tile.begin]));
      const L weight = L(2.0) * medium[2] / (L(own_density) + medium[1]) * value;
      for (int a = 0; a < D; ++a) sum[a] += weight * (other[a] - L(own[a]));
    }
    for (int a = 0; a < D; ++a) change[(i - tile.begin) * D + a] = sum[a].sum();
  });
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
