// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace anvil {

/// A viscous fluid at rest between two plates at y = 0 and y = width, driven along them from t = 0 on by a constant
/// acceleration: the start of Poiseuille's flow (Morris, Fox and Zhu 1997, equation 28).
struct PoiseuilleFlow {
  double acceleration;         // m/s2
  double kinematic_viscosity;  // m2/s
  double width;                // m

  /// Along the plates, m/s; summed until the terms are below rounding.
  [[nodiscard]] double velocity(double y, double time) const;
};

}  // namespace anvil
