// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/render.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "anvil/core/error.hpp"
#include "anvil/measures/frame_parts.hpp"
#include "vtk_io/field_selection.hpp"
#include "vtk_io/picture.hpp"

namespace anvil {
namespace {

void include_positions(SeriesExtent& series, const std::vector<double>& positions) {
  for (std::size_t i = 0; i < positions.size(); i += 3) {
    const double* x = &positions[i];
    if (!series.bounds) series.bounds = {x[0], x[0], x[1], x[1], x[2], x[2]};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      (*series.bounds)[2 * axis] = std::min((*series.bounds)[2 * axis], x[axis]);
      (*series.bounds)[2 * axis + 1] = std::max((*series.bounds)[2 * axis + 1], x[axis]);
    }
  }
}

}  // namespace

void include_frame(SeriesExtent& series, Frame frame, const RenderOptions& options) {
  include_positions(series, frame.positions);
  if (options.first_wall) take_walls_out(frame, *options.first_wall);
  if (const auto extremes = extremes_of(select_field(frame, options.field))) {
    if (!series.values) series.values = extremes;
    series.values->low = std::min(series.values->low, extremes->low);
    series.values->high = std::max(series.values->high, extremes->high);
  }
}

void render_frame(Frame frame, const RenderOptions& options, const std::filesystem::path& png) {
  const View view = options.view.value_or(frame.dimension == 3 ? View::rod : View::particles);
  if (view == View::rod && frame.dimension != 3)
    throw InputError("the view 'rod' is for three dimensions: choose particles or section");
  if (options.glyph_radius < 0.0 || options.glyph_radius > 10.0)
    throw InputError("the radius of a particle must be between 0 and 10 spacings");
  FrameParts parts;
  if (options.first_wall) parts.wall_positions = take_walls_out(frame, *options.first_wall);
  const bool volumes_are_drawn = view == View::section || options.surface || frame.dimension == 2;
  if (options.on_faces && volumes_are_drawn) add_masses_of_face_lattice(frame);
  parts.bodies = std::move(frame);
  switch (view) {
    case View::rod:
      return render_rod(parts, options, png);
    case View::particles:
      return render_particles(parts, options, png);
    case View::section:
      return render_section(parts, options, png);
  }
}

}  // namespace anvil
