// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/pairs/lane_loop.hpp"
#include "anvil/pairs/records.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

/// Least admitted value of the mean eigenvalue of the moment A and of det A over its D-th power. A is about the unit
/// matrix inside a body, has an eigenvalue of 1/2 at a flat face and 1/8 in all at a corner; below the threshold the
/// particle has lost its neighbours or they stand in one line or plane.
inline constexpr double least_moment = 1e-2;

/// Inverse of the symmetric moment, packed as XX | XX YY XY | XX YY ZZ XY YZ XZ; false when it is ill-conditioned.
template <int D>
ANVIL_INLINE bool invert_moment(const double* a, double* inverse) {
  if constexpr (D == 1) {
    if (!(a[0] > least_moment)) return false;
    inverse[0] = 1.0 / a[0];
  } else if constexpr (D == 2) {
    const double mean = 0.5 * (a[0] + a[1]), determinant = a[0] * a[1] - a[2] * a[2];
    if (!(mean > least_moment) || !(determinant > least_moment * mean * mean)) return false;
    inverse[0] = a[1] / determinant;
    inverse[1] = a[0] / determinant;
    inverse[2] = -a[2] / determinant;
  } else {
    const double mean = (a[0] + a[1] + a[2]) / 3.0;
    const double xx = a[1] * a[2] - a[4] * a[4], xy = a[4] * a[5] - a[3] * a[2], xz = a[3] * a[4] - a[1] * a[5];
    const double determinant = a[0] * xx + a[3] * xy + a[5] * xz;
    if (!(mean > least_moment) || !(determinant > least_moment * mean * mean * mean)) return false;
    inverse[0] = xx / determinant;
    inverse[1] = (a[0] * a[2] - a[5] * a[5]) / determinant;
    inverse[2] = (a[0] * a[1] - a[3] * a[3]) / determinant;
    inverse[3] = xy / determinant;
    inverse[4] = (a[3] * a[5] - a[0] * a[4]) / determinant;
    inverse[5] = xz / determinant;
  }
  return true;
}

/// Writes tile.gradient = A_i^-1 tile.plain_gradient with A_i = sum_j V_j (x_j - x_i) (x) grad_ij, after which
/// sum_j V_j (f_j - f_i) grad_ij is exact for linear f (Chen, Beraun and Jih 1999; Bonet and Lok 1999). A is symmetric
/// since gradients lie along x_ij. Returns how many particles kept the plain gradient because their A cannot be
/// inverted.
template <int D>
int correct_gradients(const PairTile<D>& opened, const PairRecords<D>& records) {
  using L = Lanes<lanes<D>>;
  const PairTile<D> tile = opened;  // these stay in registers while the loop writes
  const auto geometry = records.geometry.rows();
  const auto velocities = records.motion.rows();
  constexpr int components = symmetric_components<D>;
  constexpr int row_of[] = {0, 1, D == 2 ? 0 : 2, 0, 1, 0}, column_of[] = {0, 1, D == 2 ? 1 : 2, 1, 2, 2};
  int kept = 0;
  for_each_row(tile, [&](std::int32_t i, std::int64_t begin, std::int64_t end) ANVIL_INLINE_LAMBDA {
    const double* own = geometry[static_cast<std::size_t>(i)];
    L sum[components];
    for (auto& component : sum) component = L(0.0);
    for (std::int64_t k = begin; k < end; k += lanes<D>) {
      L place[PairRecords<D>::small], motion[PairRecords<D>::small];
      load_record(geometry, tile.neighbour + k, place);
      load_record(velocities, tile.neighbour + k, motion);
      const std::int64_t at = k - tile.first[tile.begin];
      for (int c = 0; c < components; ++c) {
        const L weighted = motion[D] * L::load(tile.plain_gradient[static_cast<std::size_t>(column_of[c])] + at);
        sum[c] += (place[row_of[c]] - L(own[row_of[c]])) * weighted;
      }
    }
    double moment[components], inverse[6] = {1.0, 1.0, D == 2 ? 0.0 : 1.0};
    for (int c = 0; c < components; ++c) moment[c] = sum[c].sum();
    if (!invert_moment<D>(moment, inverse)) ++kept;
    if (tile.correction != nullptr)
      for (int c = 0; c < components; ++c) tile.correction[(i - tile.begin) * components + c] = inverse[c];
    for (std::int64_t k = begin; k < end; k += lanes<D>) {
      const std::int64_t at = k - tile.first[tile.begin];
      L plain[D], corrected[D];
      for (std::size_t b = 0; b < D; ++b) {
        plain[b] = L::load(tile.plain_gradient[b] + at);
        corrected[b] = L(0.0);
      }
      for (int c = 0; c < components; ++c) {
        const int a = row_of[c], b = column_of[c];
        corrected[a] += L(inverse[c]) * plain[b];
        if (a != b) corrected[b] += L(inverse[c]) * plain[a];
      }
      for (std::size_t b = 0; b < D; ++b) corrected[b].store(tile.gradient[b] + at);
    }
  });
  return kept;
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
