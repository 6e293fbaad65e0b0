// SPDX-License-Identifier: BSD-3-Clause
// Erosion of a total Lagrangian body, as finite elements that are deformed past use are taken out: a stress point that
// is squeezed below a least stretch, or turned inside out, carries no stress from then on. Masses stay, and move with
// what is left around them. What elastic energy the point held is lost, and counted.
#include <algorithm>

#include "anvil/core/field_keys.hpp"
#include "anvil/materials/strain_state.hpp"
#include "anvil/solver/solver.hpp"

namespace anvil {
namespace {

ParticleRange only(std::size_t point) {
  const auto begin = static_cast<std::int32_t>(point);
  return {begin, begin + 1};
}

template <int D>
void release_shear(FieldStore& points, std::size_t point) {
  constexpr std::size_t components = StrainStateOf<D>::Type::components;
  if (!points.has(field::deviatoric_stress)) return;
  std::fill_n(points.vector<components>(field::deviatoric_stress).raw() + point * components, components, 0.0);
}

}  // namespace

/// After the particles of the tile have deformed and before their stress follows: eroded ones have the density of no
/// stress and do not strain.
template <int D>
void Solver<D>::erode_particles(const Tile& tile, Scratch& scratch, TileReport<D>& report) {
  const Body<D>& body = recipe_.bodies[static_cast<std::size_t>(tile.body)];
  const std::span<double> eroded = fields_.scalar(field::eroded);
  for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i) {
    const std::size_t local = i - tile.range.first();
    if (eroded[i] == 0.0) {
      if (recipe_.deformation->least_stretch(i) > *recipe_.erosion) continue;
      eroded[i] = 1.0;
      density_[i] = scratch.density_before[local];
      report.erosion_loss += body.eos->elastic_energy(only(i));
      if (!recipe_.edges) {
        report.erosion_loss += body.strength->elastic_energy(only(i));
        release_shear<D>(fields_, i);
      }
    }
    density_[i] = recipe_.deformation->reference_density(i);
    std::fill_n(&scratch.per_particle[local * D * D], D * D, 0.0);
  }
}

/// The same for the edges of the tile. One that has turned inside out is no reason to stop.
template <int D>
void Solver<D>::erode_edges(const Tile& tile, Scratch& scratch, TileReport<D>& report) {
  const Body<D>& body = recipe_.bodies[static_cast<std::size_t>(tile.body)];
  FieldStore& fields = recipe_.edges->fields();
  const std::span<double> eroded = fields.scalar(field::eroded), density = fields.scalar(field::density);
  const ParticleRange edges = recipe_.edges->edges_from(tile.range);
  report.inverted_edge_at = -1;
  for (std::size_t e = edges.first(); e < edges.last(); ++e) {
    const std::size_t local = e - edges.first();
    if (eroded[e] == 0.0) {
      if (recipe_.edges->least_stretch(e) > *recipe_.erosion) continue;
      eroded[e] = 1.0;
      density[e] = scratch.density_before[local];
      report.erosion_loss += body.strength->elastic_energy(only(e));
      release_shear<D>(fields, e);
    }
    density[e] = recipe_.deformation->reference_density(tile.range.first());
    std::fill_n(&scratch.per_edge[local * D * D], D * D, 0.0);
  }
}

/// Mass of the stress points that carry no stress any more, kg.
template <int D>
double Solver<D>::eroded_mass(const FieldStore& points) const {
  const std::span<const double> eroded = points.scalar(field::eroded), mass = points.scalar(field::mass);
  double sum = 0.0;
  for (std::size_t point = 0; point < eroded.size(); ++point) sum += eroded[point] * mass[point];
  return sum;
}

#define ANVIL_INSTANTIATE(D)                                                       \
  template void Solver<D>::erode_particles(const Tile&, Scratch&, TileReport<D>&); \
  template void Solver<D>::erode_edges(const Tile&, Scratch&, TileReport<D>&);     \
  template double Solver<D>::eroded_mass(const FieldStore&) const
ANVIL_INSTANTIATE(1);
ANVIL_INSTANTIATE(2);
ANVIL_INSTANTIATE(3);
#undef ANVIL_INSTANTIATE

}  // namespace anvil
