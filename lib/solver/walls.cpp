// SPDX-License-Identifier: BSD-3-Clause
// What a step does with walls of dummy particles. Their density, stress and velocity are means over the particles of
// bodies beside them, sum_j V_j f_j W_ij / sum_j V_j W_ij (Shepard 1968). While a wall is hidden its dummy particles
// weigh nothing in any sum, so that sums over their own rows hold the particles of bodies alone: that is how means,
// forces on the wall and its work are found. Shown, they are neighbours like any other.
#include <algorithm>

#include "anvil/core/field_keys.hpp"
#include "anvil/solver/tiles.hpp"

namespace anvil {

template <int D>
template <class Work>
void Solver<D>::for_each_wall_tile(Work&& work) {
  for_each_parallel(static_cast<int>(wall_tiles_.size()), [&](int tile, int thread) {
    const auto index = static_cast<std::size_t>(tile);
    work(wall_tiles_[index], scratch_[static_cast<std::size_t>(thread)], wall_reports_[index]);
  });
}

template <int D>
void Solver<D>::weigh_walls(bool shown) {
  for (const auto& wall : walls_) {
    const double volume = shown && wall->interpolates() ? wall->volume() : 0.0;
    for (std::size_t i = wall->range().first(); i < wall->range().last(); ++i) {
      records_.motion[i][D] = volume;
      records_.traction[i][symmetric_components<D>] = volume > 0.0 ? wall_weight_[i - bodies_end()] : 0.0;
      if (medium_needed_) records_.medium[i][2] = volume * density_[i];
    }
  }
}

/// Calls take(weight, record) with V_j W_ij of every particle of a body, or image of one, beside the dummy particle.
template <int D>
template <class Take>
void Solver<D>::for_each_beside(const PairTile<D>& pairs, std::size_t dummy, Take&& take) const {
  for (std::int64_t k = pairs.first[dummy]; k < pairs.first[dummy + 1]; ++k) {
    const auto record = static_cast<std::size_t>(pairs.neighbour[k]);
    if (record == particle_count()) break;  // padding
    const double weight = records_.motion[record][D] * pairs.value[k - pairs.first[pairs.begin]];
    if (weight > 0.0) take(weight, record);
  }
}

/// Velocities of the dummy particles at the end of a move, and the work of their stress on what moves beside them.
template <int D>
void Solver<D>::move_walls(double time_step) {
  weigh_walls(false);
  fill_image_places();
  for_each_wall_tile([&](const Tile& tile, Scratch& scratch, WallReport<D>& report) {
    const PairTile<D> pairs = open_tile(tile, scratch, {.plain_gradient = true, .value = true});
    const DummyRows<D>& wall = *walls_[static_cast<std::size_t>(tile.body)];
    for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i) {
      double weights = 0.0;
      Vec<D> mean = Vec<D>::Zero();
      for_each_beside(pairs, i, [&](double weight, std::size_t record) {
        weights += weight;
        mean += weight * Eigen::Map<const Vec<D>>(records_.motion[record]);
      });
      if (weights > 0.0) mean /= weights;
      Vec<D> velocity = Vec<D>::Zero();
      if (wall.velocity() == WallVelocity::antisymmetric) velocity = -mean;
      if (wall.velocity() == WallVelocity::reversed_normal)
        velocity = mean - 2.0 * wall.normal(i).dot(mean) * wall.normal(i);
      std::copy_n(velocity.data(), D, records_.motion[i]);
    }
    report.stress_work = 0.0;
    if (time_step == 0.0 || !wall.interpolates()) return;
    double* gradient = scratch.per_particle.data();
    PairTile<D> plain = pairs;
    plain.gradient = pairs.plain_gradient;
    loops_.velocity_gradient(plain, records_, gradient);
    for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i, gradient += D * D)
      report.stress_work -= time_step * wall.volume() * stress_power(i, gradient);
  });
  for (const auto& report : wall_reports_) ledger_.wall_work += report.stress_work;
  weigh_walls(true);
}

