// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/pairs/lane_loop.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

/// acceleration_i += sum_j w_j (T_i + T_j) grad_ij with tensors T (D x D, row first) that need not be symmetric and
/// weights w, as the nominal records hold them; D per particle of the tile, m/s2.
template <int D>
void sum_nominal_momentum(const PairTile<D>& tile, const PairRecords<D>& records, double* acceleration) {
  using L = Lanes<lanes<D>>;
  for_each_row(tile, [&](std::int32_t i, std::int64_t begin, std::int64_t end) ANVIL_INLINE_LAMBDA {
    const double* own = records.nominal[static_cast<std::size_t>(i)];
    L sum[D];
    for (auto& component : sum) component = L(0.0);
    for (std::int64_t k = begin; k < end; k += lanes<D>) {
      L other[PairRecords<D>::nominal_size];
      load_record(records.nominal, tile.neighbour + k, other);
      const std::int64_t at = k - tile.first[tile.begin];
      for (int b = 0; b < D; ++b) {
        const L grad = other[D * D] * L::load(tile.plain_gradient[static_cast<std::size_t>(b)] + at);
        for (int a = 0; a < D; ++a) sum[a] += (other[a * D + b] + L(own[a * D + b])) * grad;
      }
    }
    double* result = acceleration + (i - tile.begin) * D;
    for (int a = 0; a < D; ++a) result[a] += sum[a].sum();
  });
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
