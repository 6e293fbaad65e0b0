// SPDX-License-Identifier: BSD-3-Clause
// One step, from top to bottom. It starts with the forces of the present configuration and ends with the stress of the
// next one, so that frames and checkpoints taken between steps hold positions, densities and stresses of one time.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "anvil/core/field_keys.hpp"
#include "anvil/solver/tiles.hpp"

namespace anvil {
namespace {

/// Takes velocity gradients (D x D each) from the positions at the end of a step to those in its middle, where the
/// incremental laws want them: with x_end = x_mid + v dt/2 it is L_mid = L (I - dt L / 2)^-1. Without it a rotation
/// would expand the material by spin^2 dt per unit of time.
template <int D>
void take_to_mid_step(double* gradients, int count, double time_step) {
  using Matrix = Eigen::Matrix<double, D, D, D == 1 ? Eigen::ColMajor : Eigen::RowMajor>;
  for (int k = 0; k < count; ++k, gradients += D * D) {
    Eigen::Map<Matrix> gradient(gradients);
    const Matrix end = gradient;
    gradient = end * (Matrix::Identity() - 0.5 * time_step * end).inverse();
  }
}

}  // namespace

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

template <int D>
void Solver<D>::strain(double time_step) {
  if (time_step == 0.0)  // a start: no move has packed the records
    for_each_tile([&](const Tile& tile, Scratch&, TileReport<D>&) {
      pack_geometry(tile.range);
      pack_motion(tile.range);
    });
  if (!walls_.empty()) move_walls(time_step);
  fill_image_places();
  if (recipe_.deformation) return strain_from_reference(time_step);
  if constexpr (D == 1)
    if (recipe_.face_ghosts) recipe_.face_ghosts->hide(records_);
  if (recipe_.transport && time_step > 0.0) {  // filters the rates of all before any stress follows from them
    for_each_tile([&](const Tile& tile, Scratch& scratch, TileReport<D>& report) {
      find_velocity_gradients(tile, scratch, time_step, report);
      std::copy_n(scratch.per_particle.data(), tile.range.count(), strain_rate_.data() + tile.range.begin);
    });
    transport_strains(time_step);
    for_each_tile([&](const Tile& tile, Scratch& scratch, TileReport<D>& report) {
      deform_tile(tile, strain_rate_.data() + tile.range.begin, scratch, time_step, report);
      respond_tile(tile, scratch, time_step, report);
    });
    if constexpr (D == 1) ledger_.smoothing_loss += recipe_.transport->strain_loss();
  } else if (recipe_.density_diffusion > 0.0) {  // which reads the densities of before from the records
    fill_image_states();
    for_each_tile([&](const Tile& tile, Scratch& scratch, TileReport<D>& report) {
      strain_tile(tile, scratch, time_step, report);
    });
    for_each_tile([&](const Tile& tile, Scratch& scratch, TileReport<D>& report) {
      respond_tile(tile, scratch, time_step, report);
    });
    for (const auto& report : reports_) ledger_.smoothing_loss += report.diffusion_loss;
  } else {
    for_each_tile([&](const Tile& tile, Scratch& scratch, TileReport<D>& report) {
      strain_tile(tile, scratch, time_step, report);
      respond_tile(tile, scratch, time_step, report);
    });
  }
  collect_strain_reports();
}

template <int D>
void Solver<D>::collect_strain_reports() {
  step_limit_ = std::numeric_limits<double>::max();
  for (auto& report : reports_) {
    ledger_.plastic_work += report.plastic_work;
    ledger_.viscous_loss += report.bulk_viscous_loss;
    ledger_.erosion_loss += std::exchange(report.erosion_loss, 0.0);
    ledger_.uncorrected += report.uncorrected;
    if (report.step_limit < step_limit_) {
      step_limit_ = report.step_limit;
      limiting_particle_ = report.limiting_particle;
    }
  }
  step_limit_ = std::min(step_limit_, recipe_.largest_step);
}

template <int D>
void Solver<D>::strain_tile(const Tile& tile, Scratch& scratch, double time_step, TileReport<D>& report) {
  report.plastic_work = report.diffusion_loss = 0.0;
  report.uncorrected = 0;
  if (time_step == 0.0 || (recipe_.holds_particles && is_held(tile))) return;
  find_velocity_gradients(tile, scratch, time_step, report);
  deform_tile(tile, scratch.per_particle.data(), scratch, time_step, report);
}

/// Into the scratch memory, D x D per particle, of the middle of the step. Density diffuses over the same pairs.
template <int D>
void Solver<D>::find_velocity_gradients(const Tile& tile, Scratch& scratch, double time_step, TileReport<D>& report) {
  const bool diffuses = recipe_.density_diffusion > 0.0;
  const bool at_once = recipe_.corrected_gradients && correction_.empty() && !diffuses &&
                       kernel_loops_.corrected_velocity_gradient != nullptr;
  const PairTile<D> pairs = open_tile(tile, scratch, {.gradient = !at_once, .plain_gradient = diffuses});
  report.uncorrected = pairs.uncorrected;
  if (at_once)
    report.uncorrected = kernel_loops_.corrected_velocity_gradient(pairs, records_, scratch.per_particle.data());
  else
    loops_.velocity_gradient(pairs, records_, scratch.per_particle.data());
  for (const auto& force : recipe_.forces) force->refine_gradients(tile.range, scratch.per_particle.data());
  if (recipe_.holds_particles) stop_straining_held(tile, scratch.per_particle.data());
  take_to_mid_step<D>(scratch.per_particle.data(), tile.range.count(), time_step);
  if (diffuses) diffuse_density(tile, pairs, scratch, time_step, report);
}

template <int D>
void Solver<D>::deform_tile(const Tile& tile, const double* velocity_gradient, Scratch& scratch, double time_step,
                            TileReport<D>& report) {
  const Body<D>& body = recipe_.bodies[static_cast<std::size_t>(tile.body)];
  const double* lateral_rate = nullptr;
  if (body.lateral_release) {
    body.lateral_release->find_rates(tile.range, velocity_gradient, time_step, scratch.lateral_rate.data());
    lateral_rate = scratch.lateral_rate.data();
  }
  if (!kick_energy_.empty())
    std::copy_n(&kick_energy_[tile.range.first()], tile.range.count(), &specific_energy_[tile.range.first()]);
  else if (!specific_energy_.empty())
    body.eos->add_work_before(tile.range, velocity_gradient, time_step);
  update_density(tile.range, velocity_gradient, lateral_rate, time_step);
  report.plastic_work = body.strength->update(tile.range, velocity_gradient, lateral_rate, time_step);
  if (!specific_energy_.empty()) body.eos->add_work_after(tile.range, velocity_gradient, time_step);
}

/// The compression that diffusion brings is no work of the motion: its energy p/rho^2 drho is booked as the filter's.
template <int D>
void Solver<D>::diffuse_density(const Tile& tile, const PairTile<D>& pairs, Scratch& scratch, double time_step,
                                TileReport<D>& report) {
  double* rate = scratch.loss.data();
  loops_.density_diffusion(pairs, records_, recipe_.density_diffusion, recipe_.gravity.data(), rate);
  for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i) {
    const double change = time_step * *rate++;
    report.diffusion_loss -= mass_[i] * pressure_[i] / (density_[i] * density_[i]) * change;
    density_[i] += change;
  }
}

