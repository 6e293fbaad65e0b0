// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/overlap.hpp"

#include <cmath>
#include <map>

#include "anvil/scene/cut.hpp"
#include "anvil/scene/placement.hpp"
#include "anvil/scene/shape.hpp"

namespace anvil {
namespace {

template <int D>
bool is_box(const Shape<D>& shape) {
  for (int axis = 0; axis < D; ++axis)
    if (!shape.ends_in_planes(axis)) return false;
  return true;
}

template <int D>
bool surrounding_boxes_overlap(const Shape<D>& first, const Shape<D>& second, double spacing) {
  constexpr double tolerance = 1e-6;  // of a spacing: bodies that touch do not overlap because of rounding
  const Vec<D> apart = (first.centre() - second.centre()).cwiseAbs();
  const Vec<D> reach = 0.5 * (first.size() + second.size());
  return ((reach - apart).array() > tolerance * spacing).all();
}

/// Cubes of half a spacing, in which a lattice has one particle at most. Numbered in doubles, which do not overflow.
template <int D>
class Cells {
 public:
  Cells(const std::vector<Vec<D>>& positions, double side) : side_(side) {
    for (const auto& position : positions) cells_.emplace(cell_of(position), position);
  }
  /// Whether a particle lies within one side of the position.
  [[nodiscard]] bool has_neighbour(const Vec<D>& position) const {
    const Cell middle = cell_of(position);
    const int shifts = static_cast<int>(std::pow(3, D));
    for (int shift = 0; shift < shifts; ++shift) {
      Cell cell = middle;
      for (int axis = 0, rest = shift; axis < D; ++axis, rest /= 3)
        cell[static_cast<std::size_t>(axis)] += rest % 3 - 1;
      const auto found = cells_.find(cell);
      if (found != cells_.end() && (found->second - position).norm() < side_) return true;
    }
    return false;
  }

 private:
  using Cell = std::array<double, D>;
  [[nodiscard]] Cell cell_of(const Vec<D>& position) const {
    Cell cell{};
    for (int axis = 0; axis < D; ++axis) cell[static_cast<std::size_t>(axis)] = std::floor(position[axis] / side_);
    return cell;
  }
  double side_;
  std::map<Cell, Vec<D>> cells_;
};

}  // namespace

template <int D>
bool bodies_overlap(const BodyDescription& first, const BodyDescription& second, double spacing) {
  const auto first_shape = make_shape<D>(first.shape);
  const auto second_shape = make_shape<D>(second.shape);
  const bool turned_alike = first.rotation == second.rotation;
  if (turned_alike && !surrounding_boxes_overlap<D>(*first_shape, *second_shape, spacing)) return false;
  const bool whole = !cut_of<D>(first.shape) && !cut_of<D>(second.shape);
  if (turned_alike && whole && is_box<D>(*first_shape) && is_box<D>(*second_shape)) return true;
  const auto placed = place_body<D>(first, spacing);
  const Cells<D> cells(placed.positions, 0.5 * spacing);
  for (const auto& position : place_body<D>(second, spacing).positions)
    if (cells.has_neighbour(position)) return true;
  return false;
}

template bool bodies_overlap<1>(const BodyDescription&, const BodyDescription&, double);
template bool bodies_overlap<2>(const BodyDescription&, const BodyDescription&, double);
template bool bodies_overlap<3>(const BodyDescription&, const BodyDescription&, double);

}  // namespace anvil
