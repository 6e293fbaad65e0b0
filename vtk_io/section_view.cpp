// SPDX-License-Identifier: BSD-3-Clause
#include <vtkDoubleArray.h>
#include <vtkPointData.h>

#include <algorithm>

#include "anvil/core/error.hpp"
#include "anvil/measures/particle_interpolation.hpp"
#include "vtk_io/off_screen.hpp"
#include "vtk_io/picture.hpp"
#include "vtk_io/plane_picture.hpp"
#include "vtk_io/view_parts.hpp"

namespace anvil {
namespace {

/// Absent in the options: the plane of a flat scene, or one across y through the middle.
Plane plane_of(const Frame& frame, const RenderOptions& options, const std::array<double, 6>& box) {
  if (frame.dimension < 3) return {};
  if (options.section) return *options.section;
  return {{0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5])}, {0.0, 1.0, 0.0}};
}

/// Between the particles, but not so fine that it takes long or so coarse that edges show corners.
double step_of(const std::array<double, 6>& box, double spacing) {
  const double longest = std::max({box[1] - box[0], box[3] - box[2], box[5] - box[4]});
  return std::clamp(longest / 400.0, 0.125 * spacing, 0.5 * spacing);
}

/// A wall as a line in the plane of the picture, whose axes are u and v; nothing for a wall along that plane.
std::optional<Plane> trace_of(const Plane& wall, const SampleGrid& plane) {
  const auto dot = [](const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const double u = dot(wall.normal, plane.u);
  const double v = dot(wall.normal, plane.v);
  const double length = u * u + v * v;
  if (length < 1e-12) return std::nullopt;
  // Nearest point of the line to the foot of the origin in the plane.
  const Point in_plane{dot(plane.origin, plane.u), dot(plane.origin, plane.v), 0.0};
  const double off_plane = dot(wall.normal, plane.origin) - u * in_plane[0] - v * in_plane[1];
  const double distance = (dot(wall.normal, wall.point) - off_plane) / length;
  return Plane{{distance * u, distance * v, 0.0}, {u, v, 0.0}};
}

}  // namespace

void render_section(const FrameParts& parts, const RenderOptions& options, const std::filesystem::path& png) {
  const Frame& frame = parts.bodies;
  if (frame.dimension < 2) throw InputError("a section needs two dimensions or more: use anvil plot");
  const Picture picture = make_picture(parts, options);
  constexpr double metres = 1e-3;
  const double spacing = metres * picture.particles.spacing;
  const auto box = box_around(frame.positions, frame.dimension, 2.0 * spacing);
  const Plane plane = plane_of(frame, options, box);
  const SampleGrid sample = make_sample_plane(plane, box, step_of(box, spacing));
  const ParticleInterpolation interpolation(frame, {});
  const auto sampled = interpolation.at(points_of(sample), std::array{colored_by(frame, options).values});

  const auto view = add_view(picture.window, view_part);
  add_flat_surface(view, make_filled_part(sample, sampled.filling, sampled.values.front()), picture.colors);
  add_edges(view, make_edges(sample, sampled.filling), 2.0F, 0.15);
  if (options.outline) add_edges(view, make_undeformed_edges(frame, plane), 2.0F, 0.55);
  if (frame.dimension == 2) add_wall_particles(view, picture.wall_particles, 0.5 * picture.particles.spacing);
  const vtkBoundingBox bodies(view->ComputeVisiblePropBounds());
  for (const Plane& wall : options.walls)
    if (const auto trace = trace_of(wall, sample)) add_wall_line(view, *trace, bodies);
  add_axes(view, vtkBoundingBox(view->ComputeVisiblePropBounds()), picture.font_height * 4 / 5);
  aim_camera(view, vtkBoundingBox(view->ComputeVisiblePropBounds()), {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0});
  write_png(picture.window, png);
}

}  // namespace anvil
