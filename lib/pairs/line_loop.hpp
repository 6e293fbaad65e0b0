// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/pairs/correction_loop.hpp"
#include "anvil/pairs/gradient_loop.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

// Along a line rows are one vector long and the correction of gradients is a number: passes that are apart in two and
// three dimensions are one here, and gradients need not go through memory in between.

/// A_i^-1, or 1 where the gradients of a particle cannot be corrected; those are counted in `kept`.
ANVIL_INLINE double invert_line_moment(double moment, int& kept) {
  double inverse = 1.0;
  if (!invert_moment<1>(&moment, &inverse)) ++kept;
  return inverse;
}

/// fill_pairs and correct_gradients in one.
template <class Kernel>
int fill_corrected_line(const PairTile<1>& opened, const PairRecords<1>& records) {
  using L = Lanes<lanes<1>>;
  const PairTile<1> tile = opened;  // these stay in registers while the loop writes
  const auto geometry = records.geometry.rows();
  const auto motion = records.motion.rows();
  double *plain = tile.plain_gradient[0], *corrected = tile.gradient[0];
  int kept = 0;
  for_each_row(tile, [&](std::int32_t i, std::int64_t begin, std::int64_t end) ANVIL_INLINE_LAMBDA {
    const double* own = geometry[static_cast<std::size_t>(i)];
    const std::int64_t first = tile.first[tile.begin];
    L sum(0.0), gradient(0.0);
    for (std::int64_t k = begin; k < end; k += lanes<1>) {
      L place[2], other[2];
      load_record(geometry, tile.neighbour + k, place);
      load_record(motion, tile.neighbour + k, other);
      const L x_ij = L(own[0]) - place[0];
      gradient = line_gradient<Kernel>(x_ij, L(2.0) / (L(own[1]) + place[1]));
      sum -= x_ij * (other[1] * gradient);
      gradient.store(plain + (k - first));
    }
    const double inverse = invert_line_moment(sum.sum(), kept);
    if (tile.correction != nullptr) tile.correction[i - tile.begin] = inverse;
    if (begin == end) return;
    (L(inverse) * gradient).store(corrected + (end - lanes<1> - first));  // the last ones need not be read again
    for (std::int64_t k = begin - first; k < end - lanes<1> - first; k += lanes<1>)
      (L(inverse) * L::load(plain + k)).store(corrected + k);
  });
  return kept;
}

/// dv/dx with corrected gradients, 1/s per particle of the tile: what fill_pairs, correct_gradients and
/// sum_velocity_gradient give, without the gradients.
template <class Kernel>
int sum_line_velocity_gradient(const PairTile<1>& opened, const PairRecords<1>& records, double* out) {
  using L = Lanes<lanes<1>>;
  const PairTile<1> tile = opened;
  const auto geometry = records.geometry.rows();
  const auto motion = records.motion.rows();
  int kept = 0;
  for_each_row(tile, [&](std::int32_t i, std::int64_t begin, std::int64_t end) ANVIL_INLINE_LAMBDA {
    const double* own = geometry[static_cast<std::size_t>(i)];
    const double* moving = motion[static_cast<std::size_t>(i)];
    L moment(0.0), sum(0.0);
    for (std::int64_t k = begin; k < end; k += lanes<1>) {
      L place[2], other[2];
      load_record(geometry, tile.neighbour + k, place);
      load_record(motion, tile.neighbour + k, other);
      const L x_ij = L(own[0]) - place[0];
      const L weighted = other[1] * line_gradient<Kernel>(x_ij, L(2.0) / (L(own[1]) + place[1]));
      moment -= x_ij * weighted;
      sum += (other[0] - L(moving[0])) * weighted;
    }
    out[i - tile.begin] = invert_line_moment(moment.sum(), kept) * sum.sum();
  });
  return kept;
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
