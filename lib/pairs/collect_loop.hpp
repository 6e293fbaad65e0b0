// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>

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
  const hn::Rebind<std::int32_t, typename L::Tag> number;
  std::int32_t* next = out;
  for (std::int64_t k = begin; k < end; k += width) {
    L r_squared(0.0);
    for (std::size_t a = 0; a < D; ++a) {
      const L x_ij = own[a] - L::load(candidates.position[a] + k);
      r_squared += x_ij * x_ij;
    }
    const L limit = half_reach * (own_h + L::load(candidates.smoothing_length + k)) + margin;
    std::uint32_t near = (r_squared < limit * limit).bits();
    if (end - k < width) near &= (1U << (end - k)) - 1U;
    if (k <= self && self < k + width) near &= ~(1U << (self - k));
    if (near == 0) continue;
    const std::uint8_t wanted[8] = {static_cast<std::uint8_t>(near)};
    const auto numbers = hn::Compress(hn::LoadU(number, candidates.particle + k), hn::LoadMaskBits(number, wanted));
    hn::StoreU(numbers, number, next);
    next += std::popcount(near);
  }
  return static_cast<int>(next - out);
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
