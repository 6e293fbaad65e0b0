// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "anvil/core/tensor.hpp"
#include "anvil/scene/scene.hpp"

namespace anvil {

/// A flat piece of a wall: corner + sum of u_k edge_k with 0 <= u_k <= 1. Edges are orthogonal; the unit normal points
/// to where particles may be. In one dimension a point.
template <int D>
struct Facet {
  Vec<D> corner, normal;
  std::array<Vec<D>, D - 1> edges;
};

/// A dummy particle of a wall and the row it stands in, 0 for the one nearest to the surface.
template <int D>
struct WallPoint {
  Vec<D> position, normal;
  int row;
};

/// A wall as it is drawn in a scene: in 2D a path, along which the particles lie on the left, in 3D the inside or the
/// outside of a box, some of whose faces may be open.
template <int D>
class WallSurface {
 public:
  /// From the keys of a wall of dummy particles (see wall_keys). Throws InputError when they describe none.
  explicit WallSurface(const Parameters& keys);

  [[nodiscard]] const std::vector<Facet<D>>& facets() const { return facets_; }
  /// Whether the straight way between the positions (m) leads through the wall from the side of the particles.
  [[nodiscard]] bool crossed(const Vec<D>& from, const Vec<D>& to) const;
  /// Dummy particles behind the surface, `spacing` (m) apart, the first row `first_row` spacings behind it. Corners are
  /// filled: rows meet in their bisector, and no two stand nearer than half a spacing. Rows in turn, the first first.
  [[nodiscard]] std::vector<WallPoint<D>> rows(double spacing, double first_row, int count) const;

 private:
  void add_row(double distance, double spacing, int row, std::vector<WallPoint<D>>& points) const;

  std::vector<Facet<D>> facets_;
  std::vector<Vec<D>> path_;  // in 2D
  bool closed_ = false;
  Vec<D> least_, greatest_;  // of the box in 3D
  bool outside_ = false;
  std::array<std::array<bool, 2>, 3> open_{};  // by axis: lower, upper face
};

}  // namespace anvil
