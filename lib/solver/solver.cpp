// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/solver/solver.hpp"

#include <algorithm>

#include "anvil/core/field_keys.hpp"
#include "anvil/solver/tiles.hpp"

namespace anvil {
namespace {

/// Thickness of the neighbour list's skin over the spacing: rows grow by a third, and a rod at 227 m/s keeps its list
/// for 8 steps right after the impact. By benchmark_rod the optimum is flat: 0.2 and 0.4 differ by less than 5 %.
constexpr double skin_ratio = 0.3;

}  // namespace

template <int D>
Solver<D>::Solver(const Scene& scene)
    : scene_(scene),
      fields_(place_particles<D>(scene, ranges_, walls_)),
      recipe_(make_recipe<D>(scene, ranges_, walls_, fields_)),
      loops_(pair_loops<D>()),
      kernel_loops_(loops_.kernels[recipe_.kernel.index()]),
      medium_needed_(recipe_.force_needs.medium || recipe_.filter_needs.medium || recipe_.density_diffusion > 0.0),
      smoothing_length_varies_(recipe_.variable_smoothing_length),
      position_(fields_.vector<D>(field::position)),
      initial_position_(fields_.vector<D>(field::initial_position)),
      velocity_(fields_.vector<D>(field::velocity)),
      listed_position_(nullptr),
      start_velocity_(nullptr),
      mass_(fields_.scalar(field::mass)),
      density_(fields_.scalar(field::density)),
      smoothing_length_(fields_.scalar(field::smoothing_length)),
      pressure_(fields_.scalar(field::pressure)),
      skin_(skin_ratio * scene.discretisation.spacing) {
  if (!recipe_.deformation) {
    fields_.require(field::listed_position, D);
    listed_position_ = fields_.vector<D>(field::listed_position);
  }
  if (smoothing_length_varies_) {
    fields_.require(field::listed_smoothing_length);
    listed_smoothing_length_ = fields_.scalar(field::listed_smoothing_length);
  }
  if (fields_.has(field::specific_energy)) specific_energy_ = fields_.scalar(field::specific_energy);
  if (fields_.has(field::kick_energy)) kick_energy_ = fields_.scalar(field::kick_energy);
  for (auto& field : fields_.fields())
    if (field.key->name == field::gradient_correction.name) correction_ = field.values;
  velocities_filtered_ = !recipe_.filters.empty() || recipe_.transport != nullptr;
  load_steps_.resize(recipe_.loads.size());
  face_stress_.resize(recipe_.loads.size());
  if (recipe_.transport) strain_rate_.resize(particle_count());
  if (velocities_filtered_) {
    fields_.require(field::start_velocity, D);
    start_velocity_ = fields_.vector<D>(field::start_velocity);
  }
  make_tiles();
  PairNeeds needs = recipe_.force_needs;
  needs.medium = medium_needed_;
  records_.resize(particle_count(), needs);
  make_wall_tiles();
  if (recipe_.deformation)
    freeze_pairs();
  else
    list_neighbours();
  find_corrections();
  if (scene.time.local_steps) {
    local_steps_.emplace();
    find_near_tiles();
  }
  strain(0.0);
  first_step_limit_ = step_limit_;
  ledger_.start_energy = kinetic_energy() + stored_energy() + energy_stored_by_walls();
  ledger_.start_momentum = momentum();
}

template <int D>
void Solver<D>::make_tiles() {
  for (std::size_t b = 0; b < ranges_.size(); ++b)
    for (std::int32_t begin = ranges_[b].begin; begin < ranges_[b].end; begin += tile_size)
      tiles_.push_back({{begin, std::min(begin + tile_size, ranges_[b].end)}, static_cast<int>(b)});
  reports_.resize(tiles_.size());
}

template <int D>
void Solver<D>::size_scratch() {
  std::int64_t most = 0;
  for (const auto* tiles : {&tiles_, &wall_tiles_})
    for (const Tile& tile : *tiles)
      most = std::max(most, neighbours_.first()[tile.range.end] - neighbours_.first()[tile.range.begin]);
  std::int32_t most_edges = 0;
  if (recipe_.edges)
    for (const Tile& tile : tiles_) most_edges = std::max(most_edges, recipe_.edges->edges_from(tile.range).count());
  const auto pairs = static_cast<std::size_t>(most);
  scratch_.resize(static_cast<std::size_t>(thread_count()));
  for (Scratch& scratch : scratch_) {
    if (!recipe_.deformation)
      for (auto& component : scratch.gradient) component.resize(std::max(pairs, component.size()));
    if (recipe_.corrected_gradients &&
        ((recipe_.force_needs.gradient && recipe_.force_needs.plain_gradient) || recipe_.density_diffusion > 0.0))
      for (auto& component : scratch.plain_gradient) component.resize(std::max(pairs, component.size()));
    if (recipe_.force_needs.value || recipe_.filter_needs.value || !walls_.empty())
      scratch.value.resize(std::max(pairs, scratch.value.size()));
    scratch.per_particle.resize(static_cast<std::size_t>(tile_size) * D * D);
    scratch.loss.resize(tile_size);
    scratch.sound_speed.resize(tile_size);
    scratch.per_edge.resize(static_cast<std::size_t>(most_edges) * D * D);
    if (recipe_.erosion)
      scratch.density_before.resize(static_cast<std::size_t>(std::max<std::int32_t>(tile_size, most_edges)));
    scratch.step_limit.resize(tile_size);
    if (D == 1) scratch.lateral_rate.resize(tile_size);
  }
}

template <int D>
PairTile<D> Solver<D>::open_tile(const Tile& tile, Scratch& scratch, PairNeeds needs) const {
  PairTile<D> pairs;
  pairs.begin = tile.range.begin;
  pairs.end = tile.range.end;
  pairs.first = neighbours_.first();
  pairs.neighbour = neighbours_.neighbours();
  if (recipe_.deformation) {
    for (std::size_t a = 0; a < D; ++a)
      pairs.gradient[a] = pairs.plain_gradient[a] =
          const_cast<double*>(frozen_gradient_[a].data()) + pairs.first[pairs.begin];
    return pairs;
  }
  const bool correct = needs.gradient && recipe_.corrected_gradients;
  for (std::size_t a = 0; a < D; ++a) {
    pairs.gradient[a] = scratch.gradient[a].data();
    pairs.plain_gradient[a] = correct && needs.plain_gradient ? scratch.plain_gradient[a].data() : pairs.gradient[a];
  }
  pairs.value = scratch.value.data();
  const bool gradient = needs.gradient || needs.plain_gradient;
  if (correct && !correction_.empty()) pairs.correction = &correction_[tile.range.first() * symmetric_components<D>];
  if (correct && !needs.value && kernel_loops_.corrected_gradients != nullptr) {
    pairs.uncorrected = kernel_loops_.corrected_gradients(pairs, records_);
    return pairs;
  }
  if (gradient && needs.value)
    kernel_loops_.both(pairs, records_);
  else if (gradient)
    kernel_loops_.gradients(pairs, records_);
  else if (needs.value)
    kernel_loops_.values(pairs, records_);
  if (correct) pairs.uncorrected = loops_.correct_gradients(pairs, records_);
  return pairs;
}

/// Before the first step, which has no gradients of the last one.
template <int D>
void Solver<D>::find_corrections() {
  if (correction_.empty()) return;
  for_each_tile([&](const Tile& tile, Scratch&, TileReport<D>&) {
    pack_geometry(tile.range);
    pack_motion(tile.range);
  });
  fill_image_places();
  for_each_tile(
      [&](const Tile& tile, Scratch& scratch, TileReport<D>&) { (void)open_tile(tile, scratch, {.gradient = true}); });
}

template <int D>
void Solver<D>::pack_geometry(ParticleRange range) {
  for (std::size_t i = range.first(); i < range.last(); ++i) {
    double* record = records_.geometry[i];
    for (int a = 0; a < D; ++a) record[a] = position_[i][a];
    record[D] = smoothing_length_[i];
  }
}

/// What straining changes of both.
template <int D>
void Solver<D>::pack_sizes(ParticleRange range) {
  for (std::size_t i = range.first(); i < range.last(); ++i) {
    records_.geometry[i][D] = smoothing_length_[i];
    records_.motion[i][D] = mass_[i] / density_[i];
  }
}

template <int D>
void Solver<D>::pack_velocities(ParticleRange range) {
  for (std::size_t i = range.first(); i < range.last(); ++i)
    for (int a = 0; a < D; ++a) records_.motion[i][a] = velocity_[i][a];
}

template <int D>
void Solver<D>::pack_motion(ParticleRange range) {
  for (std::size_t i = range.first(); i < range.last(); ++i) {
    double* record = records_.motion[i];
    for (int a = 0; a < D; ++a) record[a] = velocity_[i][a];
    if (!recipe_.deformation) record[D] = mass_[i] / density_[i];
  }
}

template <int D>
void Solver<D>::list_neighbours() {
  if (recipe_.images.wraps()) wrap_positions();
  if (recipe_.images.possible()) find_images();
  neighbours_.build(position_, smoothing_length_, recipe_.support, skin_, loops_, recipe_.images.sites());
  if constexpr (D == 1)
    if (recipe_.face_ghosts) recipe_.face_ghosts->list(neighbours_, records_, skin_, recipe_.images.count());
  size_scratch();
  for_each_tile([&](const Tile& tile, Scratch&, TileReport<D>&) {
    for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i) {
      listed_position_[i] = position_[i];
      if (smoothing_length_varies_) listed_smoothing_length_[i] = smoothing_length_[i];
    }
  });
  list_walls();
  ++list_builds_;
}

