// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <variant>

namespace anvil {

// Pressure laws of the exact solutions, written apart from those the solver uses so that each checks the other.
// All are p = cold(e) + thermal(e) * energy with e = rho0 / rho - 1 the volume strain (extension positive), energy the
// specific internal energy in J/kg, p in Pa, positive in compression.

/// p = -K e: small strain.
struct PressureLinearInStrain {
  double bulk_modulus;
  [[nodiscard]] double cold(double strain) const { return -bulk_modulus * strain; }
  [[nodiscard]] double thermal(double /*strain*/) const { return 0.0; }
  [[nodiscard]] double bulk_stiffness() const { return bulk_modulus; }
};

/// p = -K ln(rho0 / rho): the rate form dp = -K d(volume strain) with a constant K (Wang 2002).
struct PressureLogarithmic {
  double bulk_modulus;
  [[nodiscard]] double cold(double strain) const { return -bulk_modulus * std::log1p(strain); }
  [[nodiscard]] double thermal(double /*strain*/) const { return 0.0; }
  [[nodiscard]] double bulk_stiffness() const { return bulk_modulus; }
};

/// p = K (rho / rho0 - 1).
struct PressureLinearInDensity {
  double bulk_modulus;
  [[nodiscard]] double cold(double strain) const { return -bulk_modulus * strain / (1.0 + strain); }
  [[nodiscard]] double thermal(double /*strain*/) const { return 0.0; }
  [[nodiscard]] double bulk_stiffness() const { return bulk_modulus; }
};

/// p = c0^2 (rho - rho0) + (gamma - 1) rho energy.
struct PressureStiffenedGas {
  double density;  // rho0, kg/m3
  double sound_speed;
  double gamma;
  [[nodiscard]] double cold(double strain) const {
    return -density * sound_speed * sound_speed * strain / (1.0 + strain);
  }
  [[nodiscard]] double thermal(double strain) const { return (gamma - 1.0) * density / (1.0 + strain); }
  [[nodiscard]] double bulk_stiffness() const { return density * sound_speed * sound_speed; }
};

/// p = rho0 a0^2 f(eta) + rho0 gamma energy, f = (eta - 1) [eta - gamma (eta - 1) / 2] / [eta - s (eta - 1)]^2,
/// eta = rho / rho0: the Hugoniot is shock speed = a0 + s * particle speed.
struct PressureMieGrueneisen {
  double density;  // rho0, kg/m3
  double sound_speed;
  double slope;  // s
  double gamma;
  [[nodiscard]] double cold(double strain) const {
    // Multiplied through by 1 + strain, eta becomes 1 and eta - 1 becomes -strain.
    const double denominator = 1.0 + slope * strain;
    return -density * sound_speed * sound_speed * strain * (1.0 + 0.5 * gamma * strain) / (denominator * denominator);
  }
  [[nodiscard]] double thermal(double /*strain*/) const { return density * gamma; }
  [[nodiscard]] double bulk_stiffness() const { return density * sound_speed * sound_speed; }
};

using PressureLaw = std::variant<PressureLinearInStrain, PressureLogarithmic, PressureLinearInDensity,
                                 PressureStiffenedGas, PressureMieGrueneisen>;

}  // namespace anvil
