// SPDX-License-Identifier: BSD-3-Clause
// One step, from top to bottom. It starts with the forces of the present configuration and ends with the stress of the
// next one, so that frames and checkpoints taken between steps hold positions, densities and stresses of one time.
#include <algorithm>
#include <cmath>

#include "anvil/core/field_keys.hpp"
#include "anvil/solver/tiles.hpp"

namespace anvil {
template <int D>
void Solver<D>::advance(double latest) {
  if (scratch_.size() < static_cast<std::size_t>(thread_count())) size_scratch();  // threads were added meanwhile
  if (local_steps_) return advance_locally(latest);
  const double time_step = choose_time_step(latest);
  accelerate(0.5 * (time_step_ + time_step));  // leapfrog: from the middle of the last step to that of this one
  filter_velocities(time_step);
  if (recipe_.contact) recipe_.contact->correct_velocities(time_step);
  move(time_step);
  refresh_neighbours();
  strain(time_step);
  time_step_ = time_step;
  time_ = time_step < latest - time_ ? time_ + time_step : latest;
  ++step_;
  check_reports();
}

/// The printed rule, cut so that `latest` is met without a last step that is a mere splinter.
template <int D>
double Solver<D>::choose_time_step(double latest) const {
  const double left = latest - time_;
  if (left <= step_limit_) return left;
  return left < 2.0 * step_limit_ ? 0.5 * left : step_limit_;
}

template <int D>
void Solver<D>::accelerate(double kick) {
  if (!recipe_.deformation) for_each_tile([&](const Tile& tile, Scratch&, TileReport<D>&) { pack_sizes(tile.range); });
  kick_ = kick;
  if (!walls_.empty()) {
    move_walls(0.0);  // with the smoothing lengths of now: what a restart finds
    load_walls(kick);
  }
  fill_image_places();
  fill_image_states();
  load_faces(kick);
  for_each_tile(
      [&](const Tile& tile, Scratch& scratch, TileReport<D>& report) { accelerate_tile(tile, scratch, kick, report); });
  kick_loaded_faces();
  for (const auto& report : reports_) ledger_.viscous_loss += report.viscous_loss;
  for (const auto* penalty : recipe_.wall_penalties) ledger_.wall_impulse += kick * penalty->force();
  if (recipe_.images.reflect()) account_mirror_planes();
}

/// The force of a pair of a particle and an image has no partner among the particles: its part normal to the planes is
/// what they push with. Along them the images' forces cancel, so that an error of the sums still shows.
template <int D>
void Solver<D>::account_mirror_planes() {
  Vec<D> impulse = Vec<D>::Zero();
  for (const auto& report : reports_) impulse += report.force_impulse;
  ledger_.wall_impulse += recipe_.images.push_directions() * impulse;
}

template <int D>
void Solver<D>::accelerate_tile(const Tile& tile, Scratch& scratch, double kick, TileReport<D>& report) {
  double* acceleration = scratch.per_particle.data();
  std::fill_n(acceleration, tile.range.count() * D, 0.0);
  std::fill_n(scratch.loss.data(), tile.range.count(), 0.0);
  if (!(recipe_.holds_particles && is_held(tile))) {
    const PairTile<D> pairs = open_tile(tile, scratch, recipe_.force_needs);
    for (const auto& force : recipe_.forces) force->accumulate(pairs, records_, acceleration, scratch.loss.data());
  }
  const Vec<D> fall = kick * recipe_.gravity;
  report.viscous_loss = 0.0;
  for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i) {
    const std::size_t local = i - tile.range.first();
    if (velocities_filtered_) start_velocity_[i] = velocity_[i];
    for (std::size_t a = 0; a < D; ++a) velocity_.raw()[i * D + a] += kick * acceleration[local * D + a];
    velocity_[i] += fall;
    report.viscous_loss += kick * mass_[i] * scratch.loss[local];
  }
  if (!kick_energy_.empty()) report.viscous_loss = 0.0;  // the term's account is that of the whole pair
  if (!specific_energy_.empty()) exchange_energy(tile, scratch, kick);
  if (!recipe_.images.reflect()) return;
  report.force_impulse.setZero();
  for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i, acceleration += D)
    report.force_impulse += kick * mass_[i] * Eigen::Map<const Vec<D>>(acceleration);
}

