// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/pairs/lane_loop.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

/// Diffusion of density (Molteni and Colagrossi 2009, equation 6): rate_i = 2 delta sum_j V_j h c (rho_j - rho_i -
/// drho) x_ji . grad_ij / (x_ij^2 + 0.01 h^2), h and c means of the pair. drho = rho_i gravity . x_ji / c^2 is the
/// difference in a fluid at rest, which must not flatten. One number per particle of the tile, kg/(m3 s).
template <int D>
void sum_density_diffusion(const PairTile<D>& tile, const PairRecords<D>& records, double delta, const double* gravity,
                           double* rate) {
  using L = Lanes<lanes<D>>;
  for_each_row(tile, [&](std::int32_t i, std::int64_t begin, std::int64_t end) ANVIL_INLINE_LAMBDA {
    const auto row = static_cast<std::size_t>(i);
    const double* place = records.geometry[row];
    const double* medium = records.medium[row];
    const double stratified = medium[1] / (medium[0] * medium[0]);
    L sum(0.0);
    for (std::int64_t k = begin; k < end; k += lanes<D>) {
      L other_place[PairRecords<D>::small], motion[PairRecords<D>::small], other_medium[4];
      load_record(records.geometry, tile.neighbour + k, other_place);
      load_record(records.motion, tile.neighbour + k, motion);
      load_record(records.medium, tile.neighbour + k, other_medium);
      const std::int64_t at = k - tile.first[tile.begin];
      L slope(0.0), distance_squared(0.0), fall(0.0);
      for (int a = 0; a < D; ++a) {
        const L x_ji = other_place[a] - L(place[a]);
        slope += x_ji * L::load(tile.plain_gradient[static_cast<std::size_t>(a)] + at);
        distance_squared += x_ji * x_ji;
        fall += L(gravity[a]) * x_ji;
      }
      const L h = L(0.5) * (L(place[D]) + other_place[D]);
      const L speed = L(0.5) * (L(medium[0]) + other_medium[0]);
      const L difference = other_medium[1] - L(medium[1]) - L(stratified) * fall;
      sum += motion[D] * h * speed * difference * slope / (distance_squared + L(0.01) * h * h);
    }
    rate[i - tile.begin] = 2.0 * delta * sum.sum();
  });
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
