// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/boundary_checks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "anvil/core/error.hpp"
#include "anvil/scene/shape.hpp"

namespace anvil {
namespace {

using Contradictions = std::vector<Contradiction>;
using Boundaries = std::vector<const BoundaryDescription*>;

Boundaries boundaries_of(const Scene& scene, std::string_view type) {
  Boundaries all;
  for (const auto& boundary : scene.boundaries)
    if (boundary.entry.type == type) all.push_back(&boundary);
  return all;
}

/// Unit normal; zero for a normal that is none, which is refused elsewhere.
Eigen::VectorXd normal_of(const BoundaryDescription& plane) {
  const auto& numbers = plane.entry.parameters.numbers("normal");
  const Eigen::VectorXd normal = Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<long>(numbers.size()));
  return normal.norm() > 0.0 ? Eigen::VectorXd(normal.normalized()) : normal;
}

/// Reflections at two planes give finitely many images only when the bodies' angle between them divides 180 degrees.
void check_angles(const Boundaries& planes, Contradictions& found) {
  constexpr double tolerance = 1e-6;  // of 180 degrees over the angle
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Eigen::VectorXd first = normal_of(*planes[i]), second = normal_of(*planes[j]);
      if (first.size() != second.size() || first.norm() == 0.0 || second.norm() == 0.0) continue;
      const double cosine = std::clamp(first.dot(second), -1.0, 1.0);
      if (cosine < tolerance - 1.0) continue;  // they face each other
      const double angle = std::numbers::pi - std::acos(cosine);
      const double parts = std::numbers::pi / angle;
      if (parts > 1.5 && std::abs(parts - std::round(parts)) < tolerance * parts) continue;
      found.push_back(
          {fmt::format("boundary.{}.normal", planes[i]->name),
           fmt::format("the bodies' angle to the symmetry plane '{}' is {:.6g} degrees; images need one that divides "
                       "180 degrees, such as 90, 60 or 45",
                       planes[j]->name, angle * 180.0 / std::numbers::pi)});
    }
  }
}

int axis_of(const BoundaryDescription& period) { return period.entry.parameters.text("axis")[0] - 'x'; }

template <int D>
void check_bodies_in_period(const Scene& scene, const BoundaryDescription& period, Contradictions& found) {
  const double tolerance = 1e-6 * scene.discretisation.spacing;
  const double least = period.entry.parameters.number("min"), greatest = period.entry.parameters.number("max");
  for (const auto& body : scene.bodies) {
    try {
      const auto shape = make_shape<D>(body.shape);
      const double middle = shape->centre()[axis_of(period)], half = 0.5 * shape->size()[axis_of(period)];
      if (middle - half < least - tolerance || middle + half > greatest + tolerance)
        found.push_back({fmt::format("body.{}.shape", body.name),
                         fmt::format("the body does not lie between min and max of the period '{}'", period.name)});
    } catch (const InputError&) {
      continue;  // the shape is refused by itself
    }
  }
}

void check_period(const Scene& scene, const BoundaryDescription& period, const Boundaries& planes,
                  Contradictions& found) {
  const int axis = axis_of(period);
  const std::string key = fmt::format("boundary.{}", period.name);
  if (axis >= scene.domain.dimension) {
    found.push_back({key + ".axis", fmt::format("a scene in {} dimension{} has no such axis", scene.domain.dimension,
                                                scene.domain.dimension == 1 ? "" : "s")});
    return;
  }
  if (!(period.entry.parameters.number("max") > period.entry.parameters.number("min"))) {
    found.push_back({key + ".max", "it must be larger than min"});
    return;
  }
  for (const auto* plane : planes) {
    const Eigen::VectorXd normal = normal_of(*plane);
    if (axis < normal.size() && std::abs(normal[axis]) > 1e-9)
      found.push_back({key + ".axis", fmt::format("the symmetry plane '{}' is not parallel to it", plane->name)});
  }
  if (scene.domain.dimension == 1) check_bodies_in_period<1>(scene, period, found);
  if (scene.domain.dimension == 2) check_bodies_in_period<2>(scene, period, found);
  if (scene.domain.dimension == 3) check_bodies_in_period<3>(scene, period, found);
}

}  // namespace

void check_planes_and_periods(const Scene& scene, Contradictions& found) {
  const Boundaries planes = boundaries_of(scene, "symmetry_plane"), periods = boundaries_of(scene, "periodic");
  check_angles(planes, found);
  for (std::size_t i = 0; i < periods.size(); ++i) {
    check_period(scene, *periods[i], planes, found);
    for (std::size_t j = 0; j < i; ++j)
      if (axis_of(*periods[i]) == axis_of(*periods[j]))
        found.push_back({fmt::format("boundary.{}.axis", periods[i]->name),
                         fmt::format("'{}' already repeats the scene along it", periods[j]->name)});
  }
  if (scene.shock.method == "fct" && (!planes.empty() || !periods.empty()))
    found.push_back(
        {"shock.method", "flux-corrected transport knows no images: it does not go with symmetry_plane or periodic"});
}

}  // namespace anvil
