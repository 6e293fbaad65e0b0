// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numbers>

#include "anvil/core/inline.hpp"

namespace anvil {

// Forces between a particle and a dummy particle of a wall at the distance r (m), by which the wall repels. A law gives
// the acceleration of the particle and the energy per mass that the force has stored, both for a dummy of `volume` and
// a particle of `density`.

/// The long-range force of peridynamics (Zhou 2017): f = beta c0 (1 - q^2)^2 (1 - q) per volume of both, q = r/reach;
/// c0 makes the bond force of a solid of bulk modulus K and Poisson's ratio 1/4 store the energy of an elastic one.
class PeridynamicForce {
 public:
  /// `dimension` 2 (plane strain) or 3, K in Pa, `horizon` delta and `reach` = a h in m.
  PeridynamicForce(int dimension, double bulk_modulus, double horizon, double strength, double reach)
      : factor_(strength * micromodulus(dimension, bulk_modulus, horizon)), reach_(reach) {}

  static double micromodulus(int dimension, double bulk_modulus, double horizon) {
    const double cubed = horizon * horizon * horizon * std::numbers::pi;
    return dimension == 3 ? 108.0 * bulk_modulus / (cubed * horizon) : 63.0 * bulk_modulus / cubed;
  }
  [[nodiscard]] double reach() const { return reach_; }
  [[nodiscard]] ANVIL_INLINE double acceleration(double distance, double volume, double density) const {
    const double q = distance / reach_, factor = 1.0 - q * q;
    return factor_ * factor * factor * (1.0 - q) * volume / density;
  }
  /// The integral of the force from `distance` to the reach.
  [[nodiscard]] ANVIL_INLINE double energy(double distance, double volume, double density) const {
    const auto integral = [](double q) {
      return q * (1.0 - q * (1.0 / 2.0 + q * (2.0 / 3.0 - q * (1.0 / 2.0 + q * (1.0 / 5.0 - q / 6.0)))));
    };
    return factor_ * reach_ * (integral(1.0) - integral(distance / reach_)) * volume / density;
  }

 private:
  double factor_;  // beta c0, N/m^(2 D)
  double reach_;   // m
};

/// The repulsion of Monaghan (1994), a part of the Lennard-Jones force: D/r ((r0/r)^4 - (r0/r)^2) per mass.
class MonaghanRepulsion {
 public:
  /// `coefficient` D in m2/s2, `reach` r0 in m.
  MonaghanRepulsion(double coefficient, double reach) : coefficient_(coefficient), reach_(reach) {}

  [[nodiscard]] double reach() const { return reach_; }
  [[nodiscard]] ANVIL_INLINE double acceleration(double distance, double /*volume*/, double /*density*/) const {
    const double square = reach_ * reach_ / (distance * distance);
    return coefficient_ / distance * square * (square - 1.0);
  }
  [[nodiscard]] ANVIL_INLINE double energy(double distance, double /*volume*/, double /*density*/) const {
    const double square = reach_ * reach_ / (distance * distance);
    return 0.25 * coefficient_ * (square - 1.0) * (square - 1.0);
  }

 private:
  double coefficient_;  // m2/s2
  double reach_;        // m
};

}  // namespace anvil
