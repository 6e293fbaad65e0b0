// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/pairs/lane_loop.hpp"
#include "anvil/pairs/line_runs.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

/// Column b of row a in the packed symmetric tensor of D dimensions (XX YY ZZ XY YZ XZ and its parts).
template <int D>
ANVIL_INLINE constexpr int packed_index(int a, int b) {
  if (a == b) return a;
  if constexpr (D == 2) return 2;
  return a + b == 1 ? 3 : (a + b == 3 ? 4 : 5);
}

/// Of a run of particles (see is_run), with a particle in each lane.
template <int N, bool Difference>
ANVIL_INLINE void add_momentum_of_run(const double* traction, const double* gradients, const double* divisor,
                                      double* acceleration) {
  using L = Lanes<N>;
  L own[2], gradient[run_length], sum(0.0);
  load_run(traction, own);
  load_rows(gradients, gradient);
  for (int n = 0; n < run_length; ++n) {
    L other[2];
    load_run(traction + 2 * run_steps[n], other);
    sum += (Difference ? other[0] - own[0] : other[0] + own[0]) * (other[1] * gradient[n]);
  }
  double sums[run_length];
  store_run(sum, sums);
  for (int p = 0; p < run_length; ++p) acceleration[p] += divisor == nullptr ? sums[p] : sums[p] / divisor[p];
}

/// acceleration_i += (1/divisor_i) sum_j w_j (T_i + T_j) . grad_ij, with T and w as the traction records hold them;
/// D per particle of the tile, m/s2. Without a divisor the sum is taken as it is. The sum conserves momentum and so
/// wants plain gradients, which are antisymmetric; the difference, w_j (T_j - T_i), those of the scene's method.
template <int D, bool Difference>
void sum_momentum(const PairTile<D>& tile, const PairRecords<D>& records, const double* divisor, double* acceleration) {
  using L = Lanes<lanes<D>>;
  constexpr int weight = symmetric_components<D>;
  const auto& gradient = Difference ? tile.gradient : tile.plain_gradient;
  const auto sum_row = [&](std::int32_t i, std::int64_t begin, std::int64_t end) ANVIL_INLINE_LAMBDA {
    const double* own = records.traction[static_cast<std::size_t>(i)];
    L sum[D];
    for (auto& component : sum) component = L(0.0);
    for (std::int64_t k = begin; k < end; k += lanes<D>) {
      L other[PairRecords<D>::large];
      load_record(records.traction, tile.neighbour + k, other);
      const std::int64_t at = k - tile.first[tile.begin];
      L tensor[symmetric_components<D>], grad[D];
      for (int c = 0; c < symmetric_components<D>; ++c)
        tensor[c] = Difference ? other[c] - L(own[c]) : other[c] + L(own[c]);
      for (std::size_t b = 0; b < D; ++b) grad[b] = other[weight] * L::load(gradient[b] + at);
      for (int a = 0; a < D; ++a)
        for (int b = 0; b < D; ++b) sum[a] += tensor[packed_index<D>(a, b)] * grad[b];
    }
    const double scale = divisor == nullptr ? 1.0 : 1.0 / divisor[i];
    double* result = acceleration + (i - tile.begin) * D;
    for (int a = 0; a < D; ++a) result[a] += scale * sum[a].sum();
  };
  if constexpr (D == 1)
    for_each_run_or_row(
        tile,
        [&](auto i, std::int64_t begin) ANVIL_INLINE_LAMBDA {
          add_momentum_of_run<lanes<1>, Difference>(
              records.traction[static_cast<std::size_t>(i)], gradient[0] + (begin - tile.first[tile.begin]),
              divisor == nullptr ? nullptr : divisor + i, acceleration + (i - tile.begin));
        },
        sum_row);
  else
    for_each_row(tile, sum_row);
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