template <int D>
void Solver<D>::filter_velocities(double time_step) {
  for (const auto& filter : recipe_.filters) {
    // A filter reads the neighbours' velocities of before it: from the records, while it writes the fields.
    for_each_tile([&](const Tile& tile, Scratch&, TileReport<D>&) { pack_velocities(tile.range); });
    fill_image_places();
    for_each_tile([&](const Tile& tile, Scratch& scratch, TileReport<D>& report) {
      filter_tile(tile, *filter, scratch, time_step, report);
    });
    for (const auto& report : reports_) {
      ledger_.smoothing_loss += report.smoothing_loss;
      ledger_.smoothing_impulse += report.smoothing_impulse;
    }
  }
  if (recipe_.transport) transport_velocities();
}

// Energy account. Forces, filters and boundaries each give a particle an impulse in the step from one half time to the
// next. The work of an impulse is its product with the mean of the velocities before and after all of them: only then
// do the parts add up to the change of kinetic energy, and is the work of the stresses the one that strains the
// material.

template <int D>
void Solver<D>::filter_tile(const Tile& tile, const VelocityFilter<D>& filter, Scratch& scratch, double time_step,
                            TileReport<D>& report) {
  const PairTile<D> pairs = open_tile(tile, scratch, filter.needs());
  const double* change = scratch.per_particle.data();
  filter.change(pairs, records_, time_step, scratch.per_particle.data());
  report.smoothing_loss = 0.0;
  report.smoothing_impulse = Vec<D>::Zero();
  for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i, change += D) {
    const Eigen::Map<const Vec<D>> step(change);
    charge_pairs(i, velocity_[i] - start_velocity_[i], step);
    velocity_[i] += step;
    report.smoothing_loss -= 0.5 * mass_[i] * step.dot(start_velocity_[i] + velocity_[i]);
    report.smoothing_impulse += mass_[i] * step;
  }
}

template <int D>
void Solver<D>::move(double time_step) {
  const auto keep_in_bounds = [&](const Tile& tile, Scratch& scratch, TileReport<D>& report) {
    if (!recipe_.boundaries.empty()) apply_boundaries(tile, scratch, time_step, report);
  };
  if (recipe_.contact) {
    for_each_tile(keep_in_bounds);
    // Pairs frozen at the start leave the velocities of before the kick in the records until here.
    ledger_.contact_loss += recipe_.contact->loss(records_.motion[0], PairRecords<D>::small);
    ledger_.contact_impulse += recipe_.contact->impulse();
  }
  for_each_tile([&](const Tile& tile, Scratch& scratch, TileReport<D>& report) {
    if (!recipe_.contact) keep_in_bounds(tile, scratch, report);
    move_tile(tile, time_step, report);
    if (!recipe_.gravity.isZero(0.0)) account_gravity(tile, report);
    pack_velocities(tile.range);
    if (!recipe_.deformation) pack_geometry(tile.range);
  });
  for (const auto& report : reports_) {
    ledger_.wall_impulse += report.wall_impulse;
    ledger_.wall_loss += report.wall_loss;
  }
  if (!recipe_.gravity.isZero(0.0)) {
    double mass = 0.0;
    for (std::size_t i = 0; i < bodies_end(); ++i) mass += mass_[i];
    ledger_.gravity_impulse += kick_ * mass * recipe_.gravity;
    for (const auto& report : reports_) ledger_.gravity_work += report.gravity_work;
  }
  count_penetrations(time_step);
  account_loads();
  check_reports();  // before the neighbour search meets a position that is none
}

template <int D>
void Solver<D>::apply_boundaries(const Tile& tile, Scratch& scratch, double time_step, TileReport<D>& report) {
  const double face_distance = recipe_.bodies[static_cast<std::size_t>(tile.body)].face_distance;
  double* before = scratch.per_particle.data();
  std::copy_n(velocity_.raw() + tile.range.first() * D, tile.range.count() * D, before);
  for (const auto& boundary : recipe_.boundaries)
    boundary->correct_velocities(tile.range, position_, velocity_, face_distance, time_step);
  report.wall_loss = 0.0;
  report.wall_impulse = Vec<D>::Zero();
  for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i, before += D) {
    const Eigen::Map<const Vec<D>> incoming(before);
    const Vec<D> change = velocity_[i] - incoming;
    if (change.isZero(0.0)) continue;
    // The records still hold the velocities that the filter read; without filters, those before the kick.
    const Eigen::Map<const Vec<D>> recorded(records_.motion[i]);
    Vec<D> twice_mean = velocity_[i];
    if (!velocities_filtered_)
      twice_mean += recorded;
    else
      twice_mean += start_velocity_[i] + (incoming - recorded);  // the filter's mean lacked this impulse
    charge_pairs(i, velocities_filtered_ ? Vec<D>(recorded - start_velocity_[i]) : Vec<D>(incoming - recorded), change);
    report.wall_loss -= 0.5 * mass_[i] * change.dot(twice_mean);
    report.wall_impulse += mass_[i] * change;
  }
}

