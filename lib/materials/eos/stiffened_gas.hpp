// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/core/inline.hpp"
#include "anvil/scene/key.hpp"

namespace anvil {

/// p = c0^2 (rho - rho0) + (gamma - 1) rho e (Harlow and Amsden 1971; Menikoff and Plohr 1989).
class StiffenedGas {
 public:
  static EntryKind kind() {
    return {.type = "stiffened_gas",
            .summary = "p = c0^2 (rho - rho0) + (gamma - 1) rho e",
            .keys = {{.name = "sound_speed", .unit = "m/s", .range = Range::positive, .help = "c0, at rest"},
                     {.name = "gamma", .range = Range::positive, .help = "ratio of specific heats, above 1"}}};
  }
  static constexpr bool uses_energy = true;

  StiffenedGas(const Parameters& parameters, double reference_density)
      : reference_density_(reference_density),
        slope_(parameters.number("sound_speed") * parameters.number("sound_speed")),
        excess_(parameters.number("gamma") - 1.0) {}

  ANVIL_INLINE double pressure(double density, double energy) const {
    return slope_ * (density - reference_density_) + excess_ * density * energy;
  }
  ANVIL_INLINE double bulk_sound_speed_squared(double density, double energy) const {
    return slope_ + excess_ * (energy + pressure(density, energy) / density);
  }
  ANVIL_INLINE double energy_derivative(double density, double /*energy*/) const { return excess_ * density; }

 private:
  double reference_density_;  // kg/m3
  double slope_;              // c0^2, m2/s2
  double excess_;             // gamma - 1
};

}  // namespace anvil
