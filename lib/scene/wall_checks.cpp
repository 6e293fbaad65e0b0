// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "anvil/boundaries/wall_surface.hpp"
#include "anvil/core/error.hpp"
#include "anvil/scene/boundary_checks.hpp"
#include "anvil/scene/placement.hpp"

namespace anvil {
namespace {

using Contradictions = std::vector<Contradiction>;

/// A particle and the dummy of the first row nearest to it.
template <int D>
struct Nearest {
  double distance = std::numeric_limits<double>::max();  // m
  double in_front = 0.0;                                 // m, of the dummy along its normal; negative behind it
};

/// The dummies of the first row by their first coordinate, so that only those within `reach` are looked at.
template <int D>
Nearest<D> nearest_dummy(const std::vector<WallPoint<D>>& by_x, const Vec<D>& position, double reach) {
  Nearest<D> nearest;
  auto dummy = std::lower_bound(by_x.begin(), by_x.end(), position[0] - reach,
                                [](const auto& point, double x) { return point.position[0] < x; });
  for (; dummy != by_x.end() && dummy->position[0] <= position[0] + reach; ++dummy) {
    const Vec<D> apart = position - dummy->position;
    if (apart.norm() >= nearest.distance) continue;
    nearest.distance = apart.norm();
    nearest.in_front = dummy->normal.dot(apart);
  }
  return nearest;
}

/// Whether an inflow still holds the position.
template <int D>
bool waits(const Scene& scene, const Vec<D>& position) {
  return std::any_of(scene.boundaries.begin(), scene.boundaries.end(), [&](const auto& boundary) {
    if (boundary.entry.type != "inflow") return false;
    const auto& normal = boundary.entry.parameters.numbers("normal");
    const auto& point = boundary.entry.parameters.numbers("point");
    double along = 0.0;
    for (std::size_t a = 0; a < D; ++a)
      along += normal[a] * (position[static_cast<int>(a)] - (point.size() == 1 ? point[0] : point[a]));
    return along < 0.0;
  });
}

template <int D>
void check_gap(const Scene& scene, const BoundaryDescription& wall, const WallSurface<D>& surface,
               Contradictions& found) {
  const double spacing = scene.discretisation.spacing, h = scene.discretisation.smoothing_ratio * spacing;
  const Parameters& keys = wall.entry.parameters;
  // A path drawn the wrong way round puts the first row onto the first particles: the second ones show it, a spacing
  // away.
  const double rounding = 1e-3 * spacing;
  const double reach = keys.has("range") ? keys.number("range") * h : 0.0;
  std::vector<WallPoint<D>> first_row = surface.rows(spacing, keys.number("first_row"), 1);
  std::sort(first_row.begin(), first_row.end(),
            [](const auto& a, const auto& b) { return a.position[0] < b.position[0]; });
  for (const auto& body : scene.bodies) {
    double gap = std::numeric_limits<double>::max();
    bool behind = false;
    for (const Vec<D>& position : place_body<D>(body, spacing).positions) {
      if (waits<D>(scene, position)) continue;
      const Nearest<D> nearest = nearest_dummy<D>(first_row, position, 2.0 * h);
      gap = std::min(gap, nearest.distance);
      behind = behind || (nearest.in_front < -rounding && nearest.distance < spacing + rounding);
    }
    if (behind)
      found.push_back(
          {fmt::format("boundary.{}", wall.name),
           fmt::format("the body '{}' starts on the wrong side of the wall: bodies lie to the left of a path "
                       "(turn the order of its points round) and inside a box (or particles = "
                       "\"outside\")",
                       body.name)});
    else if (reach > gap * (1.0 + 1e-6))
      found.push_back({fmt::format("boundary.{}.range", wall.name),
                       fmt::format("the force would reach {:.4g} m, further than the first gap of {:.4g} m between the "
                                   "first row and the body '{}': the start would explode; range can be {:.3g} at most",
                                   reach, gap, body.name, std::floor(1000.0 * gap / h) / 1000.0)});
  }
}

template <int D>
void check_wall(const Scene& scene, const BoundaryDescription& wall, Contradictions& found) {
  const Parameters& keys = wall.entry.parameters;
  if (keys.text("velocity") == "moving_along")
    found.push_back({fmt::format("boundary.{}.velocity", wall.name),
                     "dummy particles that move along with the particles beside them do work on these without end, and "
                     "the energy grows without bound; choose antisymmetric, reversed_normal or zero"});
  if (keys.has("range") && keys.number("range") < 0.75 && !keys.flag("in_sums"))
    found.push_back(
        {fmt::format("boundary.{}.range", wall.name),
         fmt::format("a force of range {} by itself leaks between the dummy particles: let them take part in "
                     "the sums (in_sums = true), or choose a range of 0.75 or more",
                     keys.number("range"))});
  try {
    check_gap<D>(scene, wall, WallSurface<D>(keys), found);
  } catch (const InputError& error) {
    found.push_back({fmt::format("boundary.{}", wall.name), error.what()});
  }
}

}  // namespace

void check_dummy_walls(const Scene& scene, Contradictions& found) {
  for (const auto& boundary : scene.boundaries) {
    if (!boundary.entry.parameters.has("first_row")) continue;
    if (scene.domain.dimension == 2) check_wall<2>(scene, boundary, found);
    if (scene.domain.dimension == 3) check_wall<3>(scene, boundary, found);
  }
}

}  // namespace anvil