/// See the energy account above. The records still hold the velocities before the kick or, with a filter, before it.
template <int D>
void Solver<D>::account_gravity(const Tile& tile, TileReport<D>& report) {
  const Vec<D> fall = kick_ * recipe_.gravity;
  report.gravity_work = 0.0;
  for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i) {
    Vec<D> before = Eigen::Map<const Vec<D>>(records_.motion[i]);
    if (velocities_filtered_) before = start_velocity_[i];
    report.gravity_work += 0.5 * mass_[i] * fall.dot(before + velocity_[i]);
  }
}

template <int D>
void Solver<D>::move_tile(const Tile& tile, double time_step, TileReport<D>& report) {
  report.broken_particle = -1;
  for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i) {
    position_[i] += time_step * velocity_[i];
    bool broken = !std::isfinite(position_[i].sum());
    for (const auto& boundary : recipe_.boundaries) broken = broken || boundary->forbids(position_[i]);
    if (broken && report.broken_particle < 0) report.broken_particle = static_cast<std::int32_t>(i);
  }
  if (!recipe_.deformation) note_displacements(tile, report);
}

/// Since the neighbour list was made.
template <int D>
void Solver<D>::note_displacements(const Tile& tile, TileReport<D>& report) const {
  Vec<D> least = Vec<D>::Constant(std::numeric_limits<double>::max()), greatest = -least;
  for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i) {
    const Vec<D> displacement = position_[i] - listed_position_[i];
    least = least.cwiseMin(displacement);
    greatest = greatest.cwiseMax(displacement);
  }
  double growth = 0.0;
  if (smoothing_length_varies_)
    for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i)
      growth = std::max(growth, smoothing_length_[i] - listed_smoothing_length_[i]);
  report.least_displacement = least;
  report.greatest_displacement = greatest;
  report.greatest_growth = growth;
}

/// The list stays complete while no pair has come nearer by more than the skin. How far two particles can have
/// approached is bounded by the box around all displacements, which does not grow when everything moves alike.
template <int D>
void Solver<D>::refresh_neighbours() {
  if (reports_.empty() || recipe_.deformation) return;
  Vec<D> least = reports_[0].least_displacement, greatest = reports_[0].greatest_displacement;
  double growth = 0.0;
  for (const auto& report : reports_) {
    least = least.cwiseMin(report.least_displacement);
    greatest = greatest.cwiseMax(report.greatest_displacement);
    growth = std::max(growth, report.greatest_growth);
  }
  if (!walls_.empty()) {  // their particles stay where they are
    least = least.cwiseMin(Vec<D>::Zero());
    greatest = greatest.cwiseMax(Vec<D>::Zero());
  }
  if (recipe_.images.possible()) recipe_.images.widen(least, greatest);
  if ((greatest - least).norm() + recipe_.support * growth > skin_) list_neighbours();
}

#define ANVIL_INSTANTIATE(D)                                                                \
  template void Solver<D>::advance(double);                                                 \
  template void Solver<D>::accelerate_tile(const Tile&, Scratch&, double, TileReport<D>&);  \
  template void Solver<D>::apply_boundaries(const Tile&, Scratch&, double, TileReport<D>&); \
  template void Solver<D>::move_tile(const Tile&, double, TileReport<D>&);                  \
  template void Solver<D>::note_displacements(const Tile&, TileReport<D>&) const
ANVIL_INSTANTIATE(1);
ANVIL_INSTANTIATE(2);
ANVIL_INSTANTIATE(3);
#undef ANVIL_INSTANTIATE

}  // namespace anvil
