// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "anvil/core/tensor.hpp"
#include "anvil/scene/scene.hpp"
#include "anvil/scene/shape.hpp"

namespace anvil {

/// The particles of one body: their centres in m and their volumes in m^D.
template <int D>
struct PlacedBody {
  std::vector<Vec<D>> positions;
  std::vector<double> volumes;
};

/// The most particles, and cells tried for them, that one body may have: about 100 GB of fields and neighbour lists.
inline constexpr double most_particles = 1e8;

/// Cells of `spacing` along each axis of the box around the shape: as many as fit best, one at least.
/// Throws InputError when there are more than most_particles.
template <int D>
std::array<long long, D> count_cells(const Shape<D>& shape, double spacing);

/// Fills the body's shape with a cubic lattice (a square one in 2D, a line in 1D) of cells of `spacing`, centred on the
/// shape and mirror-symmetric about its middle; N particles span N spacings, so the outermost centres lie half a
/// spacing inside the faces of a box. A cell becomes a particle when its centre lies in the shape. All particles have
/// the same volume, and their sum is the exact volume of the shape whatever the spacing: where a curved face cuts
/// cells, or a length is no whole number of spacings, all volumes are scaled alike. Order: the last coordinate changes
/// fastest. With the lattice `concentric` see place_concentric. Throws InputError when no cell lies in the shape, or
/// too many do.
template <int D>
PlacedBody<D> place_body(const BodyDescription& body, double spacing);

}  // namespace anvil
