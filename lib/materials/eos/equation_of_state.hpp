// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>

#include "anvil/scene/key.hpp"

namespace anvil {

/// What an equation of state offers. `density` in kg/m3, `energy` the specific internal energy in J/kg, which a law
/// reads only if `uses_energy`: without it a run keeps no energy field, and any number may be passed. Pressure is
/// positive in compression, in Pa. A law is made from its keys and the reference density.
///
/// bulk_sound_speed_squared, in m2/s2, is dp/drho along the isentrope, p_rho + (p / rho^2) p_e. With shear the
/// longitudinal speed squared is that plus 4 G / (3 rho).
///
/// A law whose pressure depends on density alone also offers `double cold_energy(double density)`, the energy stored by
/// compression from the reference density in J/kg, of which p / rho^2 is the derivative. One that reads the energy
/// offers `double energy_derivative(double density, double energy)`, dp/de at constant density in kg/m3.
template <class E>
concept EquationOfState = std::constructible_from<E, const Parameters&, double> &&
    requires(const E& law, double density, double energy) {
  { E::kind() } -> std::same_as<EntryKind>;
  { E::uses_energy } -> std::convertible_to<bool>;
  { law.pressure(density, energy) } -> std::same_as<double>;
  { law.bulk_sound_speed_squared(density, energy) } -> std::same_as<double>;
};

template <class E>
concept HasColdEnergy = requires(const E& law, double density) {
  { law.cold_energy(density) } -> std::same_as<double>;
};

template <class E>
concept HasEnergyDerivative = requires(const E& law, double density, double energy) {
  { law.energy_derivative(density, energy) } -> std::same_as<double>;
};

}  // namespace anvil