/// Stress and what follows from it, from the new densities and deviators.
template <int D>
void Solver<D>::respond_tile(const Tile& tile, Scratch& scratch, double time_step, TileReport<D>& report) {
  const Body<D>& body = recipe_.bodies[static_cast<std::size_t>(tile.body)];
  const bool limited = body.strength->limits_pressure();
  double* kept = scratch.loss.data();
  if (limited) std::copy_n(pressure_.data() + tile.range.begin, tile.range.count(), kept);
  body.eos->update(tile.range, scratch.sound_speed.data());
  if (limited && time_step > 0.0)
    report.plastic_work += body.strength->limit(tile.range, scratch.sound_speed.data());
  else if (limited)  // the stress stays that of the last step, to the bit
    std::copy_n(kept, tile.range.count(), pressure_.data() + tile.range.begin);
  if (recipe_.bulk_viscosity && time_step > 0.0)
    report.bulk_viscous_loss =
        recipe_.bulk_viscosity->update(tile.range, scratch.per_particle.data(), scratch.sound_speed.data(), time_step,
                                       [&](std::size_t i) { return recipe_.bulk_viscosity->even_stretch(i); });
  pack_limit_and_check(tile, scratch, report);
  for (const auto& force : recipe_.forces) force->pack(tile.range, records_);
}

/// drho/dt = -rho div v and dh/dt = (h/d) div v over one step, by the midpoint rule. The smoothing length belongs to
/// the directions in which particles stand side by side: what a bar does across its axis does not count.
template <int D>
void Solver<D>::update_density(ParticleRange range, const double* velocity_gradient, const double* lateral_rate,
                               double time_step) {
  const auto half_stretch = [=](std::size_t k) {
    double divergence = 0.0;
    for (std::size_t a = 0; a < D; ++a) divergence += velocity_gradient[k * D * D + a * (D + 1)];
    return 0.5 * time_step * divergence;
  };
  const auto count = static_cast<std::size_t>(range.count());
  double* density = &density_[range.first()];
  for (std::size_t k = 0; k < count; ++k) {
    const double half = lateral_rate == nullptr ? half_stretch(k) : half_stretch(k) + time_step * lateral_rate[k];
    density[k] *= (1.0 - half) / (1.0 + half);
  }
  if (!smoothing_length_varies_) return;
  double* smoothing_length = &smoothing_length_[range.first()];
  for (std::size_t k = 0; k < count; ++k)
    smoothing_length[k] *= (1.0 + half_stretch(k) / D) / (1.0 - half_stretch(k) / D);
}

