// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/render.hpp"

#include <algorithm>

#include "anvil/core/error.hpp"
#include "vtk_io/field_selection.hpp"
#include "vtk_io/picture.hpp"

namespace anvil {

void include_frame(SeriesExtent& series, const Frame& frame, const RenderOptions& options) {
  if (const auto extremes = extremes_of(select_field(frame, options.field))) {
    if (!series.values) series.values = extremes;
    series.values->low = std::min(series.values->low, extremes->low);
    series.values->high = std::max(series.values->high, extremes->high);
  }
  for (std::size_t i = 0; i < frame.positions.size(); i += 3) {
    const double* x = &frame.positions[i];
    if (!series.bounds) series.bounds = {x[0], x[0], x[1], x[1], x[2], x[2]};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      (*series.bounds)[2 * axis] = std::min((*series.bounds)[2 * axis], x[axis]);
      (*series.bounds)[2 * axis + 1] = std::max((*series.bounds)[2 * axis + 1], x[axis]);
    }
  }
}

void render_frame(const Frame& frame, const RenderOptions& options, const std::filesystem::path& png) {
  const View view = options.view.value_or(frame.dimension == 3 ? View::rod : View::particles);
  if (view == View::rod && frame.dimension != 3)
    throw InputError("the view 'rod' is for three dimensions: choose particles or section");
  if (options.glyph_radius < 0.0 || options.glyph_radius > 10.0)
    throw InputError("the radius of a particle must be between 0 and 10 spacings");
  switch (view) {
    case View::rod:
      return render_rod(frame, options, png);
    case View::particles:
      return render_particles(frame, options, png);
    case View::section:
      return render_section(frame, options, png);
  }
}

}  // namespace anvil
