// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace anvil {

/// Of the artificial viscosity of Monaghan and Gingold: alpha, beta and eps.
struct ViscosityCoefficients {
  double linear = 1.0;
  double quadratic = 1.0;
  double softening = 0.1;
};

}  // namespace anvil
