// SPDX-License-Identifier: BSD-3-Clause
// Internal energy in a step. Without pairs that exchange it, the energy of a particle is the work of its stress (see
// EosUpdate) and the heat of the viscosity, all at the time of the positions. A pair term that exchanges energy gives
// each particle the power F_ij . u_ij of its pairs at a velocity common to both sides; less the power the forces have
// on the particle's own mean velocity over the kick, that is its internal energy. As both sides of a pair see the same
// velocity and opposite forces, the sum of kinetic and internal energy is then kept to round-off, whatever the step.
// Such an energy belongs to the time of the velocities; the equation of state takes it half a step further.
#include "anvil/solver/solver.hpp"

namespace anvil {

template <int D>
void Solver<D>::exchange_energy(const Tile& tile, const Scratch& scratch, double kick) {
  for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i) {
    const std::size_t local = i - tile.range.first();
    if (kick_energy_.empty()) {
      specific_energy_[i] += kick * scratch.loss[local];
      continue;
    }
    const Eigen::Map<const Vec<D>> acceleration(&scratch.per_particle[local * D]);
    const Vec<D> mean_velocity = velocity_[i] - 0.5 * kick * (acceleration + recipe_.gravity);
    kick_energy_[i] += kick * (scratch.loss[local] - acceleration.dot(mean_velocity));
  }
}

/// Another impulse than that of the pairs has changed the velocity, and with it the mean over the kick that the power
/// of the pairs is taken at: `pair_change` is what the pairs gave, `change` what came after, both m/s.
template <int D>
void Solver<D>::charge_pairs(std::size_t i, const Vec<D>& pair_change, const Vec<D>& change) {
  if (!kick_energy_.empty()) kick_energy_[i] -= 0.5 * pair_change.dot(change);
}

#define ANVIL_INSTANTIATE(D)                                                     \
  template void Solver<D>::exchange_energy(const Tile&, const Scratch&, double); \
  template void Solver<D>::charge_pairs(std::size_t, const Vec<D>&, const Vec<D>&)
ANVIL_INSTANTIATE(1);
ANVIL_INSTANTIATE(2);
ANVIL_INSTANTIATE(3);
#undef ANVIL_INSTANTIATE

}  // namespace anvil
