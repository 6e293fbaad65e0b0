// SPDX-License-Identifier: BSD-3-Clause
// What a step does only in one dimension: loads on faces and filters along the line. Each part runs over the line in
// order, in one thread: a few operations per particle.
#include "anvil/solver/tiles.hpp"

namespace anvil {

/// Loads act with the mean pressure of the time that the kick spans, which gives the whole impulse of a history
/// whatever the steps. Where stress differences are taken, the face stress enters through the images behind the face;
/// sums leave a face free by themselves, and there the load is a force on the last particle.
template <int D>
void Solver<D>::load_faces(double kick) {
  if constexpr (D == 1) {
    const double begin = time_ - 0.5 * time_step_;
    for (std::size_t k = 0; k < load_steps_.size(); ++k) {
      const PressureLoad& load = recipe_.loads[k];
      const double impulse = load.history->impulse(begin + kick) - load.history->impulse(begin);
      load_steps_[k] = {load.inward * impulse, velocity_[load.particle][0]};
      face_stress_[k] = -impulse / kick;
    }
    if (recipe_.face_ghosts) recipe_.face_ghosts->show(records_, recipe_.loads, face_stress_);
  }
}

template <int D>
void Solver<D>::kick_loaded_faces() {
  if constexpr (D == 1) {
    if (recipe_.face_ghosts) return;  // the load acted through the images
    for (std::size_t k = 0; k < load_steps_.size(); ++k) {
      const std::size_t i = recipe_.loads[k].particle;
      const Vec<D> pair_change = velocity_[i] - Vec<D>(load_steps_[k].velocity_before);
      const Vec<D> change(load_steps_[k].impulse / mass_[i]);
      velocity_[i] += change;
      charge_pairs(i, pair_change, change);
    }
  }
}

/// See the energy account in step.cpp.
template <int D>
void Solver<D>::account_loads() {
  if constexpr (D == 1) {
    for (std::size_t k = 0; k < load_steps_.size(); ++k) {
      const double mean = 0.5 * (load_steps_[k].velocity_before + velocity_[recipe_.loads[k].particle][0]);
      ledger_.pressure_impulse[0] += load_steps_[k].impulse;
      ledger_.pressure_work += load_steps_[k].impulse * mean;
    }
  }
}

template <int D>
void Solver<D>::transport_velocities() {
  if constexpr (D == 1) {
    for_each_tile([&](const Tile& tile, Scratch&, TileReport<D>&) { pack_velocities(tile.range); });
    recipe_.transport->filter_velocity({start_velocity_.raw(), particle_count()});
    for (std::size_t i = 0; i < particle_count(); ++i) {
      const double change = velocity_[i][0] - records_.motion[i][0];
      ledger_.smoothing_loss -= 0.5 * mass_[i] * change * (start_velocity_[i][0] + velocity_[i][0]);
      ledger_.smoothing_impulse[0] += mass_[i] * change;
    }
  }
}

/// The filter moves particles a little: the neighbours must still be listed.
template <int D>
void Solver<D>::transport_strains(double time_step) {
  if constexpr (D == 1) {
    recipe_.transport->filter_strain(strain_rate_, time_step);
    for_each_tile([&](const Tile& tile, Scratch&, TileReport<D>& report) {
      note_displacements(tile, report);
      pack_geometry(tile.range);
    });
    refresh_neighbours();
  }
}

#define ANVIL_INSTANTIATE(D)                       \
  template void Solver<D>::load_faces(double);     \
  template void Solver<D>::kick_loaded_faces();    \
  template void Solver<D>::account_loads();        \
  template void Solver<D>::transport_velocities(); \
  template void Solver<D>::transport_strains(double)
ANVIL_INSTANTIATE(1);
ANVIL_INSTANTIATE(2);
ANVIL_INSTANTIATE(3);
#undef ANVIL_INSTANTIATE

}  // namespace anvil
