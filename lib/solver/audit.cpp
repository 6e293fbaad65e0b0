// SPDX-License-Identifier: BSD-3-Clause
// Conserved quantities and where they went. Sums run over the particles in their order, in one thread: a few numbers
// per particle, some hundred times per run.
#include <algorithm>
#include <cmath>
#include <limits>

#include "anvil/core/summed_unit.hpp"
#include "anvil/solver/tiles.hpp"

namespace anvil {
namespace {

constexpr const char* axes[] = {"x", "y", "z"};

template <int D>
void add_vector(std::vector<AuditValue>& row, const std::string& name, const std::string& unit, const Vec<D>& vector) {
  for (int a = 0; a < D; ++a) row.push_back({name + "_" + axes[a], unit, vector[a]});
}

}  // namespace

template <int D>
double Solver<D>::kinetic_energy() const {
  double energy = 0.0;
  for (std::size_t i = 0; i < bodies_end(); ++i) energy += 0.5 * mass_[i] * velocity_[i].squaredNorm();
  return energy;
}

template <int D>
double Solver<D>::elastic_energy() const {
  double energy = 0.0;
  for (const auto& body : recipe_.bodies)
    energy += body.strength->elastic_energy(body.strength_range) + (body.strength->limits_pressure()
                                                                        ? body.eos->energy_of_pressure(body.range)
                                                                        : body.eos->elastic_energy(body.range));
  for (const auto* penalty : recipe_.wall_penalties) energy += penalty->energy();
  return energy;
}

template <int D>
double Solver<D>::energy_stored_by_walls() const {
  double energy = 0.0;
  for (const auto* force : recipe_.wall_forces) energy += force->stored_energy(records_);
  return energy;
}

/// All that is not motion, where the scene keeps it; else zero.
template <int D>
double Solver<D>::internal_energy() const {
  const std::span<double> energies = kick_energy_.empty() ? specific_energy_ : kick_energy_;
  double energy = 0.0;
  for (std::size_t i = 0; i < energies.size(); ++i) energy += mass_[i] * energies[i];
  return energy;
}

/// What the ledger does not count.
template <int D>
double Solver<D>::stored_energy() const {
  return specific_energy_.empty() ? elastic_energy() : internal_energy();
}

template <int D>
Vec<D> Solver<D>::momentum() const {
  Vec<D> sum = Vec<D>::Zero();
  for (std::size_t i = 0; i < bodies_end(); ++i) sum += mass_[i] * velocity_[i];
  return sum;
}

/// In m; zero when no particle has a neighbour.
template <int D>
double Solver<D>::minimum_pair_distance() const {
  std::vector<double> nearest(tiles_.size(), std::numeric_limits<double>::max());
  const std::int32_t* neighbour = neighbours_.neighbours();
  for_each_parallel(static_cast<int>(tiles_.size()), [&](int t, int /*thread*/) {
    const auto tile = static_cast<std::size_t>(t);
    for (std::size_t i = tiles_[tile].range.first(); i < tiles_[tile].range.last(); ++i) {
      for (std::int64_t k = neighbours_.row_begin(i); k < neighbours_.row_end(i); ++k) {
        const auto j = static_cast<std::size_t>(neighbour[k]);
        if (j <= i || j >= mass_.size()) continue;  // seen from the other side, padding or images
        nearest[tile] = std::min(nearest[tile], (position_[i] - position_[j]).squaredNorm());
      }
    }
  });
  double least = std::numeric_limits<double>::max();
  for (const double distance : nearest) least = std::min(least, distance);
  return least == std::numeric_limits<double>::max() ? 0.0 : std::sqrt(least);
}

template <int D>
std::vector<AuditValue> Solver<D>::audit() const {
  double mass = 0.0;
  Vec<D> centre = Vec<D>::Zero();
  for (std::size_t i = 0; i < bodies_end(); ++i) {
    mass += mass_[i];
    centre += mass_[i] * position_[i];
  }
  const double kinetic = kinetic_energy(), elastic = elastic_energy();
  double total = kinetic + energy_stored_by_walls() - ledger_.gravity_work + ledger_.smoothing_loss +
                 ledger_.wall_loss + ledger_.contact_loss + ledger_.erosion_loss;
  // Plastic work and viscous heat are part of the internal energy where there is one.
  total += specific_energy_.empty() ? elastic + ledger_.plastic_work + ledger_.viscous_loss : internal_energy();
  const Vec<D> present = momentum();
  const Vec<D> unexplained = present - ledger_.start_momentum - ledger_.wall_impulse - ledger_.smoothing_impulse -
                             ledger_.pressure_impulse - ledger_.gravity_impulse;

  const std::string impulse = summed_unit("N s", D), energy = summed_unit("J", D);
  std::vector<AuditValue> row;
  row.push_back({"mass", summed_unit("kg", D), mass});
  add_vector<D>(row, "momentum", impulse, present);
  add_vector<D>(row, "centre_of_mass", "m", mass > 0.0 ? Vec<D>(centre / mass) : centre);
  row.push_back({"kinetic_energy", energy, kinetic});
  if (!specific_energy_.empty()) row.push_back({"internal_energy", energy, internal_energy()});
  row.push_back({"elastic_energy", energy, elastic});
  const bool falls = !recipe_.gravity.isZero(0.0);
  if (falls) row.push_back({"potential_energy", energy, -ledger_.gravity_work});
  row.push_back({"plastic_work", energy, ledger_.plastic_work});
  row.push_back({"viscous_loss", energy, ledger_.viscous_loss});
  row.push_back({"smoothing_loss", energy, ledger_.smoothing_loss});
  row.push_back({"wall_loss", energy, ledger_.wall_loss});
  if (recipe_.erosion) {
    row.push_back({"erosion_loss", energy, ledger_.erosion_loss});
    row.push_back({"eroded_mass", summed_unit("kg", D), eroded_mass(fields_)});
    if (recipe_.edges) row.push_back({"eroded_edge_mass", summed_unit("kg", D), eroded_mass(recipe_.edges->fields())});
  }
  if (recipe_.contact) {
    row.push_back({"contact_loss", energy, ledger_.contact_loss});
    row.push_back({"contact_impulse", impulse, ledger_.contact_impulse});
    row.push_back({"contact_penetration", "m", recipe_.contact->deepest_penetration()});
  }
  row.push_back({"total_energy", energy, total});
  row.push_back({"energy_error", energy, total - ledger_.start_energy - ledger_.pressure_work - ledger_.wall_work});
  add_vector<D>(row, "wall_impulse", impulse, ledger_.wall_impulse);
  add_vector<D>(row, "smoothing_impulse", impulse, ledger_.smoothing_impulse);
  if (!recipe_.loads.empty()) {
    add_vector<D>(row, "pressure_impulse", impulse, ledger_.pressure_impulse);
    row.push_back({"pressure_work", energy, ledger_.pressure_work});
  }
  if (falls) add_vector<D>(row, "gravity_impulse", impulse, ledger_.gravity_impulse);
  if (!walls_.empty()) {
    row.push_back({"wall_stored_energy", energy, energy_stored_by_walls()});
    row.push_back({"wall_work", energy, ledger_.wall_work});
  }
  if (!walls_.empty() || !recipe_.mirror_walls.empty()) row.push_back({"penetrations", "", ledger_.penetrations});
  if (recipe_.corrected_gradients) row.push_back({"uncorrected_particles", "", ledger_.uncorrected});
  row.push_back({"momentum_error", impulse, unexplained.norm()});
  row.push_back({"minimum_pair_distance", "m", minimum_pair_distance()});
  row.push_back({"list_builds", "", static_cast<double>(list_builds_)});
  return row;
}

#define ANVIL_INSTANTIATE(D)                                 \
  template double Solver<D>::kinetic_energy() const;         \
  template double Solver<D>::elastic_energy() const;         \
  template double Solver<D>::energy_stored_by_walls() const; \
  template double Solver<D>::stored_energy() const;          \
  template Vec<D> Solver<D>::momentum() const;               \
  template std::vector<AuditValue> Solver<D>::audit() const
ANVIL_INSTANTIATE(1);
ANVIL_INSTANTIATE(2);
ANVIL_INSTANTIATE(3);
#undef ANVIL_INSTANTIATE

}  // namespace anvil
