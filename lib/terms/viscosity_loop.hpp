// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/pairs/lane_loop.hpp"
#include "anvil/pairs/line_runs.hpp"
#include "anvil/terms/coefficients.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

/// m_j Pi_ij of pairs whose v_ij . x_ij is `approach`; `medium` and `other` hold sound speed, density and mass.
template <int N>
ANVIL_INLINE Lanes<N> viscous_weight(const ViscosityCoefficients& coefficients, Lanes<N> approach,
                                     Lanes<N> distance_squared, Lanes<N> h, const Lanes<N>* medium,
                                     const Lanes<N>* other) {
  using L = Lanes<N>;
  const L softened = distance_squared + L(coefficients.softening) * h * h;
  const L sound_speed = L(0.5) * (medium[0] + other[0]);
  const L density = L(0.5) * (medium[1] + other[1]);
  const L inverse = L(1.0) / (softened * density);  // of both: divisions cost more than all the rest
  const L mu = min(h * approach * inverse * density, L(0.0));
  return other[2] * (L(coefficients.quadratic) * mu - L(coefficients.linear) * sound_speed) * mu * (inverse * softened);
}

/// A run of particles (see is_run) with a particle in each lane.
template <int N>
ANVIL_INLINE void add_viscosity_of_run(const PairTile<1>& tile, const PairRecords<1>& records,
                                       const ViscosityCoefficients& coefficients, std::int32_t i, double* acceleration,
                                       double* heating) {
  using L = Lanes<N>;
  const auto row = static_cast<std::size_t>(i);
  const double *places = records.geometry[row], *motions = records.motion[row], *media = records.medium[row];
  L place[2], motion[2], medium[4], gradient[run_length], sum(0.0), heat(0.0);
  load_run(places, place);
  load_run(motions, motion);
  load_long_run(media, medium);
  load_rows(tile.plain_gradient[0] + (tile.first[i] - tile.first[tile.begin]), gradient);
  for (int n = 0; n < run_length; ++n) {
    L other_place[2], other_motion[2], other_medium[4];
    load_run(places + 2 * run_steps[n], other_place);
    load_run(motions + 2 * run_steps[n], other_motion);
    const L x_ij = place[0] - other_place[0], v_ij = motion[0] - other_motion[0], approach = v_ij * x_ij;
    if (!any(approach < L(0.0))) continue;
    load_long_run(media + 4 * run_steps[n], other_medium);
    const L h = L(0.5) * (place[1] + other_place[1]);
    const L pi_ij = viscous_weight(coefficients, approach, x_ij * x_ij, h, medium, other_medium);
    sum -= pi_ij * gradient[n];
    heat += L(0.5) * pi_ij * (v_ij * gradient[n]);
  }
  double sums[run_length], heats[run_length];
  store_run(sum, sums);
  store_run(heat, heats);
  for (int p = 0; p < run_length; ++p) {
    acceleration[i - tile.begin + p] += sums[p];
    heating[i - tile.begin + p] += heats[p];
  }
}

/// Artificial viscosity (Monaghan and Gingold 1983): acceleration_i -= sum_j m_j Pi_ij grad_ij for approaching pairs,
/// Pi = (-alpha c mu + beta mu^2)/rho with means of the pair, c the bulk sound speed, mu = h v_ij . x_ij /
/// (x_ij^2 + eps h^2).
/// heating: W/kg per particle of the tile, half of each pair's loss.
template <int D>
void sum_viscosity(const PairTile<D>& tile, const PairRecords<D>& records, const ViscosityCoefficients& coefficients,
                   double* acceleration, double* heating) {
  using L = Lanes<lanes<D>>;
  const auto sum_row = [&](std::int32_t i, std::int64_t begin, std::int64_t end) ANVIL_INLINE_LAMBDA {
    const auto row = static_cast<std::size_t>(i);
    const double* place = records.geometry[row];
    const double* motion = records.motion[row];
    const double* own_medium = records.medium[row];
    const L medium[] = {L(own_medium[0]), L(own_medium[1])};
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
      if ((approach < L(0.0)).bits() == 0) continue;  // all part
      load_record(records.medium, tile.neighbour + k, other_medium);
      const L h = L(0.5) * (L(place[D]) + other_place[D]);
      const L pi_ij = viscous_weight(coefficients, approach, distance_squared, h, medium, other_medium);
      for (int a = 0; a < D; ++a) sum[a] -= pi_ij * grad[a];
      heat += L(0.5) * pi_ij * work;
    }
    for (int a = 0; a < D; ++a) acceleration[(i - tile.begin) * D + a] += sum[a].sum();
    heating[i - tile.begin] += heat.sum();
  };
  if constexpr (D == 1)
    for_each_run_or_row(
        tile,
        [&](auto i, std::int64_t /*begin*/) ANVIL_INLINE_LAMBDA {
          add_viscosity_of_run<lanes<1>>(tile, records, coefficients, i, acceleration, heating);
        },
        sum_row);
  else
    for_each_row(tile, sum_row);
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
