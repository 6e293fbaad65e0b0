// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/rod_view.hpp"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>

#include "anvil/core/error.hpp"
#include "vtk_io/body_surface.hpp"
#include "vtk_io/color_map.hpp"
#include "vtk_io/drawn_particles.hpp"
#include "vtk_io/field_selection.hpp"
#include "vtk_io/lettering.hpp"
#include "vtk_io/off_screen.hpp"
#include "vtk_io/view_parts.hpp"

namespace anvil {
namespace {

constexpr double title_line = 0.955;  // of the height of the picture
constexpr double view_top = 0.92;
constexpr double sphere_radius = 0.55;  // of the spacing: a little overlap closes the gaps
constexpr std::array<double, 4> color_bar{0.90, 0.22, 0.92, 0.70};

/// Pixels for a text that is 26 high in a picture of 1200.
int font_height(const RenderOptions& options) { return std::max(9, options.size[1] * 26 / 1200); }

std::string title_of(const Frame& frame, const RenderOptions& options) {
  if (!options.title.empty()) return options.title;
  for (const auto& [name, text] : frame.provenance)
    if (name == "title") return text;
  return frame.scene;
}

struct Picture {
  vtkSmartPointer<vtkRenderWindow> window;
  vtkSmartPointer<vtkLookupTable> colors;
  DrawnParticles particles;
  vtkSmartPointer<vtkDataSet> filling;  // only where surfaces are drawn
};

/// The window with all that does not belong to a single view.
Picture make_picture(const Frame& frame, const RenderOptions& options) {
  const SelectedField field = select_field(frame, options.field);
  Picture picture;
  picture.colors = make_color_map(range_of(field, options.range));
  picture.particles = make_drawn_particles(frame, field.values);
  picture.window = make_window(options.size, options.background);
  vtkRenderer* canvas = background_of(picture.window);
  add_text(canvas, title_of(frame, options), {0.03, title_line}, font_height(options) * 6 / 5, VTK_TEXT_LEFT);
  add_text(canvas, "t = " + time_text(frame.time), {0.97, title_line}, font_height(options) * 6 / 5, VTK_TEXT_RIGHT);
  add_color_bar(canvas, picture.colors, field.label, color_bar, font_height(options));
  return picture;
}

vtkBoundingBox box_of(const DrawnParticles& particles) {
  vtkBoundingBox box(particles.points->GetBounds());
  box.Inflate(particles.spacing / 2);
  return box;
}

vtkBoundingBox all_of(const DrawnParticles& particles) {
  vtkBoundingBox all = box_of(particles);
  for (const auto& box : particles.undeformed) all.AddBox(box);
  return all;
}

Quarter nearest_quarter(const DrawnParticles& particles, const Direction& view_direction) {
  double middle[3];
  (particles.undeformed.empty() ? box_of(particles) : particles.undeformed.front()).GetCenter(middle);
  return {middle[0], middle[1], view_direction[0] < 0.0 ? -1.0 : 1.0, view_direction[1] > 0.0 ? 1.0 : -1.0};
}

void add_body(vtkRenderer* view, const Picture& picture, const std::optional<Quarter>& cut_away) {
  if (picture.filling != nullptr) {
    add_surface(view, make_body_surface(picture.filling, cut_away), picture.colors);
  } else {
    const DrawnParticles drawn = cut_away ? without_quarter(picture.particles, *cut_away) : picture.particles;
    add_spheres(view, drawn.points, sphere_radius * picture.particles.spacing, picture.colors);
  }
}

/// An upright scale to the left of the bodies, in the plane through their middle that faces the viewer.
void add_height_scale(vtkRenderer* view, const vtkBoundingBox& box, const Direction& view_direction, int font) {
  double center[3];
  box.GetCenter(center);
  const double horizontal = std::hypot(view_direction[0], view_direction[1]);
  const Direction left{view_direction[1] / horizontal, -view_direction[0] / horizontal, 0.0};
  const double reach = 0.58 * (std::abs(left[0]) * box.GetLength(0) + std::abs(left[1]) * box.GetLength(1));
  const double bottom = box.GetMinPoint()[2];
  add_ruler(view, {center[0] + reach * left[0], center[1] + reach * left[1], bottom}, {0.0, 0.0, 1.0}, left,
            box.GetLength(2), font);
}

void add_rod_view(const Picture& picture, const RenderOptions& options, const std::array<double, 4>& part,
                  const std::optional<Quarter>& cut_away) {
  const auto view = add_view(picture.window, part);
  add_body(view, picture, cut_away);
  if (options.outline)
    for (const auto& box : picture.particles.undeformed) add_outline(view, box);
  for (const WallPlane& wall : options.walls) add_wall(view, wall, box_of(picture.particles));
  add_height_scale(view, all_of(picture.particles), options.view_direction, font_height(options) * 4 / 5);
  vtkBoundingBox shown(view->ComputeVisiblePropBounds());
  aim_camera(view, shown, options.view_direction, {0.0, 0.0, 1.0});
}

void check_view_direction(const Direction& direction) {
  if (!(std::hypot(direction[0], direction[1]) > 1e-6 * std::abs(direction[2])))
    throw InputError("the view direction must have a part along x or y, because z points up in the picture");
}

}  // namespace

void render_rod(const Frame& frame, const RenderOptions& options, const std::filesystem::path& png) {
  check_view_direction(options.view_direction);
  Picture picture = make_picture(frame, options);
  if (options.surface) picture.filling = make_filling(picture.particles);
  if (options.cut) {
    add_rod_view(picture, options, {0.0, 0.0, 0.42, view_top}, std::nullopt);
    add_rod_view(picture, options, {0.42, 0.0, 0.84, view_top},
                 nearest_quarter(picture.particles, options.view_direction));
  } else {
    add_rod_view(picture, options, {0.0, 0.0, 0.84, view_top}, std::nullopt);
  }
  write_png(picture.window, png);
}

void render_flat(const Frame& frame, const RenderOptions& options, const std::filesystem::path& png) {
  const Picture picture = make_picture(frame, options);
  const auto view = add_view(picture.window, {0.0, 0.0, 0.84, view_top});
  add_discs(view, picture.particles.points, 0.5 * picture.particles.spacing, picture.colors);
  const vtkBoundingBox box = box_of(picture.particles);
  const double below = 0.03 * std::max(box.GetLength(0), box.GetLength(1));
  add_ruler(view, {box.GetMinPoint()[0], box.GetMinPoint()[1] - below, 0.0}, {1.0, 0.0, 0.0}, {0.0, -1.0, 0.0},
            box.GetLength(0), font_height(options) * 4 / 5);
  vtkBoundingBox shown(view->ComputeVisiblePropBounds());
  aim_camera(view, shown, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0});
  write_png(picture.window, png);
}

}  // namespace anvil
