// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace anvil {

/// Of the artificial viscosity of Monaghan and Gingold: alpha, beta and eps.
struct ViscosityCoefficients {
  double linear = 1.0;
  double quadratic = 1.0;
  double softening = 0.1;
};

/// The gradient hllc sums its stress with.
enum class PairGradient {
  plain,        // grad_ij
  corrected,    // L_i grad_ij, the scene method's: exact for linear stress, but unlike for the two sides of a pair
  symmetrised,  // (L_i + L_j)/2 grad_ij: keeps momentum and energy as plain ones do
};

/// What hllc does with its pairs.
struct HllcChoices {
  PairGradient gradient = PairGradient::plain;
  bool reconstructs = true;  // states at the middle of the pair instead of those of the particles
};

/// Where a tile's sums of hllc go: D, 1 and D x D per particle of the tile.
struct HllcSums {
  double* acceleration;   // m/s2
  double* power;          // W/kg
  double* star_gradient;  // 1/s
};

}  // namespace anvil
