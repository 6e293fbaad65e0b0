// SPDX-License-Identifier: BSD-3-Clause
// What a symmetry plane asks of a lattice whose pairs never change: that it is its own mirror image.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "anvil/core/error.hpp"
#include "anvil/kernels/kernel.hpp"
#include "anvil/scene/boundary_checks.hpp"
#include "anvil/scene/cut.hpp"
#include "anvil/scene/placement.hpp"

namespace anvil {
namespace {

using Contradictions = std::vector<Contradiction>;
constexpr double rounding = 1e-6;  // of a spacing, or of a normal's components

/// A plane as the lattice of a body sees it.
template <int D>
struct PlaneInLattice {
  Vec<D> normal;   // unit, in the lattice's own directions
  double rows;     // spacings from the plane to the nearest corner of the shape's cells, along the normal
  double nearest;  // spacings from the plane to the shape
};

template <int D>
PlaneInLattice<D> seen_by(const BodyDescription& body, const Parameters& plane, double spacing) {
  const auto shape = make_shape<D>(body.shape);
  const Mat<D> to_lattice = rotation_of<D>(body).transpose();
  const Vec<D> normal = to_lattice * Vec<D>(plane.numbers("normal").data()).normalized();
  const Vec<D> middle = shape->centre() - to_lattice * Vec<D>(plane.numbers("point").data());
  Vec<D> corner = middle;
  const auto cells = count_cells<D>(*shape, spacing);
  for (int axis = 0; axis < D; ++axis)
    corner[axis] -= 0.5 * spacing * static_cast<double>(cells[static_cast<std::size_t>(axis)]);
  return {normal, normal.dot(corner) / spacing, (normal.dot(middle) - shape->reach(-normal)) / spacing};
}

bool is_whole(double number) { return std::abs(number - std::round(number)) < rounding; }

/// How many components a normal has when they are all as large; zero when they differ.
template <int D>
int equal_components(const Vec<D>& normal) {
  const double largest = normal.cwiseAbs().maxCoeff();
  int count = 0;
  for (const double component : normal) {
    const double size = std::abs(component);
    if (size > largest - rounding)
      ++count;
    else if (size > rounding)
      return 0;
  }
  return count;
}

/// Whether mirrored corners of cells are corners, mirrored middles middles: across an axis at any half spacing, along
/// the diagonal of two axes through corners.
template <int D>
bool mirrors_lattice(const PlaneInLattice<D>& plane) {
  const int components = equal_components<D>(plane.normal);
  if (components == 1) return is_whole(2.0 * plane.rows);
  return components == 2 && is_whole(std::numbers::sqrt2 * plane.rows);
}

template <int D>
void check_body_at_plane(const Scene& scene, const BodyDescription& body, const BoundaryDescription& boundary,
                         double reach, Contradictions& found) {
  const auto plane = seen_by<D>(body, boundary.entry.parameters, scene.discretisation.spacing);
  if (2.0 * plane.nearest > reach) return;  // no pair reaches across
  const auto refuse = [&](const std::string& sentence) {
    found.push_back({fmt::format("boundary.{}.normal", boundary.name),
                     fmt::format("the lattice of body '{}' {}", body.name, sentence)});
  };
  if (!mirrors_lattice<D>(plane))
    return refuse(
        "is not its own mirror image in this plane; total_lagrangian needs a plane across one of its axes or along a "
        "diagonal of two, through corners of its cells or half way");
  // Corners of the cells, where particles of the face lattice stand, are a whole number of rows away.
  const bool between =
      equal_components<D>(plane.normal) == 1 && (body.lattice == "face_lattice") != is_whole(plane.rows);
  if (scene.stabiliser.method == "edge_stress_points" && between)
    refuse("has edges that cross this plane; edge_stress_points need particles on it: take lattice = \"face_lattice\"");
}

/// Cells that a cut halves have no whole facets, and by these bodies meet.
template <int D>
void check_cuts(const Scene& scene, Contradictions& found) {
  if (scene.bodies.size() < 2) return;
  for (const auto& body : scene.bodies) {
    try {
      if (cut_of<D>(body.shape))
        found.push_back({fmt::format("body.{}.shape", body.name),
                         "it is cut along a diagonal and lacks facets there, with which total_lagrangian bodies meet; "
                         "take a whole or a quarter"});
    } catch (const InputError&) {
      continue;
    }
  }
}

template <int D>
void check_each(const Scene& scene, Contradictions& found) {
  check_cuts<D>(scene, found);
  const double reach =
      scene.discretisation.smoothing_ratio *
      std::visit([](const auto& kernel) { return kernel.support; }, make_kernel(scene.discretisation.kernel));
  for (const auto& boundary : scene.boundaries) {
    if (boundary.entry.type != "symmetry_plane") continue;
    if (Vec<D>(boundary.entry.parameters.numbers("normal").data()).isZero(0.0)) continue;
    for (const auto& body : scene.bodies) {
      if (body.lattice == "concentric") continue;  // of its layers, each sector's own
      try {
        check_body_at_plane<D>(scene, body, boundary, reach, found);
      } catch (const InputError&) {
        continue;  // the shape is refused by itself
      }
    }
  }
}

}  // namespace

void check_mirrored_lattices(const Scene& scene, Contradictions& found) {
  if (scene.discretisation.method != "total_lagrangian") return;
  if (scene.domain.dimension == 1) check_each<1>(scene, found);
  if (scene.domain.dimension == 2) check_each<2>(scene, found);
  if (scene.domain.dimension == 3) check_each<3>(scene, found);
}

}  // namespace anvil
