// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/solver/solver.hpp"

#include <algorithm>

#include "anvil/core/field_keys.hpp"
#include "anvil/solver/tiles.hpp"

namespace anvil {
namespace {

/// Particles per tile: the gradients of their pairs, some 70 of 24 bytes per particle, stay in the second-level cache.
/// Tiles of 32 and 128 took 1 to 4 % less time in two runs of benchmark_rod, no more than its noise.
constexpr std::int32_t tile_size = 64;

/// Thickness of the neighbour list's skin over the spacing: rows grow by a third, and a rod at 227 m/s keeps its list
/// for 8 steps right after the impact. By benchmark_rod the optimum is flat: 0.2 and 0.4 differ by less than 5 %.
constexpr double skin_ratio = 0.3;

}  // namespace

template <int D>
Solver<D>::Solver(const Scene& scene)
    : scene_(scene),
      fields_(place_particles<D>(scene, ranges_)),
      recipe_(make_recipe<D>(scene, ranges_, fields_)),
      loops_(pair_loops<D>()),
      kernel_loops_(loops_.kernels[recipe_.kernel.index()]),
      medium_needed_(recipe_.force_needs.medium || recipe_.filter_needs.medium),
      smoothing_length_varies_(recipe_.variable_smoothing_length),
      position_(fields_.vector<D>(field::position)),
      initial_position_(fields_.vector<D>(field::initial_position)),
      velocity_(fields_.vector<D>(field::velocity)),
      listed_position_((fields_.require(field::listed_position, D), fields_.vector<D>(field::listed_position))),
      start_velocity_(nullptr),
      mass_(fields_.scalar(field::mass)),
      density_(fields_.scalar(field::density)),
      smoothing_length_(fields_.scalar(field::smoothing_length)),
      pressure_(fields_.scalar(field::pressure)),
      skin_(skin_ratio * scene.discretisation.spacing) {
  if (smoothing_length_varies_) {
    fields_.require(field::listed_smoothing_length);
    listed_smoothing_length_ = fields_.scalar(field::listed_smoothing_length);
  }
  velocities_filtered_ = !recipe_.filters.empty() || recipe_.transport != nullptr;
  load_steps_.resize(recipe_.loads.size());
  face_stress_.resize(recipe_.loads.size());
  if (recipe_.transport) strain_rate_.resize(particle_count());
  if (velocities_filtered_) {
    fields_.require(field::start_velocity, D);
    start_velocity_ = fields_.vector<D>(field::start_velocity);
  }
  make_tiles();
  records_.resize(particle_count(), medium_needed_);
  list_neighbours();
  strain(0.0);
  first_step_limit_ = step_limit_;
  ledger_.start_energy = kinetic_energy() + elastic_energy();
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
  for (const Tile& tile : tiles_)
    most = std::max(most, neighbours_.first()[tile.range.end] - neighbours_.first()[tile.range.begin]);
  const auto pairs = static_cast<std::size_t>(most);
  scratch_.resize(static_cast<std::size_t>(thread_count()));
  for (Scratch& scratch : scratch_) {
    for (auto& component : scratch.gradient) component.resize(std::max(pairs, component.size()));
    if (recipe_.corrected_gradients && recipe_.force_needs.gradient && recipe_.force_needs.plain_gradient)
      for (auto& component : scratch.plain_gradient) component.resize(std::max(pairs, component.size()));
    if (recipe_.force_needs.value || recipe_.filter_needs.value)
      scratch.value.resize(std::max(pairs, scratch.value.size()));
    scratch.per_particle.resize(static_cast<std::size_t>(tile_size) * D * D);
    scratch.loss.resize(tile_size);
    scratch.sound_speed.resize(tile_size);
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
  const bool correct = needs.gradient && recipe_.corrected_gradients;
  for (std::size_t a = 0; a < D; ++a) {
    pairs.gradient[a] = scratch.gradient[a].data();
    pairs.plain_gradient[a] = correct && needs.plain_gradient ? scratch.plain_gradient[a].data() : pairs.gradient[a];
  }
  pairs.value = scratch.value.data();
  const bool gradient = needs.gradient || needs.plain_gradient;
  if (gradient && needs.value)
    kernel_loops_.both(pairs, records_);
  else if (gradient)
    kernel_loops_.gradients(pairs, records_);
  else if (needs.value)
    kernel_loops_.values(pairs, records_);
  if (correct) pairs.uncorrected = loops_.correct_gradients(pairs, records_);
  return pairs;
}

template <int D>
void Solver<D>::pack_geometry(ParticleRange range) {
  for (std::size_t i = range.first(); i < range.last(); ++i) {
    double* record = records_.geometry[i];
    for (int a = 0; a < D; ++a) record[a] = position_[i][a];
    record[D] = smoothing_length_[i];
  }
}

template <int D>
void Solver<D>::pack_motion(ParticleRange range) {
  for (std::size_t i = range.first(); i < range.last(); ++i) {
    double* record = records_.motion[i];
    for (int a = 0; a < D; ++a) record[a] = velocity_[i][a];
    record[D] = mass_[i] / density_[i];
  }
}

template <int D>
void Solver<D>::list_neighbours() {
  neighbours_.build(position_, smoothing_length_, recipe_.support, skin_, loops_);
  if constexpr (D == 1)
    if (recipe_.face_ghosts) recipe_.face_ghosts->list(neighbours_, records_, skin_);
  size_scratch();
  for_each_tile([&](const Tile& tile, Scratch&, TileReport<D>&) {
    for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i) {
      listed_position_[i] = position_[i];
      if (smoothing_length_varies_) listed_smoothing_length_[i] = smoothing_length_[i];
    }
  });
  ++list_builds_;
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
  template void Solver<D>::list_neighbours()
ANVIL_INSTANTIATE(1);
ANVIL_INSTANTIATE(2);
ANVIL_INSTANTIATE(3);
#undef ANVIL_INSTANTIATE

}  // namespace anvil
