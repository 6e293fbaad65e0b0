// SPDX-License-Identifier: BSD-3-Clause
// The half of a step that follows the motion: velocity gradients, densities, stresses, and how long the next step may
// be.
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

#define ANVIL_INSTANTIATE(D)               \
  template void Solver<D>::strain(double); \
  template void Solver<D>::collect_strain_reports()
ANVIL_INSTANTIATE(1);
ANVIL_INSTANTIATE(2);
ANVIL_INSTANTIATE(3);
#undef ANVIL_INSTANTIATE

}  // namespace anvil
