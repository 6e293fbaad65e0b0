// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/core/inline.hpp"
#include "anvil/core/tensor.hpp"

namespace anvil {

// How the few stored components of a dimension stand for a full tensor. Laws always see the full tensor; only what is
// independent is stored, in the order XX | XX YY XY | XX YY ZZ XY YZ XZ.

/// One dimension, no lateral strain: the lateral deviators are each minus half of the axial one.
struct UniaxialStrain {
  static constexpr int dimension = 1, components = 1;
  static ANVIL_INLINE Tensor deviator(const double* stored) {
    Tensor full = Tensor::Zero();
    full(0, 0) = stored[0];
    full(1, 1) = full(2, 2) = -0.5 * stored[0];
    return full;
  }
  static ANVIL_INLINE void store(const Tensor& full, double* stored) { stored[0] = full(0, 0); }
};

/// Two dimensions, no strain out of the plane, where the deviator is minus the sum of the others.
struct PlaneStrain {
  static constexpr int dimension = 2, components = 3;
  static ANVIL_INLINE Tensor deviator(const double* stored) {
    Tensor full = Tensor::Zero();
    full(0, 0) = stored[0];
    full(1, 1) = stored[1];
    full(2, 2) = -stored[0] - stored[1];
    full(0, 1) = full(1, 0) = stored[2];
    return full;
  }
  static ANVIL_INLINE void store(const Tensor& full, double* stored) {
    stored[0] = full(0, 0);
    stored[1] = full(1, 1);
    stored[2] = full(0, 1);
  }
};

/// Three dimensions.
struct FullStrain {
  static constexpr int dimension = 3, components = 6;
  static ANVIL_INLINE Tensor deviator(const double* stored) {
    Tensor full;
    full << stored[0], stored[3], stored[5],  //
        stored[3], stored[1], stored[4],      //
        stored[5], stored[4], stored[2];
    return full;
  }
  static ANVIL_INLINE void store(const Tensor& full, double* stored) {
    stored[0] = full(0, 0);
    stored[1] = full(1, 1);
    stored[2] = full(2, 2);
    stored[3] = full(0, 1);
    stored[4] = full(1, 2);
    stored[5] = full(0, 2);
  }
};

template <int D>
struct StrainStateOf;
template <>
struct StrainStateOf<1> {
  using Type = UniaxialStrain;
};
template <>
struct StrainStateOf<2> {
  using Type = PlaneStrain;
};
template <>
struct StrainStateOf<3> {
  using Type = FullStrain;
};

/// The D x D velocity gradient as a full tensor, zero out of plane.
template <int D>
ANVIL_INLINE Tensor lift_gradient(const double* gradient) {
  Tensor full = Tensor::Zero();
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) full(a, b) = gradient[a * D + b];
  return full;
}

}  // namespace anvil
