// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "anvil/core/tensor.hpp"
#include "anvil/scene/scene.hpp"
#include "anvil/scene/shape.hpp"

namespace anvil {

/// A piece of a surface by the numbers of its particles: a quadrilateral in 3D, counterclockwise seen from outside; a
/// segment in 2D, outside on its right; in 1D a particle and the direction in which it faces, +1 or -1.
template <int D>
using BodyFacet = std::array<std::int32_t, D == 3 ? 4 : 2>;

/// A piece of face that belongs to one particle, and where it is seen from it before anything has moved.
template <int D>
struct SurfacePoint {
  std::int32_t particle;
  Vec<D> offset;  // m
  double area;    // m^(D-1)
};

/// The particles of one body: their centres in m and their volumes in m^D. Where particles stand on its faces, these.
template <int D>
struct PlacedBody {
  std::vector<Vec<D>> positions;
  std::vector<double> volumes;
  std::vector<BodyFacet<D>> facets;
  std::vector<SurfacePoint<D>> surface;  // by particle
};

/// The rotation about the origin that a body is placed with; the unit matrix in 1D.
template <int D>
Mat<D> rotation_of(const BodyDescription& body);

/// The most particles, and cells tried for them, that one body may have: about 100 GB of fields and neighbour lists.
inline constexpr double most_particles = 1e8;

/// Cells of `spacing` along each axis of the box around the shape: as many as fit best, one at least.
/// Throws InputError when there are more than most_particles.
template <int D>
std::array<long long, D> count_cells(const Shape<D>& shape, double spacing);

/// Fills the body's shape with a cubic lattice (a square one in 2D, a line in 1D) of cells of `spacing`, centred on the
/// shape and mirror-symmetric about its middle. A cell belongs to the body when its centre lies in the shape.
/// Lattice `cubic`: each cell becomes a particle; N particles span N spacings, so the outermost centres lie half a
/// spacing inside the faces of a box. Lattice `face_lattice`: particles stand on the corners of the cells and share
/// their volumes; those on the faces, edges and corners of a box have a half, a quarter and an eighth of a cell.
/// The volumes add up to the exact volume of the shape whatever the spacing: where a curved face cuts cells, or a
/// length is no whole number of spacings, all are scaled alike. The whole is then turned about the origin. Order: the
/// last coordinate of the shape changes fastest; with `face_lattice` that along which the body is longest changes
/// slowest. With the lattice `concentric` see place_concentric. Throws InputError
/// when no cell lies in the shape, or too many do.
template <int D>
PlacedBody<D> place_body(const BodyDescription& body, double spacing);

}  // namespace anvil
