// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/pairs/lane_loop.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

/// grad_ij of pairs along a line.
template <class Kernel, int N>
ANVIL_INLINE Lanes<N> line_gradient(Lanes<N> x_ij, Lanes<N> h_inverse) {
  using L = Lanes<N>;
  const L q = max(x_ij, -x_ij) * h_inverse;
  const L scale = L(Kernel::normalisation(1)) * h_inverse * h_inverse;
  if constexpr (requires { Kernel::slope(q); }) {
    const L slope = scale * Kernel::slope(q);
    return select(x_ij < L(0.0), -slope, slope);
  } else {
    return scale * h_inverse * Kernel::slope_over_q(q) * x_ij;
  }
}

/// Fills the pairs of a tile: grad_ij = (dW/dr) x_ij / r and, when wanted, W_ij, both at h_ij = (h_i + h_j)/2, which
/// makes grad_ij = -grad_ji to the last bit.
template <int D, class Kernel, bool Gradient, bool Value>
void fill_pairs(const PairTile<D>& opened, const PairRecords<D>& records) {
  using L = Lanes<lanes<D>>;
  const PairTile<D> tile = opened;  // both stay in registers while the loop writes
  const auto geometry = records.geometry.rows();
  const L norm(Kernel::normalisation(D));
  for_each_row(tile, [&](std::int32_t i, std::int64_t begin, std::int64_t end) ANVIL_INLINE_LAMBDA {
    const double* own = geometry[static_cast<std::size_t>(i)];
    for (std::int64_t k = begin; k < end; k += lanes<D>) {
      L other[PairRecords<D>::small];
      load_record(geometry, tile.neighbour + k, other);
      L x_ij[D], r_squared(0.0);
      for (int a = 0; a < D; ++a) {
        x_ij[a] = L(own[a]) - other[a];
        r_squared += x_ij[a] * x_ij[a];
      }
      const L h_inverse = L(2.0) / (L(own[D]) + other[D]);
      L q;
      if constexpr (D == 1)
        q = max(x_ij[0], -x_ij[0]) * h_inverse;
      else
        q = sqrt(r_squared) * h_inverse;
      const std::int64_t at = k - tile.first[tile.begin];
      L scale = norm * h_inverse;  // norm / h^D
      for (int a = 1; a < D; ++a) scale = scale * h_inverse;
      if constexpr (Value) (scale * Kernel::value(q)).store(tile.value + at);
      if constexpr (Gradient && D == 1) {
        line_gradient<Kernel>(x_ij[0], h_inverse).store(tile.plain_gradient[0] + at);
      } else if constexpr (Gradient) {
        const L factor = scale * h_inverse * h_inverse * Kernel::slope_over_q(q);
        for (int a = 0; a < D; ++a) (factor * x_ij[a]).store(tile.plain_gradient[static_cast<std::size_t>(a)] + at);
      }
    }
  });
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
