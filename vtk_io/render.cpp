// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/render.hpp"

#include <fmt/format.h>

#include "anvil/core/error.hpp"
#include "vtk_io/particle_reader.hpp"
#include "vtk_io/rod_view.hpp"

namespace anvil {
namespace {

std::filesystem::path find_frame(const std::filesystem::path& result, const std::optional<int>& wanted) {
  const auto series = read_series(result);
  if (!wanted) return series.back().file;
  for (const SeriesEntry& entry : series)
    if (frame_index_of(entry.file) == *wanted) return entry.file;
  throw InputError(fmt::format("'{}' has no frame {}: it has {} to {}", result.string(), *wanted,
                               frame_index_of(series.front().file), frame_index_of(series.back().file)));
}

}  // namespace

void render_result(const std::filesystem::path& result, const RenderOptions& options,
                   const std::filesystem::path& png) {
  const Frame frame = read_frame(find_frame(result, options.frame));
  if (frame.dimension == 3)
    render_rod(frame, options, png);
  else
    render_flat(frame, options, png);
}

}  // namespace anvil