/// Geometry, and volumes for good, of the configuration that pairs are frozen in.
template <int D>
void Solver<D>::pack_start(ParticleRange range) {
  for (std::size_t i = range.first(); i < range.last(); ++i) {
    for (int a = 0; a < D; ++a) records_.geometry[i][a] = initial_position_[i][a];
    records_.geometry[i][D] = smoothing_length_[i];
    records_.motion[i][D] = recipe_.deformation->volume(i);
  }
  pack_motion(range);
}

/// Total Lagrangian scenes keep the pairs they start with, within bodies, and their gradients.
template <int D>
void Solver<D>::freeze_pairs() {
  std::vector<std::int32_t> body_of(particle_count());
  for (std::size_t b = 0; b < ranges_.size(); ++b)
    std::fill(body_of.begin() + ranges_[b].begin, body_of.begin() + ranges_[b].end, static_cast<std::int32_t>(b));
  find_images();
  neighbours_.build(initial_position_, smoothing_length_, recipe_.support, 0.0, loops_, recipe_.images.sites());
  const auto source = [&](std::int32_t record) {
    const auto j = static_cast<std::size_t>(record);
    return j < particle_count() ? j : recipe_.images.source(j - records_.first_image());
  };
  neighbours_.keep_only(
      [&](std::int32_t i, std::int32_t j) { return body_of[static_cast<std::size_t>(i)] == body_of[source(j)]; },
      loops_.lanes);
  for (auto& component : frozen_gradient_)
    component.assign(static_cast<std::size_t>(neighbours_.first()[particle_count()]), 0.0);
  size_scratch();
  for (const auto& range : ranges_) pack_start(range);
  fill_image_places();
  for_each_tile([&](const Tile& tile, Scratch& scratch, TileReport<D>& report) {
    const PairTile<D> pairs = open_tile(tile, scratch, {});
    kernel_loops_.gradients(pairs, records_);
    report.uncorrected = recipe_.deformation->find_corrections(pairs, records_);
  });
}

