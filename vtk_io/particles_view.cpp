// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/off_screen.hpp"
#include "vtk_io/picture.hpp"
#include "vtk_io/plane_picture.hpp"
#include "vtk_io/view_parts.hpp"

namespace anvil {
namespace {

double radius_of(const RenderOptions& options, const DrawnParticles& particles, double standard) {
  return (options.glyph_radius > 0.0 ? options.glyph_radius : standard) * particles.spacing;
}

void draw_flat(vtkRenderer* view, const Picture& picture, const Frame& frame, const RenderOptions& options) {
  add_discs(view, picture.particles.points, radius_of(options, picture.particles, 0.5), picture.colors);
  add_wall_particles(view, picture.wall_particles, 0.5 * picture.particles.spacing);
  if (options.outline) add_edges(view, make_undeformed_edges(frame, {}), 2.0F, 0.45);
  for (const Plane& wall : options.walls) add_wall_line(view, wall, picture.shown);
  add_axes(view, picture.shown, picture.font_height * 4 / 5);
  aim_camera(view, vtkBoundingBox(view->ComputeVisiblePropBounds()), {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0});
}

void draw_solid(vtkRenderer* view, const Picture& picture, const RenderOptions& options) {
  constexpr double overlap = 0.55;  // of the spacing: closes the gaps
  add_spheres(view, picture.particles.points, radius_of(options, picture.particles, overlap), picture.colors);
  add_wall_particles(view, picture.wall_particles, 0.12 * picture.particles.spacing);
  add_surroundings(view, picture.particles, options, picture.shown, picture.font_height * 4 / 5);
}

}  // namespace

void render_particles(const FrameParts& parts, const RenderOptions& options, const std::filesystem::path& png) {
  const Frame& frame = parts.bodies;
  const Picture picture = make_picture(parts, options);
  const auto view = add_view(picture.window, view_part);
  if (frame.dimension == 3)
    draw_solid(view, picture, options);
  else
    draw_flat(view, picture, frame, options);
  write_png(picture.window, png);
}

}  // namespace anvil
