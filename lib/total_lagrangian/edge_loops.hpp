// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/points/point_lanes.hpp"
#include "anvil/points/point_loops.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

/// EdgePoints::deform.
template <int D>
std::int32_t deform_edges(ParticleRange edges, const EdgeArrays<D>& of, const DeformationArrays<D>& particles,
                          double time_step, double* velocity_gradients) {
  using L = PointLanes;
  const L per_step(time_step > 0.0 ? 1.0 / time_step : 0.0), half(0.5);
  double* const own = velocity_gradients - static_cast<std::ptrdiff_t>(edges.begin) * D * D;  // by edge
  std::int32_t turned = -1;
  for_each_batch(edges.begin, edges.end, [&](const Batch& batch, int count) ANVIL_INLINE_LAMBDA {
    std::int32_t i[point_lanes], j[point_lanes];
    for (int lane = 0; lane < point_lanes; ++lane) {
      i[lane] = of.first[batch.point[lane]];
      j[lane] = of.second[batch.point[lane]];
    }
    L shape[EdgeArrays<D>::shape_size], f[D * D], along[D], kept[D * D];
    load_fields<EdgeArrays<D>::shape_size>(of.shape, EdgeArrays<D>::shape_size, batch.point, shape);
    load_combined<D * D>(particles.gradient, D * D, i, j, f,
                         [&](L a, L b) ANVIL_INLINE_LAMBDA { return half * (a + b); });
    load_combined<D>(of.position, D, i, j, along, [](L a, L b) ANVIL_INLINE_LAMBDA { return a - b; });
    for (int a = 0; a < D; ++a) {
      along[a] = along[a] * shape[D];
      for (int b = 0; b < D; ++b) along[a] -= f[a * D + b] * shape[b];
    }
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) f[a * D + b] += along[a] * shape[b];
    load_fields<D * D>(of.gradient, D * D, batch.point, kept);
    store_fields<D * D>(f, of.gradient, D * D, batch.point);
    L rate[D * D], middle[D * D], c[D * D];
    find_cofactor<D>(f, c);
    const L volume_ratio = find_determinant<D>(f, c);
    store_each(load_each(particles.reference_density, i) / volume_ratio, of.density, batch);
    for (int k = 0; k < D * D; ++k) {
      rate[k] = per_step * (f[k] - kept[k]);
      middle[k] = half * (f[k] + kept[k]);
    }
    find_cofactor<D>(middle, c);
    multiply_transposed<D>(rate, c, f);
    const L inverse = L(1.0) / find_determinant<D>(middle, c);
    for (int k = 0; k < D * D; ++k) f[k] = f[k] * inverse;
    store_fields<D * D>(f, own, D * D, batch.point);
    const std::uint32_t sound = (L(0.0) < volume_ratio).bits();
    for (int lane = 0; lane < count; ++lane)
      if ((sound >> lane & 1U) == 0 && turned < 0) turned = batch.point[lane];
  });
  return turned;
}

/// EdgePoints::pull_back.
template <int D>
void pull_back_edges(ParticleRange edges, const EdgeArrays<D>& of) {
  using L = PointLanes;
  const L half(0.5);
  for_each_batch(edges.begin, edges.end, [&](const Batch& batch, int) ANVIL_INLINE_LAMBDA {
    constexpr int shape_size = EdgeArrays<D>::shape_size, force_size = EdgeArrays<D>::force_size;
    L shape[shape_size], f[D * D], c[D * D], packed[packed_size<D>], deviator[D * D], nominal[D * D], force[force_size];
    load_fields<shape_size>(of.shape, shape_size, batch.point, shape);
    load_fields<D * D>(of.gradient, D * D, batch.point, f);
    load_fields<packed_size<D>>(of.deviator, packed_size<D>, batch.point, packed);
    for (int k = 0; k < packed_size<D>; ++k) packed[k] = packed[k] * shape[D + 1];
    unpack_symmetric<D>(packed, deviator);
    find_cofactor<D>(f, c);
    multiply<D>(deviator, c, nominal);
    for (int a = 0; a < D; ++a) {
      L along = nominal[a * D] * shape[0];
      for (int b = 1; b < D; ++b) along += nominal[a * D + b] * shape[b];
      for (int b = 0; b < D; ++b) force[a * D + b] = half * (nominal[a * D + b] - along * shape[b]);
      force[D * D + a] = along * shape[D];
    }
    store_fields<force_size>(force, of.force, force_size, batch.point);
  });
}

/// EdgePoints::sum_forces. Lanes are fields here: each particle has edges of its own.
template <int D>
void sum_edge_forces(ParticleRange range, const EdgeArrays<D>& of, double* sums) {
  constexpr int size = EdgeArrays<D>::force_size;
  constexpr int block = point_lanes > 1 && size % point_lanes == 0 ? point_lanes : (point_lanes > 1 ? 2 : 1);
  using L = Lanes<block>;
  for (std::int32_t i = range.begin; i < range.end; ++i) {
    L begun[size / block], ended[size / block];
    for (int k = 0; k < size / block; ++k) begun[k] = ended[k] = L(0.0);
    const auto add = [&](std::int32_t edge, L* sum) ANVIL_INLINE_LAMBDA {
      const double* force = of.force + static_cast<std::ptrdiff_t>(edge) * size;
      for (int k = 0; k < size / block; ++k) sum[k] += L::load(force + k * block);
    };
    for (std::int32_t edge = of.first_edge[i]; edge < of.first_edge[i + 1]; ++edge) add(edge, begun);
    for (std::int32_t k = of.first_incoming[i]; k < of.first_incoming[i + 1]; ++k) add(of.incoming[k], ended);
    double share[size], pull[size];
    for (int k = 0; k < size / block; ++k) {
      (begun[k] + ended[k]).store(share + k * block);
      (ended[k] - begun[k]).store(pull + k * block);
    }
    double* sum = sums + static_cast<std::ptrdiff_t>(i) * size;
    for (int k = 0; k < size; ++k) sum[k] = k < D * D ? share[k] : pull[k];
  }
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
