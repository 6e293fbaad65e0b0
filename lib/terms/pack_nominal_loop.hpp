// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/pairs/records.hpp"
#include "anvil/points/point_lanes.hpp"
#include "anvil/points/point_loops.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

/// NominalMomentum::pack_impulses.
template <int D>
void pack_nominal(ParticleRange range, const DeformationArrays<D>& particles, const StressArrays& stresses, double span,
                  double* records) {
  using L = PointLanes;
  constexpr int size = PairRecords<D>::nominal_size;
  for_each_batch(range.begin, range.end, [&](const Batch& batch, int) ANVIL_INLINE_LAMBDA {
    L f[D * D], c[D * D], nominal[D * D], correction[D * D], record[size];
    load_fields<D * D>(particles.gradient, D * D, batch.point, f);
    find_cofactor<D>(f, c);
    L pressure = load_each(stresses.pressure, batch);
    if (stresses.viscous_pressure != nullptr) pressure += load_each(stresses.viscous_pressure, batch);
    if (stresses.deviator != nullptr) {
      L packed[packed_size<D>], stress[D * D];
      load_fields<packed_size<D>>(stresses.deviator, packed_size<D>, batch.point, packed);
      for (int a = 0; a < D; ++a) packed[a] -= pressure;
      unpack_symmetric<D>(packed, stress);
      multiply<D>(stress, c, nominal);
    } else {
      for (int k = 0; k < D * D; ++k) nominal[k] = -pressure * c[k];
    }
    for (int k = 0; k < D * D; ++k) nominal[k] = L(span) * nominal[k];
    const L volume = load_each(particles.volume, batch);
    if (stresses.edge_sums != nullptr) {
      L sum[D * D];
      load_fields<D * D>(stresses.edge_sums, EdgeArrays<D>::force_size, batch.point, sum);
      const L per_volume = L(1.0) / volume;
      for (int k = 0; k < D * D; ++k) nominal[k] += sum[k] * per_volume;
    }
    load_fields<D * D>(particles.correction, D * D, batch.point, correction);
    multiply<D>(nominal, correction, record);
    const L per_density = L(1.0) / load_each(particles.reference_density, batch);
    for (int k = 0; k < D * D; ++k) record[k] = record[k] * per_density;
    record[D * D] = volume;
    for (int k = D * D + 1; k < size; ++k) record[k] = L(0.0);
    store_fields<size>(record, records, size, batch.point);
  });
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