/// Only here, so that positions run on between two lists and every pair keeps its distance.
template <int D>
void Solver<D>::wrap_positions() {
  for_each_tile([&](const Tile& tile, Scratch&, TileReport<D>&) {
    for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i)
      position_[i] = recipe_.images.wrapped(position_[i]);
    pack_geometry(tile.range);
  });
}

template <int D>
void Solver<D>::find_images() {
  double longest = 0.0;
  for (const double h : smoothing_length_) longest = std::max(longest, h);
  recipe_.images.find(position_, smoothing_length_, recipe_.support * longest + skin_);
  records_.set_images(recipe_.images.count());
}

/// What sums over velocities read of images; the records of their sources are up to date.
template <int D>
void Solver<D>::fill_image_places() {
  recipe_.images.fill_geometry(records_, records_.first_image());
  recipe_.images.fill_motion(records_, records_.first_image());
}

/// What forces read of them besides.
template <int D>
void Solver<D>::fill_image_states() {
  if (recipe_.force_needs.nominal)
    recipe_.images.fill_nominal(records_, records_.first_image());
  else
    recipe_.images.fill_traction(records_, records_.first_image());
  if (medium_needed_) recipe_.images.fill_medium(records_, records_.first_image());
  recipe_.images.fill_responses(records_, records_.first_image());
}

std::unique_ptr<Simulation> make_simulation(const Scene& scene) {
  if (scene.domain.dimension == 1) return std::make_unique<Solver<1>>(scene);
  if (scene.domain.dimension == 2) return std::make_unique<Solver<2>>(scene);
  return std::make_unique<Solver<3>>(scene);
}

#define ANVIL_INSTANTIATE(D)                                                         \
  template Solver<D>::Solver(const Scene&);                                          \
  template PairTile<D> Solver<D>::open_tile(const Tile&, Scratch&, PairNeeds) const; \
  template void Solver<D>::pack_geometry(ParticleRange);                             \
  template void Solver<D>::pack_motion(ParticleRange);                               \
  template void Solver<D>::pack_sizes(ParticleRange);                                \
  template void Solver<D>::pack_velocities(ParticleRange);                           \
  template void Solver<D>::freeze_pairs();                                           \
  template void Solver<D>::fill_image_places();                                      \
  template void Solver<D>::fill_image_states();                                      \
  template void Solver<D>::list_neighbours()
ANVIL_INSTANTIATE(1);
ANVIL_INSTANTIATE(2);
ANVIL_INSTANTIATE(3);
#undef ANVIL_INSTANTIATE

}  // namespace anvil
