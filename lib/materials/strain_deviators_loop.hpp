// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/points/point_lanes.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

/// The rotation of one step about the spin of the velocity gradients: see spin_rotation.
template <int D>
ANVIL_INLINE void find_rotation(const PointLanes* gradient, double time_step, PointLanes* rotation) {
  using L = PointLanes;
  const L quarter(0.25 * time_step), one(1.0);
  if constexpr (D == 1) {
    rotation[0] = one;
  } else if constexpr (D == 2) {
    const L z = quarter * (gradient[2] - gradient[1]);
    const L factor = L(2.0) / (one + z * z);
    rotation[0] = rotation[3] = one - factor * z * z;
    rotation[2] = factor * z;
    rotation[1] = -rotation[2];
  } else {
    const L x = quarter * (gradient[7] - gradient[5]), y = quarter * (gradient[2] - gradient[6]),
            z = quarter * (gradient[3] - gradient[1]);
    const L factor = L(2.0) / (one + x * x + y * y + z * z);
    const L fx = factor * x, fy = factor * y, fz = factor * z;
    const L xx = fx * x, yy = fy * y, zz = fz * z, xy = fx * y, yz = fy * z, xz = fx * z;
    rotation[0] = one - (yy + zz);
    rotation[4] = one - (xx + zz);
    rotation[8] = one - (xx + yy);
    rotation[1] = xy - fz;
    rotation[3] = xy + fz;
    rotation[2] = xz + fy;
    rotation[6] = xz - fy;
    rotation[5] = yz - fx;
    rotation[7] = yz + fx;
  }
}

/// R t R^T of packed tensors, in place.
template <int D>
ANVIL_INLINE void turn(const PointLanes* rotation, PointLanes* packed) {
  if constexpr (D > 1) {
    constexpr int row[] = {0, 1, D == 2 ? 0 : 2, 0, 1, 0}, column[] = {0, 1, D == 2 ? 1 : 2, 1, 2, 2};
    PointLanes full[D * D], half_turned[D * D];
    unpack_symmetric<D>(packed, full);
    multiply<D>(rotation, full, half_turned);
    for (int c = 0; c < packed_size<D>; ++c) {
      const PointLanes *left = half_turned + row[c] * D, *right = rotation + column[c] * D;
      packed[c] = left[0] * right[0];
      for (int k = 1; k < D; ++k) packed[c] += left[k] * right[k];
    }
  }
}

/// See PointLoops. Half of the increment turns with what was there before: the rate's sum to second order.
template <int D>
void strain_deviators(int count, const double* velocity_gradient, double shear_modulus, double time_step,
                      double* deviator) {
  for_each_batch(0, count, [&](const Batch& batch, int) ANVIL_INLINE_LAMBDA {
    using L = PointLanes;
    L gradient[D * D], stress[packed_size<D>], half[packed_size<D>], rotation[D * D];
    load_fields<D * D>(velocity_gradient, D * D, batch.point, gradient);
    load_fields<packed_size<D>>(deviator, packed_size<D>, batch.point, stress);
    L mean = gradient[0];
    for (int a = 1; a < D; ++a) mean += gradient[a * (D + 1)];
    mean = mean * L(1.0 / 3.0);
    const L stretch(shear_modulus * time_step), shear(0.5 * shear_modulus * time_step);
    for (int a = 0; a < D; ++a) half[a] = stretch * (gradient[a * (D + 1)] - mean);
    if constexpr (D == 2) half[2] = shear * (gradient[1] + gradient[2]);
    if constexpr (D == 3) {
      half[3] = shear * (gradient[1] + gradient[3]);
      half[4] = shear * (gradient[5] + gradient[7]);
      half[5] = shear * (gradient[2] + gradient[6]);
    }
    find_rotation<D>(gradient, time_step, rotation);
    for (int c = 0; c < packed_size<D>; ++c) stress[c] += half[c];
    turn<D>(rotation, stress);
    for (int c = 0; c < packed_size<D>; ++c) stress[c] += half[c];
    store_fields<packed_size<D>>(stress, deviator, packed_size<D>, batch.point);
  });
}

template <int D>
void turn_tensors(int count, const double* velocity_gradient, double time_step, double* tensor) {
  for_each_batch(0, count, [&](const Batch& batch, int) ANVIL_INLINE_LAMBDA {
    PointLanes gradient[D * D], packed[packed_size<D>], rotation[D * D];
    load_fields<D * D>(velocity_gradient, D * D, batch.point, gradient);
    load_fields<packed_size<D>>(tensor, packed_size<D>, batch.point, packed);
    find_rotation<D>(gradient, time_step, rotation);
    turn<D>(rotation, packed);
    store_fields<packed_size<D>>(packed, tensor, packed_size<D>, batch.point);
  });
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
