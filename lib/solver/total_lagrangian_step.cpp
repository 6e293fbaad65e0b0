// SPDX-License-Identifier: BSD-3-Clause
// The half of a step in which total Lagrangian particles differ: what strains them follows from the configuration they
// started in, and their stress returns to it.
#include <algorithm>
#include <cmath>
#include <utility>

#include "anvil/core/field_keys.hpp"
#include "anvil/solver/tiles.hpp"

namespace anvil {

template <int D>
void Solver<D>::strain_from_reference(double time_step) {
  for_each_tile([&](const Tile& tile, Scratch& scratch, TileReport<D>& report) {
    deform_from_reference(tile, scratch, time_step, report);
  });
  // An edge reads both its ends, a particle all its edges: each pass needs the whole of the one before.
  if (recipe_.edges)
    for_each_tile([&](const Tile& tile, Scratch& scratch, TileReport<D>& report) {
      deform_edges(tile, scratch, time_step, report);
    });
  for_each_tile([&](const Tile& tile, Scratch&, TileReport<D>&) {
    for (const auto& force : recipe_.forces) force->pack(tile.range, records_);
  });
  collect_strain_reports();
}

template <int D>
void Solver<D>::deform_from_reference(const Tile& tile, Scratch& scratch, double time_step, TileReport<D>& report) {
  const Body<D>& body = recipe_.bodies[static_cast<std::size_t>(tile.body)];
  double* velocity_gradient = scratch.per_particle.data();
  report.plastic_work = 0.0;
  report.bulk_viscous_loss = 0.0;
  if (time_step > 0.0) {
    loops_.velocity_gradient(open_tile(tile, scratch, {.gradient = true}), records_, velocity_gradient);
    if (recipe_.erosion)
      std::copy_n(density_.begin() + tile.range.begin, tile.range.count(), scratch.density_before.begin());
    recipe_.deformation->advance(tile.range, velocity_gradient, time_step);
    if (recipe_.erosion) erode_particles(tile, scratch, report);
    if (!recipe_.edges) report.plastic_work = body.strength->update(tile.range, velocity_gradient, nullptr, time_step);
  }
  body.eos->update(tile.range, scratch.sound_speed.data());
  const double* stretch = scratch.step_limit.data();
  recipe_.deformation->find_least_stretches(tile.range, scratch.step_limit.data());
  if (recipe_.bulk_viscosity && time_step > 0.0)
    report.bulk_viscous_loss =
        recipe_.bulk_viscosity->update(tile.range, velocity_gradient, scratch.sound_speed.data(), time_step,
                                       [&](std::size_t i) { return stretch[i - tile.range.first()]; });
  limit_and_check_deformed(tile, scratch, report);
}

template <int D>
void Solver<D>::deform_edges(const Tile& tile, Scratch& scratch, double time_step, TileReport<D>& report) {
  const ParticleRange edges = recipe_.edges->edges_from(tile.range);
  if (recipe_.erosion) {
    const std::span<const double> density = std::as_const(*recipe_.edges).fields().scalar(field::density);
    std::copy_n(density.begin() + edges.begin, edges.count(), scratch.density_before.begin());
  }
  report.inverted_edge_at = recipe_.edges->deform(edges, *recipe_.deformation, time_step, scratch.per_edge.data());
  if (recipe_.erosion) erode_edges(tile, scratch, report);
  if (time_step > 0.0)
    report.plastic_work = recipe_.bodies[static_cast<std::size_t>(tile.body)].strength->update(
        edges, scratch.per_edge.data(), nullptr, time_step);
  recipe_.edges->pull_back(edges);
}

/// dt = cfl spacing s/c with the longitudinal wave speed c and the least stretch s: a squeezed layer is crossed sooner.
template <int D>
void Solver<D>::limit_and_check_deformed(const Tile& tile, const Scratch& scratch, TileReport<D>& report) {
  const double *bulk_sound_speed_squared = scratch.sound_speed.data(), *stretches = scratch.step_limit.data();
  const double shear_modulus = recipe_.bodies[static_cast<std::size_t>(tile.body)].strength->shear_modulus();
  const double* eroded = recipe_.erosion ? fields_.scalar(field::eroded).data() : nullptr;
  report.step_limit = std::numeric_limits<double>::max();
  for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i, ++stretches) {
    const double wave_speed = std::sqrt(*bulk_sound_speed_squared++ + 4.0 / 3.0 * shear_modulus / density_[i]);
    const double stretch = eroded != nullptr && eroded[i] != 0.0 ? std::numeric_limits<double>::max() : *stretches;
    const double limit = scene_.time.cfl * scene_.discretisation.spacing * stretch / wave_speed;
    const bool sound = density_[i] > 0.0 && limit > 0.0 && std::isfinite(pressure_[i]);
    if (!sound && report.broken_particle < 0) report.broken_particle = static_cast<std::int32_t>(i);
    if (limit < report.step_limit) {
      report.step_limit = limit;
      report.limiting_particle = static_cast<std::int32_t>(i);
    }
  }
}

#define ANVIL_INSTANTIATE(D)                                                                     \
  template void Solver<D>::strain_from_reference(double);                                        \
  template void Solver<D>::deform_from_reference(const Tile&, Scratch&, double, TileReport<D>&); \
  template void Solver<D>::deform_edges(const Tile&, Scratch&, double, TileReport<D>&)
ANVIL_INSTANTIATE(1);
ANVIL_INSTANTIATE(2);
ANVIL_INSTANTIATE(3);
#undef ANVIL_INSTANTIATE

}  // namespace anvil
