// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "anvil/core/error.hpp"
#include "vtk_io/color_map.hpp"
#include "vtk_io/field_selection.hpp"
#include "vtk_io/lettering.hpp"
#include "vtk_io/off_screen.hpp"

namespace anvil {
namespace {

constexpr double title_line = 0.955;  // of the height of the picture
constexpr std::array<double, 4> color_bar{0.89, 0.22, 0.91, 0.70};

std::string title_of(const Frame& frame, const RenderOptions& options) {
  if (!options.title.empty()) return options.title;
  for (const auto& [name, text] : frame.provenance)
    if (name == "title") return text;
  return frame.scene;
}

/// A colour and a name for each body.
void add_bodies(Picture& picture, const RenderOptions& options, const SelectedField& field) {
  constexpr double most_bodies = 1000.0;  // more would be no names but numbers
  double last = 0.0;
  for (const double body : field.values) last = std::max(last, body);
  if (last > most_bodies) throw InputError("the field 'body' numbers more bodies than can have a colour each");
  const int count = 1 + static_cast<int>(last);
  picture.colors = make_categories(count);
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) {
    const auto known = static_cast<std::size_t>(i) < options.body_names.size();
    names.push_back(known ? options.body_names[static_cast<std::size_t>(i)] : fmt::format("body {}", i));
  }
  add_legend(background_of(picture.window), picture.colors, names, color_bar, picture.font_height);
}

}  // namespace

SelectedField colored_by(const Frame& frame, const RenderOptions& options) {
  return select_field(frame, options.field,
                      options.range    ? options.range
                      : options.series ? options.series->values
                                       : std::nullopt);
}

Picture make_picture(const FrameParts& parts, const RenderOptions& options) {
  const Frame& frame = parts.bodies;
  const SelectedField field = colored_by(frame, options);
  Picture picture;
  // 36 pixels in a picture of 1600 x 1200, so that it can be read at half its size.
  picture.font_height = std::max(9, std::max(options.size[1], options.size[0] * 3 / 4) * 36 / 1200);
  picture.window = make_window(options.size, options.background);
  vtkRenderer* canvas = background_of(picture.window);
  if (options.field == "body") {
    add_bodies(picture, options, field);
  } else {
    const auto extremes = options.series && options.series->values ? options.series->values : extremes_of(field);
    picture.colors = make_color_map(options.color_map, range_of(field, options.range, extremes));
    add_color_bar(canvas, picture.colors, field.label, color_bar, picture.font_height);
  }
  picture.particles = make_drawn_particles(frame, field.values, options.on_faces);
  picture.shown = box_of(picture.particles);
  if (options.on_faces) picture.shown.Inflate(-picture.particles.spacing / 2);
  if (!parts.wall_positions.empty()) {
    picture.wall_particles = make_points(parts.wall_positions);
    picture.shown.AddBounds(picture.wall_particles->GetBounds());
  }
  for (const auto& box : picture.particles.undeformed) picture.shown.AddBox(box);
  if (options.series && options.series->bounds) picture.shown.AddBox(drawn_box(*options.series->bounds));
  const int title_height = picture.font_height * 6 / 5;
  add_title(canvas, title_of(frame, options), {0.03, title_line}, 0.78, title_height);
  add_text(canvas, "t = " + time_text(frame.time), {0.97, title_line}, title_height, VTK_TEXT_RIGHT);
  return picture;
}

vtkBoundingBox box_of(const DrawnParticles& particles) {
  vtkBoundingBox box(particles.points->GetBounds());
  box.Inflate(particles.spacing / 2);
  return box;
}

}  // namespace anvil
