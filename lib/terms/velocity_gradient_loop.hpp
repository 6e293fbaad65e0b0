// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/pairs/lane_loop.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

/// L_ab = d v_a / d x_b = sum_j V_j (v_j - v_i)_a grad_ij,b; out: D x D per particle of the tile, row a first, 1/s.
template <int D>
void sum_velocity_gradient(const PairTile<D>& tile, const PairRecords<D>& records, double* out) {
  using L = Lanes<lanes<D>>;
  for_each_row(tile, [&](std::int32_t i, std::int64_t begin, std::int64_t end) ANVIL_INLINE_LAMBDA {
    const double* own = records.motion[static_cast<std::size_t>(i)];
    L sum[D][D];
    for (auto& row : sum)
      for (auto& component : row) component = L(0.0);
    for (std::int64_t k = begin; k < end; k += lanes<D>) {
      L other[PairRecords<D>::small];
      load_record(records.motion, tile.neighbour + k, other);
      const std::int64_t at = k - tile.first[tile.begin];
      L grad[D];
      for (int b = 0; b < D; ++b) grad[b] = L::load(tile.gradient[static_cast<std::size_t>(b)] + at);
      for (int a = 0; a < D; ++a) {
        const L difference = other[D] * (other[a] - L(own[a]));
        for (int b = 0; b < D; ++b) sum[a][b] += difference * grad[b];
      }
    }
    double* result = out + (i - tile.begin) * D * D;
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) result[a * D + b] = sum[a][b].sum();
  });
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
