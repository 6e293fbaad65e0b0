// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/core/lanes.hpp"
#include "anvil/pairs/records.hpp"
#include "anvil/pairs/tile.hpp"

#define ANVIL_INLINE_LAMBDA __attribute__((always_inline))

namespace anvil::ANVIL_SIMD_LEVEL {

/// Lanes of the pair loops: rows are short in 1D, four neighbours at the usual smoothing length, and in 2D.
template <int D>
inline constexpr int lanes = D<3 && widest> 4 ? 4 : widest;

/// Calls row(i, first pair, end of pairs) for each particle of the tile; a row is a multiple of lanes<D> long.
template <int D, class Row>
ANVIL_INLINE void for_each_row(const PairTile<D>& tile, Row&& row) {
  for (std::int32_t i = tile.begin; i < tile.end; ++i) row(i, tile.first[i], tile.first[i + 1]);
}

/// The records (Records or their Rows) of the N neighbours from `index` on, field by field.
template <int N, class SomeRecords>
ANVIL_INLINE void load_record(const SomeRecords& records, const std::int32_t* index, Lanes<N>* out) {
  constexpr int size = SomeRecords::size;
  if constexpr (size == 2) {
    load_two_fields<N>(records.raw(), index, out);
  } else {
    for (int f = 0; f < size; f += 4) load_four_fields<N>(records.raw() + f, size, index, out + f);
  }
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
