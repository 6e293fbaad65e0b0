// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/pairs/lane_loop.hpp"
#include "anvil/pairs/pair_loops.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

/// See PairLoops::collect. Reads up to `lanes` candidates beyond the last: the arrays are that much longer.
template <int D>
int collect_neighbours(const Candidates<D>& candidates, std::int64_t begin, std::int64_t end, std::int64_t self,
                       double reach, double skin, std::int32_t* out) {
  constexpr int width = D == 1 ? 1 : widest;
  using L = Lanes<width>;
  const L half_reach(0.5 * reach), own_h(candidates.smoothing_length[self]), margin(skin);
  L own[D];
  for (std::size_t a = 0; a < D; ++a) own[a] = L(candidates.position[a][self]);
  std::int32_t* next = out;
  for (std::int64_t k = begin; k < end; k += width) {
    L r_squared(0.0);
    for (std::size_t a = 0; a < D; ++a) {
      const L x_ij = own[a] - L::load(candidates.position[a] + k);
      r_squared += x_ij * x_ij;
    }
    const L limit = half_reach * (own_h + L::load(candidates.smoothing_length + k)) + margin;
    const std::uint32_t near = (r_squared < limit * limit).bits();
    if (near == 0) continue;
    for (int lane = 0; lane < width; ++lane) {
      *next = candidates.particle[k + lane];
      const bool wanted = (near >> lane & 1U) != 0 && k + lane < end && k + lane != self;
      next += wanted ? 1 : 0;
    }
  }
  return static_cast<int>(next - out);
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
