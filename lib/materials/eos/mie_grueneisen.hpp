// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/core/inline.hpp"
#include "anvil/scene/key.hpp"

namespace anvil {

/// Mie-Grueneisen with the Hugoniot shock speed = a0 + s * particle speed and rho * Grueneisen coefficient constant
/// (Menikoff 2007): p = rho0 a0^2 f(eta) + rho0 G0 e with eta = rho / rho0 and
/// f = (eta - 1) [eta - G0 (eta - 1) / 2] / [eta - s (eta - 1)]^2.
class MieGrueneisen {
 public:
  static EntryKind kind() {
    return {
        .type = "mie_grueneisen",
        .summary = "Mie-Grueneisen on the Hugoniot U = a0 + s u",
        .keys = {{.name = "sound_speed", .unit = "m/s", .range = Range::positive, .help = "a0, at rest"},
                 {.name = "slope", .range = Range::not_negative, .help = "s, shock speed over particle speed"},
                 {.name = "grueneisen", .range = Range::not_negative, .help = "Grueneisen coefficient G0, at rest"}}};
  }
  static constexpr bool uses_energy = true;

  MieGrueneisen(const Parameters& parameters, double reference_density)
      : reference_density_(reference_density),
        slope_squared_(parameters.number("sound_speed") * parameters.number("sound_speed")),
        hugoniot_slope_(parameters.number("slope")),
        grueneisen_(parameters.number("grueneisen")) {}

  ANVIL_INLINE double pressure(double density, double energy) const {
    const double eta = density / reference_density_, excess = eta - 1.0;
    const double denominator = eta - hugoniot_slope_ * excess;
    const double cold = excess * (eta - 0.5 * grueneisen_ * excess) / (denominator * denominator);
    return reference_density_ * (slope_squared_ * cold + grueneisen_ * energy);
  }

  ANVIL_INLINE double bulk_sound_speed_squared(double density, double energy) const {
    const double eta = density / reference_density_, excess = eta - 1.0;
    const double denominator = eta - hugoniot_slope_ * excess;
    const double numerator = excess * (eta - 0.5 * grueneisen_ * excess);
    const double numerator_slope = eta - 0.5 * grueneisen_ * excess + excess * (1.0 - 0.5 * grueneisen_);
    const double cold_slope =
        (numerator_slope - 2.0 * numerator * (1.0 - hugoniot_slope_) / denominator) / (denominator * denominator);
    return slope_squared_ * cold_slope +
           pressure(density, energy) / (density * density) * energy_derivative(density, energy);
  }

  ANVIL_INLINE double energy_derivative(double /*density*/, double /*energy*/) const {
    return reference_density_ * grueneisen_;
  }

 private:
  double reference_density_;  // kg/m3
  double slope_squared_;      // a0^2, m2/s2
  double hugoniot_slope_;     // s
  double grueneisen_;         // G0
};

}  // namespace anvil
