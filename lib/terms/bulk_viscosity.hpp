// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <span>

#include "anvil/core/field_keys.hpp"
#include "anvil/core/fields.hpp"
#include "anvil/core/particle_range.hpp"

namespace anvil {

/// A pressure against the rate of compression, q = rho l (b1 c + b2^2 l |d|) |d| where d = div v < 0, zero where
/// material expands (von Neumann and Richtmyer 1950; the linear part Landshoff 1955), with l the spacing as it is
/// squeezed and c the bulk speed of sound. It works on a particle alone, whatever the sums around it. The spacing is
/// that in the direction of the greatest squeeze: a thin layer that closes has a high rate, and with the length it had
/// at the start the viscosity would ask for steps that fall with the square of its thickness.
template <int D>
class BulkViscosity {
 public:
  /// `spacing` at the start, m. Requires the viscous pressure.
  BulkViscosity(FieldStore& fields, double linear, double quadratic, double spacing)
      : linear_(linear),
        quadratic_(quadratic),
        spacing_(spacing),
        mass_(fields.scalar(field::mass)),
        density_(fields.scalar(field::density)),
        reference_density_(density_.begin(), density_.end()),
        viscous_pressure_((fields.require(field::viscous_pressure), fields.scalar(field::viscous_pressure))) {}

  /// New viscous pressures of the range from the velocity gradients (D x D per particle of the range, 1/s), squared
  /// bulk sound speeds (m2/s2) and least stretches, stretch(i) of particle i, of the step of time_step (s) that has
  /// just ended. Returns the work against them, J: each pressure acts from the middle of one step to the middle of the
  /// next and so meets half of both.
  template <class Stretch>
  double update(ParticleRange range, const double* velocity_gradient, const double* sound_speed_squared,
                double time_step, const Stretch& stretch) const {
    double loss = 0.0;
    for (std::size_t i = range.first(); i < range.last(); ++i, velocity_gradient += D * D) {
      double divergence = 0.0;
      for (int a = 0; a < D; ++a) divergence += velocity_gradient[a * (D + 1)];
      const double length = spacing_ * stretch(i);
      const double rate = divergence < 0.0 ? -divergence : 0.0;
      const double sound_speed = std::sqrt(*sound_speed_squared++);
      const double before = viscous_pressure_[i];
      viscous_pressure_[i] =
          density_[i] * length * rate * (linear_ * sound_speed + quadratic_ * quadratic_ * length * rate);
      loss -= 0.5 * (before + viscous_pressure_[i]) * divergence * time_step * mass_[i] / density_[i];
    }
    return loss;
  }

  /// Of a particle that deforms evenly, which its density tells.
  [[nodiscard]] double even_stretch(std::size_t i) const {
    const double volume_ratio = reference_density_[i] / density_[i];
    if constexpr (D == 1) return volume_ratio;
    return D == 2 ? std::sqrt(volume_ratio) : std::cbrt(volume_ratio);
  }

 private:
  double linear_, quadratic_, spacing_;
  std::span<const double> mass_, density_;
  std::vector<double> reference_density_;
  std::span<double> viscous_pressure_;
};

}  // namespace anvil
