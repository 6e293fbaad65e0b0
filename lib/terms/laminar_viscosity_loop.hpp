// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/pairs/lane_loop.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

/// Viscous forces of a laminar flow (Morris, Fox and Zhu 1997, equation 22): acceleration_i += sum_j m_j (mu_i + mu_j)
/// / (rho_i rho_j) (x_ij . grad_ij) / (x_ij^2 + 0.01 h^2) v_ij. heating: W/kg per particle of the tile, half of each
/// pair's loss.
template <int D>
void sum_laminar_viscosity(const PairTile<D>& tile, const PairRecords<D>& records, double* acceleration,
                           double* heating) {
  using L = Lanes<lanes<D>>;
  for_each_row(tile, [&](std::int32_t i, std::int64_t begin, std::int64_t end) ANVIL_INLINE_LAMBDA {
    const auto row = static_cast<std::size_t>(i);
    const double* place = records.geometry[row];
    const double* motion = records.motion[row];
    const double* medium = records.medium[row];
    L sum[D], heat(0.0);
    for (auto& component : sum) component = L(0.0);
    for (std::int64_t k = begin; k < end; k += lanes<D>) {
      L other_place[PairRecords<D>::small], other_motion[PairRecords<D>::small], other_medium[4];
      load_record(records.geometry, tile.neighbour + k, other_place);
      load_record(records.motion, tile.neighbour + k, other_motion);
      load_record(records.medium, tile.neighbour + k, other_medium);
      const std::int64_t at = k - tile.first[tile.begin];
      L slope(0.0), distance_squared(0.0), speed_squared(0.0), v_ij[D];
      for (int a = 0; a < D; ++a) {
        const L x_ij = L(place[a]) - other_place[a];
        v_ij[a] = L(motion[a]) - other_motion[a];
        slope += x_ij * L::load(tile.plain_gradient[static_cast<std::size_t>(a)] + at);
        distance_squared += x_ij * x_ij;
        speed_squared += v_ij[a] * v_ij[a];
      }
      const L h = L(0.5) * (L(place[D]) + other_place[D]);
      const L factor = other_medium[2] * (L(medium[3]) + other_medium[3]) * slope /
                       (L(medium[1]) * other_medium[1] * (distance_squared + L(0.01) * h * h));
      for (int a = 0; a < D; ++a) sum[a] += factor * v_ij[a];
      heat -= L(0.5) * factor * speed_squared;
    }
    for (int a = 0; a < D; ++a) acceleration[(i - tile.begin) * D + a] += sum[a].sum();
    heating[i - tile.begin] += heat.sum();
  });
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