/// sigma : L of a particle, W/m^D.
template <int D>
double Solver<D>::stress_power(std::size_t i, const double* gradient) const {
  constexpr int row[] = {0, 1, D == 2 ? 0 : 2, 0, 1, 0}, column[] = {0, 1, D == 2 ? 1 : 2, 1, 2, 2};
  double power = 0.0;
  for (int a = 0; a < D; ++a) power -= pressure_[i] * gradient[a * (D + 1)];
  if (wall_deviator_ == nullptr) return power;
  const double* deviator = wall_deviator_ + i * symmetric_components<D>;
  for (int c = 0; c < symmetric_components<D>; ++c) {
    const int a = row[c], b = column[c];
    power += deviator[c] * (a == b ? gradient[a * (D + 1)] : gradient[a * D + b] + gradient[b * D + a]);
  }
  return power;
}

/// Density and stress of the dummy particles, their records, and the force on the wall.
template <int D>
void Solver<D>::load_walls(double kick) {
  weigh_walls(false);
  fill_image_places();
  fill_image_states();
  for_each_wall_tile([&](const Tile& tile, Scratch& scratch, WallReport<D>&) {
    const DummyRows<D>& wall = *walls_[static_cast<std::size_t>(tile.body)];
    if (!wall.interpolates()) return;
    const PairTile<D> pairs = open_tile(tile, scratch, {.value = true});
    for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i) interpolate(pairs, wall, i);
    for (const auto& force : recipe_.forces) force->pack(tile.range, records_);
    for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i) {
      double& weight = records_.traction[i][symmetric_components<D>];
      wall_weight_[i - bodies_end()] = weight;
      weight = 0.0;
    }
  });
  // Packing shows a dummy particle's weight for a moment: no sum may run before all are hidden again.
  for_each_wall_tile([&](const Tile& tile, Scratch& scratch, WallReport<D>& report) {
    report.impulse.setZero();
    report.motion_work = report.viscous_loss = 0.0;
    if (!walls_[static_cast<std::size_t>(tile.body)]->interpolates()) return;
    const PairTile<D> pairs = open_tile(tile, scratch, recipe_.force_needs);
    double* acceleration = scratch.per_particle.data();
    std::fill_n(acceleration, tile.range.count() * D, 0.0);
    std::fill_n(scratch.loss.data(), tile.range.count(), 0.0);
    for (const auto& force : recipe_.forces) force->accumulate(pairs, records_, acceleration, scratch.loss.data());
    for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i, acceleration += D) {
      const Vec<D> impulse = kick * mass_[i] * Eigen::Map<const Vec<D>>(acceleration);
      report.impulse += impulse;
      report.motion_work -= impulse.dot(Eigen::Map<const Vec<D>>(records_.motion[i]));
      report.viscous_loss += kick * mass_[i] * scratch.loss[i - tile.range.first()];
    }
  });
  for (const auto& report : wall_reports_) {
    ledger_.wall_impulse -= report.impulse;
    ledger_.wall_work += report.motion_work;
    ledger_.viscous_loss += report.viscous_loss;
  }
  weigh_walls(true);
  for (const auto* force : recipe_.wall_forces) ledger_.wall_impulse += kick * force->total_force(records_);
}

/// The pressure of a mean over particles at other depths is brought to the depth of the dummy particle (Adami, Hu and
/// Adams 2012, equation 27, for a wall at rest).
template <int D>
void Solver<D>::interpolate(const PairTile<D>& pairs, const DummyRows<D>& wall, std::size_t dummy) {
  constexpr int components = symmetric_components<D>;
  double weights = 0.0, density = 0.0, pressure = 0.0, deviator[components] = {}, turned[components];
  const Vec<D> place = position_[dummy];
  for_each_beside(pairs, dummy, [&](double weight, std::size_t record) {
    const bool image = record > particle_count();
    const std::size_t j = image ? recipe_.images.source(record - records_.first_image()) : record;
    const Vec<D> apart = place - Eigen::Map<const Vec<D>>(records_.geometry[record]);
    weights += weight;
    const double sound_speed = medium_needed_ ? records_.medium[record][0] : 0.0;
    density += weight * density_[j];
    if (sound_speed > 0.0) density += weight * density_[j] * recipe_.gravity.dot(apart) / (sound_speed * sound_speed);
    pressure += weight * (pressure_[j] + density_[j] * recipe_.gravity.dot(apart));
    if (wall_deviator_ == nullptr) return;
    const double* own = wall_deviator_ + j * components;
    if (image) {
      turn_symmetric<D>(recipe_.images.transform(record - records_.first_image()).turn, own, turned);
      own = turned;
    }
    for (int c = 0; c < components; ++c) deviator[c] += weight * own[c];
  });
  if (weights > 0.0) {
    density_[dummy] = density / weights;
    pressure_[dummy] = pressure / weights;
  }
  mass_[dummy] = density_[dummy] * wall.volume();
  if (medium_needed_) records_.medium[dummy][1] = density_[dummy];
  if (wall_deviator_ == nullptr) return;
  for (int c = 0; c < components; ++c)
    wall_deviator_[dummy * components + static_cast<std::size_t>(c)] = weights > 0.0 ? deviator[c] / weights : 0.0;
}

