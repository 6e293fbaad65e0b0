// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/pairs/lane_loop.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

/// Most rows of a line hold the two particles before and the two behind. Four such rows in turn are done with a
/// particle in each lane: nothing is gathered, and no sum goes across lanes.
inline constexpr int run_length = 4;
inline constexpr int run_steps[run_length] = {-2, -1, 1, 2};  // to the neighbours
inline constexpr bool has_runs = lanes<1> == run_length;

ANVIL_INLINE bool is_run(const PairTile<1>& tile, std::int32_t i) {
  if (i + run_length > tile.end || tile.first[i + run_length] - tile.first[i] != run_length * run_length) return false;
  const std::int32_t* neighbour = tile.neighbour + tile.first[i];
  std::int32_t different = 0;
  for (int p = 0; p < run_length; ++p)
    for (int n = 0; n < run_length; ++n) different |= neighbour[p * run_length + n] ^ (i + p + run_steps[n]);
  return different == 0;
}

/// Calls run(i, its first pair) for four particles from i on where it can, else row as for_each_row does.
template <class Run, class Row>
ANVIL_INLINE void for_each_run_or_row(const PairTile<1>& tile, Run&& run, Row&& row) {
  for (std::int32_t i = tile.begin; i < tile.end;) {
    if constexpr (has_runs) {
      if (is_run(tile, i)) {
        run(i, tile.first[i]);
        i += run_length;
        continue;
      }
    }
    row(i, tile.first[i], tile.first[i + 1]);
    ++i;
  }
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
