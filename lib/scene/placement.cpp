// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/placement.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>

#include "anvil/core/error.hpp"
#include "anvil/scene/concentric.hpp"
#include "anvil/scene/cut.hpp"

namespace anvil {

template <int D>
std::array<long long, D> count_cells(const Shape<D>& shape, double spacing) {
  const Vec<D> size = shape.size();
  std::array<long long, D> cells{};
  double all = 1.0;  // in doubles, which do not overflow
  for (int axis = 0; axis < D; ++axis) all *= std::max(1.0, std::round(size[axis] / spacing));
  if (!(all <= most_particles))
    throw InputError(
        fmt::format("a spacing of {} m fills the body with {:.3g} cells, and at most {:.3g} are possible; "
                    "choose a larger discretisation.spacing",
                    spacing, all, most_particles));
  for (int axis = 0; axis < D; ++axis)
    cells[static_cast<std::size_t>(axis)] = std::max(1LL, std::llround(size[axis] / spacing));
  return cells;
}

namespace {

/// Calls visit(index) for every index below `count` along each axis, the last axis fastest.
template <int D, class Visit>
void for_each_index(const std::array<long long, D>& count, Visit&& visit) {
  std::array<long long, D> index{};
  for (bool more = true; more;) {
    visit(index);
    more = false;
    for (std::size_t axis = D; axis-- > 0 && !more;) {
      more = ++index[axis] < count[axis];
      if (!more) index[axis] = 0;
    }
  }
}

/// From the middle of the lattice, measured in half spacings, so that mirrored places have offsets of the same
/// magnitude, bit by bit. `halves` is twice the index, from the first face.
template <int D>
Vec<D> lattice_offset(const std::array<long long, D>& halves, const std::array<long long, D>& cells, double spacing) {
  Vec<D> offset;
  for (std::size_t axis = 0; axis < D; ++axis)
    offset[static_cast<int>(axis)] = 0.5 * spacing * static_cast<double>(halves[axis] - cells[axis]);
  return offset;
}

template <int D>
using Index = std::array<long long, D>;

/// The cells along each axis whose middles lie in the shape.
template <int D>
class FilledCells {
 public:
  FilledCells(const Shape<D>& shape, const std::optional<Cut<D>>& cut, const Index<D>& cells, double spacing)
      : shape_(shape), cut_(cut), cells_(cells), spacing_(spacing) {}
  [[nodiscard]] Vec<D> middle(Index<D> cell) const {
    for (auto& along : cell) along = 2 * along + 1;
    return lattice_offset<D>(cell, cells_, spacing_);
  }
  [[nodiscard]] bool contains(const Index<D>& cell) const {
    for (std::size_t axis = 0; axis < D; ++axis)
      if (cell[axis] < 0 || cell[axis] >= cells_[axis]) return false;
    return shape_.contains(middle(cell));
  }
  /// The part of what stands at a place that its cell or face, with that middle, has within the shape: less than one
  /// where the shape is cut. Symmetric about the cut, both halves of a cell and of a particle are alike.
  [[nodiscard]] double part(const Vec<D>& place, const Vec<D>& middle) const {
    if (!cut_) return 1.0;
    const double on_plane = 1e-6 * spacing_;
    if (cut_->height(place) < -on_plane || cut_->height(middle) < -on_plane) return 0.0;
    return cut_->height(place) < on_plane && cut_->height(middle) < on_plane ? 0.5 : 1.0;
  }
  /// Calls visit(axis, upper) for each side on which a cell of the shape ends it.
  template <class Visit>
  void for_each_open_side(const Index<D>& cell, Visit&& visit) const {
    for (std::size_t axis = 0; axis < D; ++axis) {
      for (const bool upper : {false, true}) {
        auto beyond = cell;
        beyond[axis] += upper ? 1 : -1;
        if (!contains(beyond)) visit(axis, upper);
      }
    }
  }

