// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/points/point_lanes.hpp"
#include "anvil/points/point_loops.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

/// Deformation::advance.
template <int D>
void advance_deformation(ParticleRange range, double* gradients, double time_step,
                         const DeformationArrays<D>& particles) {
  using L = PointLanes;
  const L half_step(0.5 * time_step);
  double* const own = gradients - static_cast<std::ptrdiff_t>(range.begin) * D * D;  // by particle
  for_each_batch(range.begin, range.end, [&](const Batch& batch, int) ANVIL_INLINE_LAMBDA {
    L sum[D * D], correction[D * D], f[D * D], rate[D * D], middle[D * D], c[D * D];
    load_fields<D * D>(own, D * D, batch.point, sum);
    load_fields<D * D>(particles.correction, D * D, batch.point, correction);
    load_fields<D * D>(particles.gradient, D * D, batch.point, f);
    multiply<D>(sum, correction, rate);
    for (int k = 0; k < D * D; ++k) middle[k] = f[k] + half_step * rate[k];
    find_cofactor<D>(middle, c);
    multiply_transposed<D>(rate, c, sum);
    const L inverse = L(1.0) / find_determinant<D>(middle, c);
    for (int k = 0; k < D * D; ++k) sum[k] = sum[k] * inverse;
    for (int k = 0; k < D * D; ++k) f[k] = middle[k] + half_step * rate[k];
    find_cofactor<D>(f, c);
    store_fields<D * D>(sum, own, D * D, batch.point);
    store_fields<D * D>(f, particles.gradient, D * D, batch.point);
    store_each(load_each(particles.reference_density, batch) / find_determinant<D>(f, c), particles.density, batch);
  });
}

/// Deformation::find_least_stretches.
template <int D>
void find_least_stretches(ParticleRange range, const DeformationArrays<D>& particles, double* stretch) {
  using L = PointLanes;
  double* const own = stretch - range.begin;  // by particle
  for_each_batch(range.begin, range.end, [&](const Batch& batch, int) ANVIL_INLINE_LAMBDA {
    L f[D * D], c[D * D];
    load_fields<D * D>(particles.gradient, D * D, batch.point, f);
    find_cofactor<D>(f, c);
    L square = c[0] * c[0];
    for (int k = 1; k < D * D; ++k) square += c[k] * c[k];
    store_each(find_determinant<D>(f, c) * sqrt(L(D) / square), own, batch);
  });
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
