// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/core/inline.hpp"
#include "anvil/core/tensor.hpp"
#include "anvil/materials/strength/strength_law.hpp"

namespace anvil {

/// The rotation of one step, R = (I - dt W / 2)^-1 (I + dt W / 2) with the spin W, the antisymmetric part of the
/// velocity gradient (Hughes and Winget 1980). Orthogonal to round-off for any step, by the closed form of
/// the Cayley transform: with w the axial vector of dt W / 2, R = I + 2 / (1 + w.w) ([w] + [w]^2).
ANVIL_INLINE Tensor spin_rotation(const Tensor& velocity_gradient, double dt) {
  const Tensor& grad = velocity_gradient;
  const double x = 0.25 * dt * (grad(2, 1) - grad(1, 2));
  const double y = 0.25 * dt * (grad(0, 2) - grad(2, 0));
  const double z = 0.25 * dt * (grad(1, 0) - grad(0, 1));
  const double factor = 2.0 / (1.0 + x * x + y * y + z * z);
  Tensor rotation;
  rotation(0, 0) = 1.0 - factor * (y * y + z * z);
  rotation(1, 1) = 1.0 - factor * (x * x + z * z);
  rotation(2, 2) = 1.0 - factor * (x * x + y * y);
  rotation(0, 1) = factor * (x * y - z);
  rotation(1, 0) = factor * (x * y + z);
  rotation(0, 2) = factor * (x * z + y);
  rotation(2, 0) = factor * (x * z - y);
  rotation(1, 2) = factor * (y * z - x);
  rotation(2, 1) = factor * (y * z + x);
  return rotation;
}

/// R t R^T of a symmetric tensor, symmetric to the last bit. Written out: loops over small arrays keep them in memory.
ANVIL_INLINE Tensor rotate_symmetric(const Tensor& rotation, const Tensor& tensor) {
  const Tensor& r = rotation;
  const double xx = tensor(0, 0), yy = tensor(1, 1), zz = tensor(2, 2);
  const double xy = tensor(0, 1), yz = tensor(1, 2), xz = tensor(0, 2);
  // Rows of R t.
  const double x0 = r(0, 0) * xx + r(0, 1) * xy + r(0, 2) * xz;
  const double x1 = r(0, 0) * xy + r(0, 1) * yy + r(0, 2) * yz;
  const double x2 = r(0, 0) * xz + r(0, 1) * yz + r(0, 2) * zz;
  const double y0 = r(1, 0) * xx + r(1, 1) * xy + r(1, 2) * xz;
  const double y1 = r(1, 0) * xy + r(1, 1) * yy + r(1, 2) * yz;
  const double y2 = r(1, 0) * xz + r(1, 1) * yz + r(1, 2) * zz;
  const double z0 = r(2, 0) * xx + r(2, 1) * xy + r(2, 2) * xz;
  const double z1 = r(2, 0) * xy + r(2, 1) * yy + r(2, 2) * yz;
  const double z2 = r(2, 0) * xz + r(2, 1) * yz + r(2, 2) * zz;
  Tensor rotated;
  rotated(0, 0) = x0 * r(0, 0) + x1 * r(0, 1) + x2 * r(0, 2);
  rotated(1, 1) = y0 * r(1, 0) + y1 * r(1, 1) + y2 * r(1, 2);
  rotated(2, 2) = z0 * r(2, 0) + z1 * r(2, 1) + z2 * r(2, 2);
  rotated(0, 1) = rotated(1, 0) = x0 * r(1, 0) + x1 * r(1, 1) + x2 * r(1, 2);
  rotated(0, 2) = rotated(2, 0) = x0 * r(2, 0) + x1 * r(2, 1) + x2 * r(2, 2);
  rotated(1, 2) = rotated(2, 1) = y0 * r(2, 0) + y1 * r(2, 1) + y2 * r(2, 2);
  return rotated;
}

/// dt dev(D), D the symmetric part of the velocity gradient.
ANVIL_INLINE Tensor deviatoric_strain_increment(const Tensor& velocity_gradient, double dt) {
  const Tensor& grad = velocity_gradient;
  const double mean = (grad(0, 0) + grad(1, 1) + grad(2, 2)) * (1.0 / 3.0);
  Tensor increment;
  for (int a = 0; a < 3; ++a) {
    increment(a, a) = dt * (grad(a, a) - mean);
    for (int b = a + 1; b < 3; ++b) {
      increment(a, b) = 0.5 * dt * (grad(a, b) + grad(b, a));
      increment(b, a) = increment(a, b);
    }
  }
  return increment;
}

/// Adds 2 G dt dev(D) of a velocity gradient without shear: a compiler may not leave out what is times zero.
ANVIL_INLINE void stretch(double shear_modulus, const Tensor& velocity_gradient, double dt, Tensor& deviator) {
  const Tensor& grad = velocity_gradient;
  const double mean = (grad(0, 0) + grad(1, 1) + grad(2, 2)) * (1.0 / 3.0);
  for (int a = 0; a < 3; ++a) deviator(a, a) += 2.0 * (shear_modulus * (dt * (grad(a, a) - mean)));
}

/// One particle, one step: the Jaumann rate s_dot = 2 G dev(D) + W s - s W in the form s = R s R^T + 2 G dt dev(D),
/// which equals the rate's sum to second order in dt but does not let stress grow when the material merely turns; the
/// back stress turns with it. Then the return to the yield surface.
///
/// `deviator` in Pa, symmetric and traceless, is updated in place. `velocity_gradient(a, b)` is dv_a/dx_b in 1/s, at
/// the middle of the step for second order; `dt` in s. Two-dimensional and one-dimensional scenes pass zeros out of
/// plane. Without `Turns` there is neither spin nor shear, as in one dimension.
template <bool Turns = true, class Strength>
ANVIL_INLINE PlasticStep update_deviator(const Strength& strength, Tensor& deviator, StrengthHistory& history,
                                         const Tensor& velocity_gradient, double dt) {
  if constexpr (Strength::resists_shear) {
    if constexpr (!Turns) {
      stretch(strength.shear_modulus(), velocity_gradient, dt, deviator);
      return strength.return_to_yield(deviator, history);
    }
    const Tensor half_increment = strength.shear_modulus() * deviatoric_strain_increment(velocity_gradient, dt);
    const Tensor rotation = spin_rotation(velocity_gradient, dt);
    deviator = rotate_symmetric(rotation, deviator + half_increment) + half_increment;
    if (strength.has_back_stress()) history.back_stress = rotate_symmetric(rotation, history.back_stress);
  }
  return strength.return_to_yield(deviator, history);
}

}  // namespace anvil
