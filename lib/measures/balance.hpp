// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "anvil/measures/result.hpp"

namespace anvil {

/// A column of the history at the start and at the end of the run.
struct BalancePart {
  std::string name;
  double start = 0.0;
  double end = 0.0;
};

/// All energies of the history, J, in its order; total_energy, where losses to viscosity and smoothing are counted in,
/// stands among them.
std::vector<BalancePart> energy_parts(const History& history);

// Shares are relative to the largest value in the run: of total_energy and potential_energy, or of a component of the
// momentum.

/// Change of total_energy from the start to the end less the work of pressures and walls; 0 when energy is accounted
/// for.
double energy_balance(const Result& result);

/// Change of momentum less the impulses of walls, pressures and gravity, largest component: round-off where the method
/// conserves momentum, and what the smoothing of the velocity adds where it does not.
double momentum_balance(const Result& result);

/// What is left when the impulse of the smoothing is subtracted too.
double unexplained_momentum(const Result& result);

/// Energy taken by the smoothing of the velocity.
double smoothing_share(const Result& result);

/// Smallest distance of two particles in the run over the spacing: 1 in a lattice, near 0 when they clump.
double minimum_pair_distance(const Result& result);

/// A column of the history; throws InputError with its name when there is none or no row.
const std::vector<double>& required_column(const History& history, const std::string& name);

}  // namespace anvil