/// Dummy particles never move: their place is packed with each list, since images change the records' memory.
template <int D>
void Solver<D>::list_walls() {
  for (const auto& wall : walls_) {
    pack_geometry(wall->range());
    for (std::size_t i = wall->range().first(); i < wall->range().last(); ++i) {
      listed_position_[i] = position_[i];
      if (smoothing_length_varies_) listed_smoothing_length_[i] = smoothing_length_[i];
    }
    wall->list(neighbours_, recipe_.images, records_.first_image(), bodies_end());
  }
}

template <int D>
void Solver<D>::make_wall_tiles() {
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const ParticleRange range = walls_[w]->range();
    for (std::int32_t begin = range.begin; begin < range.end; begin += tile_size)
      wall_tiles_.push_back({{begin, std::min(begin + tile_size, range.end)}, static_cast<int>(w)});
  }
  wall_reports_.resize(wall_tiles_.size());
  wall_weight_.resize(particle_count() - bodies_end());
  if (fields_.has(field::deviatoric_stress))
    wall_deviator_ = fields_.vector<symmetric_components<D>>(field::deviatoric_stress).raw();
  for (const auto& wall : walls_)
    for (std::size_t i = wall->range().first(); medium_needed_ && i < wall->range().last(); ++i) {
      records_.medium[i][0] = recipe_.wall_sound_speed;
      records_.medium[i][1] = density_[i];
      records_.medium[i][3] = recipe_.wall_viscosity;
    }
}

/// Whether a boundary carries all particles of a tile.
template <int D>
bool Solver<D>::is_held(const Tile& tile) const {
  for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i) {
    const auto holds = [&](const auto& boundary) { return boundary->holds(position_[i]); };
    if (std::none_of(recipe_.boundaries.begin(), recipe_.boundaries.end(), holds)) return false;
  }
  return true;
}

template <int D>
void Solver<D>::stop_straining_held(const Tile& tile, double* velocity_gradient) const {
  for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i, velocity_gradient += D * D) {
    const auto holds = [&](const auto& boundary) { return boundary->holds(position_[i]); };
    if (std::any_of(recipe_.boundaries.begin(), recipe_.boundaries.end(), holds))
      std::fill_n(velocity_gradient, D * D, 0.0);
  }
}

template <int D>
void Solver<D>::count_penetrations(double time_step) {
  for (const auto& wall : walls_) ledger_.penetrations += wall->count_penetrations(position_, velocity_, time_step);
  for (const auto& plane : recipe_.mirror_walls) {
    for (std::size_t i = 0; i < bodies_end(); ++i) {
      const double now = plane.normal.dot(position_[i] - plane.point);
      if (now < 0.0 && now - time_step * plane.normal.dot(velocity_[i]) >= 0.0) ledger_.penetrations += 1.0;
    }
  }
}

#define ANVIL_INSTANTIATE(D)                                                \
  template bool Solver<D>::is_held(const Tile&) const;                      \
  template void Solver<D>::stop_straining_held(const Tile&, double*) const; \
  template void Solver<D>::weigh_walls(bool);                               \
  template void Solver<D>::move_walls(double);                              \
  template void Solver<D>::load_walls(double);                              \
  template void Solver<D>::list_walls();                                    \
  template void Solver<D>::make_wall_tiles();                               \
  template void Solver<D>::count_penetrations(double)
ANVIL_INSTANTIATE(1);
ANVIL_INSTANTIATE(2);
ANVIL_INSTANTIATE(3);
#undef ANVIL_INSTANTIATE

}  // namespace anvil
