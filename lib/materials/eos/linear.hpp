// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "anvil/core/inline.hpp"
#include "anvil/scene/key.hpp"

namespace anvil {

/// p = K (rho / rho0 - 1) (Long 2007; Wang 2002 in rate form, with K held constant).
class LinearEos {
 public:
  static EntryKind kind() {
    return {
        .type = "linear",
        .summary = "p = K (rho / rho0 - 1)",
        .keys = {
            {.name = "bulk_modulus", .unit = "Pa", .range = Range::positive, .help = "K, at the reference density"}}};
  }
  static constexpr bool uses_energy = false;

  LinearEos(const Parameters& parameters, double reference_density)
      : reference_density_(reference_density), slope_(parameters.number("bulk_modulus") / reference_density) {}

  ANVIL_INLINE double pressure(double density, double /*energy*/) const {
    return slope_ * (density - reference_density_);
  }
  ANVIL_INLINE double bulk_sound_speed_squared(double /*density*/, double /*energy*/) const { return slope_; }

  /// K / rho0 (J - 1 - ln J) with J = rho0 / rho; written so that small strains keep their digits.
  ANVIL_INLINE double cold_energy(double density) const {
    const double volume_strain = reference_density_ / density - 1.0;
    return slope_ * (volume_strain - std::log1p(volume_strain));
  }

 private:
  double reference_density_;  // kg/m3
  double slope_;              // dp/drho, m2/s2
};

}  // namespace anvil