 private:
  const Shape<D>& shape_;
  std::optional<Cut<D>> cut_;
  Index<D> cells_;
  double spacing_;
};

/// One particle in the middle of each cell of the shape.
template <int D>
PlacedBody<D> fill_cells(const FilledCells<D>& filled, const Index<D>& cells, double spacing) {
  PlacedBody<D> placed;
  const double area = std::pow(spacing, D - 1);
  for_each_index<D>(cells, [&](const Index<D>& cell) {
    if (!filled.contains(cell)) return;
    filled.for_each_open_side(cell, [&](std::size_t axis, bool upper) {
      const Vec<D> outward = (upper ? 0.5 : -0.5) * spacing * Vec<D>::Unit(static_cast<int>(axis));
      const Vec<D> middle = filled.middle(cell) + outward;
      const double part = filled.part(middle, middle);
      if (part > 0.0)
        placed.surface.push_back({static_cast<std::int32_t>(placed.positions.size()), outward, part * area});
    });
    placed.positions.push_back(filled.middle(cell));
    placed.volumes.push_back(filled.part(filled.middle(cell), filled.middle(cell)));
  });
  return placed;
}

/// Numbers of the corners of the cells, the last axis fastest.
template <int D>
std::size_t corner_number(const Index<D>& corner, const Index<D>& cells) {
  std::size_t flat = 0;
  for (std::size_t axis = 0; axis < D; ++axis)
    flat = flat * static_cast<std::size_t>(cells[axis] + 1) + static_cast<std::size_t>(corner[axis]);
  return flat;
}

/// The corners of the face in which a cell ends along an axis, in the order of BodyFacet.
template <int D>
std::array<Index<D>, D == 3 ? 4 : (D == 2 ? 2 : 1)> face_corners(const Index<D>& cell, std::size_t axis, bool upper) {
  Index<D> base = cell;
  if (upper) ++base[axis];
  if constexpr (D == 1) {
    return {base};
  } else if constexpr (D == 2) {
    Index<D> other = base;
    ++other[1 - axis];
    // Along +y the outside of an upper face across x is on the right, along +x that of a lower face across y.
    if (upper == (axis == 0)) return {base, other};
    return {other, base};
  } else {
    const std::size_t first = (axis + 1) % 3, second = (axis + 2) % 3;  // first x second = axis
    std::array<Index<D>, 4> corners{base, base, base, base};
    ++corners[upper ? 1 : 3][first];
    ++corners[2][first];
    ++corners[2][second];
    ++corners[upper ? 3 : 1][second];
    return corners;
  }
}

/// Calls visit(index) as for_each_index does, but the axis with the most indices changes slowest: what is visited one
/// after the other then lies in slabs across a long body, with few neighbours outside.
template <int D, class Visit>
void for_each_index_in_slabs(const Index<D>& count, Visit&& visit) {
  std::array<std::size_t, D> axes;
  std::iota(axes.begin(), axes.end(), std::size_t{0});
  std::stable_sort(axes.begin(), axes.end(), [&](std::size_t a, std::size_t b) { return count[a] > count[b]; });
  Index<D> sorted;
  for (std::size_t k = 0; k < D; ++k) sorted[k] = count[axes[k]];
  for_each_index<D>(sorted, [&](const Index<D>& at) {
    Index<D> index;
    for (std::size_t k = 0; k < D; ++k) index[axes[k]] = at[k];
    visit(index);
  });
}

/// A face between a cell of the shape and the outside.
template <int D>
struct OpenFace {
  Index<D> cell;
  std::size_t axis;
  bool upper;
};

/// The place of a corner of the cells, from the middle of the lattice.
template <int D>
Vec<D> corner_offset(Index<D> corner, const Index<D>& cells, double spacing) {
  for (auto& along : corner) along *= 2;
  return lattice_offset<D>(corner, cells, spacing);
}

/// Spacings along the axes with which that many cells fill the volume of the shape. Where it ends in planes they are
/// given; a staircase encloses some percent more or less than the round face it stands for, and is drawn in or out.
/// Only in 3D, whose round shapes are whole: rings in 2D may end at planes of symmetry, where particles have to stay.
template <int D>
Vec<D> filling_spacings(const Shape<D>& shape, double cells, double spacing) {
  Vec<D> spacings = Vec<D>::Constant(spacing);
  int free = 0;
  for (int axis = 0; axis < D; ++axis) free += shape.ends_in_planes(axis) ? 0 : 1;
  if (D != 3 || free == 0 || cells == 0.0) return spacings;
  const double ratio = std::pow(shape.volume() / (cells * std::pow(spacing, D)), 1.0 / free);
  for (int axis = 0; axis < D; ++axis)
    if (!shape.ends_in_planes(axis)) spacings[axis] *= ratio;
  return spacings;
}

/// The facets of faces whose corners are all particles, and of every face the parts that belong to its corners.
template <int D>
void place_faces(const std::vector<OpenFace<D>>& faces, const FilledCells<D>& filled, const Index<D>& cells,
                 double spacing, const Vec<D>& spacings, const std::vector<std::int32_t>& particle_at,
                 PlacedBody<D>& placed) {
  constexpr std::size_t corners = D == 1 ? 1 : BodyFacet<D>{}.size();
  std::vector<double> area(placed.positions.size(), 0.0);
  for (const OpenFace<D>& face : faces) {
    Vec<D> middle = filled.middle(face.cell);
    middle[static_cast<int>(face.axis)] += (face.upper ? 0.5 : -0.5) * spacing;
    BodyFacet<D> facet{};
    if constexpr (D == 1) facet[1] = face.upper ? 1 : -1;
    std::size_t next = 0;
    bool whole = true;
    for (const auto& corner : face_corners<D>(face.cell, face.axis, face.upper)) {
      const std::int32_t particle = particle_at[corner_number<D>(corner, cells)];
      const double part = filled.part(corner_offset<D>(corner, cells, spacing), middle);
      whole = whole && part > 0.0;
      facet[next++] = particle;
      if (part > 0.0)
        area[static_cast<std::size_t>(particle)] +=
            part * spacings.prod() / spacings[static_cast<int>(face.axis)] / static_cast<double>(corners);
    }
    if (whole) placed.facets.push_back(facet);
  }
  for (std::size_t i = 0; i < area.size(); ++i)
    if (area[i] > 0.0) placed.surface.push_back({static_cast<std::int32_t>(i), Vec<D>::Zero(), area[i]});
}

/// One particle on each corner of a cell of the shape, with an equal share of every cell that it belongs to, and the
/// faces between cells of the shape and the outside.
template <int D>
PlacedBody<D> share_cells(const Shape<D>& shape, const FilledCells<D>& filled, const Index<D>& cells, double spacing) {
  Index<D> corners = cells;
  for (auto& count : corners) ++count;
  std::size_t all = 1;
  for (const long long count : corners) all *= static_cast<std::size_t>(count);
  std::vector<double> share(all, 0.0);
  std::vector<OpenFace<D>> faces;
  for_each_index<D>(cells, [&](const Index<D>& cell) {
    if (!filled.contains(cell)) return;
    for (unsigned corner = 0; corner < 1U << D; ++corner) {
      auto index = cell;
      for (std::size_t axis = 0; axis < D; ++axis) index[axis] += corner >> axis & 1U;
      const double part = filled.part(corner_offset<D>(index, cells, spacing), filled.middle(cell));
      share[corner_number<D>(index, cells)] += part / (1U << D);
    }
    filled.for_each_open_side(cell, [&](std::size_t axis, bool upper) { faces.push_back({cell, axis, upper}); });
  });
  PlacedBody<D> placed;
  const Vec<D> spacings = filling_spacings<D>(shape, std::accumulate(share.begin(), share.end(), 0.0), spacing);
  std::vector<std::int32_t> particle_at(all, -1);
  for_each_index_in_slabs<D>(corners, [&](const Index<D>& index) {
    const std::size_t number = corner_number<D>(index, cells);
    if (share[number] == 0.0) return;
    particle_at[number] = static_cast<std::int32_t>(placed.positions.size());
    placed.positions.push_back(corner_offset<D>(index, cells, spacing).cwiseProduct(spacings / spacing));
    placed.volumes.push_back(share[number]);
  });
  place_faces<D>(faces, filled, cells, spacing, spacings, particle_at, placed);
  return placed;
}

}  // namespace

template <int D>
PlacedBody<D> place_body(const BodyDescription& body, double spacing) {
  if constexpr (D == 2)
    if (body.lattice == "concentric") return place_concentric(body, spacing);
  const auto shape = make_shape<D>(body.shape);
  const auto cells = count_cells<D>(*shape, spacing);
  const FilledCells<D> filled(*shape, cut_of<D>(body.shape), cells, spacing);
  PlacedBody<D> placed = body.lattice == "face_lattice" ? share_cells<D>(*shape, filled, cells, spacing)
                                                        : fill_cells<D>(filled, cells, spacing);
  if (placed.positions.empty())
    throw InputError(fmt::format("body '{}' holds no particle at a spacing of {} m", body.name, spacing));
  const double scale = shape->volume() / std::accumulate(placed.volumes.begin(), placed.volumes.end(), 0.0);
  for (double& volume : placed.volumes) volume *= scale;
  const Mat<D> rotation = rotation_of<D>(body);
  const bool turned = !body.rotation.empty();
  std::mt19937 random(1);  // whose numbers are the same everywhere
  for (Vec<D>& position : placed.positions) {
    position = shape->centre() + shape->turned(position);
    for (int axis = 0; body.jitter > 0.0 && axis < D; ++axis)
      position[axis] += body.jitter * spacing * (static_cast<double>(random()) * 0x1p-31 - 1.0);
    if (turned) position = (rotation * position).eval();
  }
  if (turned)
    for (auto& point : placed.surface) point.offset = (rotation * point.offset).eval();
  return placed;
}

template <int D>
Mat<D> rotation_of(const BodyDescription& body) {
  Mat<D> rotation = Mat<D>::Identity();
  if (body.rotation.empty()) return rotation;
  if constexpr (D == 2) rotation = Eigen::Rotation2D<double>(body.rotation[0]).toRotationMatrix();
  if constexpr (D == 3) {
    const Vec<3> turn(body.rotation.data());
    if (turn.norm() > 0.0) rotation = Eigen::AngleAxis<double>(turn.norm(), turn.normalized()).toRotationMatrix();
  }
  return rotation;
}

template Mat<1> rotation_of<1>(const BodyDescription&);
template Mat<2> rotation_of<2>(const BodyDescription&);
template Mat<3> rotation_of<3>(const BodyDescription&);

template std::array<long long, 1> count_cells<1>(const Shape<1>&, double);
template std::array<long long, 2> count_cells<2>(const Shape<2>&, double);
template std::array<long long, 3> count_cells<3>(const Shape<3>&, double);
template PlacedBody<1> place_body<1>(const BodyDescription&, double);
template PlacedBody<2> place_body<2>(const BodyDescription&, double);
template PlacedBody<3> place_body<3>(const BodyDescription&, double);

}  // namespace anvil
