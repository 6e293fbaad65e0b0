// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/pairs/lane_loop.hpp"
#include "anvil/terms/coefficients.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

/// Artificial viscosity (Monaghan and Gingold 1983): acceleration_i -= sum_j m_j Pi_ij grad_ij for approaching pairs,
/// Pi = (-alpha c mu + beta mu^2)/rho with means of the pair, mu = h v_ij . x_ij / (x_ij^2 + eps h^2).
/// heating: W/kg per particle of the tile, half of each pair's loss.
template <int D>
void sum_viscosity(const PairTile<D>& tile, const PairRecords<D>& records, const ViscosityCoefficients& coefficients,
                   double* acceleration, double* heating) {
  using L = Lanes<lanes<D>>;
  const L alpha(coefficients.linear), beta(coefficients.quadratic), epsilon(coefficients.softening);
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
      const std::int64_t at = k - tile.first[tile.begin];
      L approach(0.0), distance_squared(0.0), work(0.0), grad[D];
      for (int a = 0; a < D; ++a) {
        const L x_ij = L(place[a]) - other_place[a], v_ij = L(motion[a]) - other_motion[a];
        grad[a] = L::load(tile.plain_gradient[static_cast<std::size_t>(a)] + at);
        approach += v_ij * x_ij;
        distance_squared += x_ij * x_ij;
        work += v_ij * grad[a];
      }
      if constexpr (lanes<D> == 1)
        if (!(approach.first() < 0.0) || (D == 1 && grad[0].first() == 0.0)) continue;  // parting, or out of reach
      load_record(records.medium, tile.neighbour + k, other_medium);
      const L h = L(0.5) * (L(place[D]) + other_place[D]);
      const L mu = min(h * approach / (distance_squared + epsilon * h * h), L(0.0));
      const L sound_speed = L(0.5) * (L(medium[0]) + other_medium[0]);
      const L density = L(0.5) * (L(medium[1]) + other_medium[1]);
      const L pi_ij = other_medium[2] * (beta * mu - alpha * sound_speed) * mu / density;
      for (int a = 0; a < D; ++a) sum[a] -= pi_ij * grad[a];
      heat += L(0.5) * pi_ij * work;
    }
    for (int a = 0; a < D; ++a) acceleration[(i - tile.begin) * D + a] += sum[a].sum();
    heating[i - tile.begin] += heat.sum();
  });
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