template <int D>
void Solver<D>::pack_limit_and_check(const Tile& tile, Scratch& scratch, TileReport<D>& report) {
  find_step_limits(tile, scratch);
  if (medium_needed_) {
    const double viscosity = recipe_.bodies[static_cast<std::size_t>(tile.body)].viscosity;
    double* sound_speed = scratch.sound_speed.data();
    for (int k = 0; k < tile.range.count(); ++k) sound_speed[k] = std::sqrt(sound_speed[k]);
    for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i) {
      double* medium = records_.medium[i];
      medium[0] = *sound_speed++;
      medium[1] = density_[i];
      medium[2] = mass_[i];
      medium[3] = viscosity;
    }
  }
  const std::size_t first = tile.range.first(), count = tile.range.last() - first;
  const double *limit = scratch.step_limit.data(), *density = &density_[first], *pressure = &pressure_[first];
  const double* smoothing_length = &smoothing_length_[first];
  const auto sound = [=](std::size_t k) {
    return density[k] > 0.0 && smoothing_length[k] > 0.0 && limit[k] > 0.0 && std::isfinite(pressure[k]);
  };
  double least = limit[0];
  bool all_sound = true;
  for (std::size_t k = 0; k < count; ++k) {
    all_sound = all_sound && sound(k);
    least = std::min(least, limit[k]);
  }
  report.step_limit = least;
  report.limiting_particle =
      tile.range.begin + static_cast<std::int32_t>(std::find(limit, limit + count, least) - limit);
  if (all_sound || report.broken_particle >= 0) return;
  std::int32_t broken = 0;
  while (sound(static_cast<std::size_t>(broken))) ++broken;
  report.broken_particle = tile.range.begin + broken;
}

/// The time step rule dt = cfl h / (c + |v|), c the longitudinal wave speed (Long 2007, equation 12), and for viscous
/// fluids dt = h^2 / (8 nu) (Morris, Fox and Zhu 1997, equation 24). Roots and quotients stand in short loops of their
/// own, which the compiler turns into vectors.
template <int D>
void Solver<D>::find_step_limits(const Tile& tile, Scratch& scratch) const {
  const Body<D>& body = recipe_.bodies[static_cast<std::size_t>(tile.body)];
  const double stiffness = 4.0 / 3.0 * body.strength->shear_modulus();
  const double cfl = scene_.time.cfl;
  const std::size_t first = tile.range.first(), count = tile.range.last() - first;
  const double *bulk_squared = scratch.sound_speed.data(), *density = &density_[first];
  const double *smoothing_length = &smoothing_length_[first], *velocity = velocity_.raw() + first * D;
  double* limit = scratch.step_limit.data();
  for (std::size_t k = 0; k < count; ++k) limit[k] = std::sqrt(bulk_squared[k] + stiffness / density[k]);
  for (std::size_t k = 0; k < count; ++k) {
    double speed = 0.0;
    for (std::size_t a = 0; a < D; ++a) speed += velocity[k * D + a] * velocity[k * D + a];
    speed = D == 1 ? std::abs(velocity[k]) : std::sqrt(speed);
    limit[k] = cfl * smoothing_length[k] / (limit[k] + speed);
  }
  if (body.viscosity == 0.0) return;
  for (std::size_t k = 0; k < count; ++k)
    limit[k] = std::min(limit[k], 0.125 * smoothing_length[k] * smoothing_length[k] * density[k] / body.viscosity);
}

#define ANVIL_INSTANTIATE(D)                                                                \
  template void Solver<D>::advance(double);                                                 \
  template void Solver<D>::accelerate_tile(const Tile&, Scratch&, double, TileReport<D>&);  \
  template void Solver<D>::apply_boundaries(const Tile&, Scratch&, double, TileReport<D>&); \
  template void Solver<D>::move_tile(const Tile&, double, TileReport<D>&);                  \
  template void Solver<D>::note_displacements(const Tile&, TileReport<D>&) const;           \
  template void Solver<D>::strain(double);                                                  \
  template void Solver<D>::collect_strain_reports()
ANVIL_INSTANTIATE(1);
ANVIL_INSTANTIATE(2);
ANVIL_INSTANTIATE(3);
#undef ANVIL_INSTANTIATE

}  // namespace anvil
