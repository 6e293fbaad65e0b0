// SPDX-License-Identifier: BSD-3-Clause
#include "figure_file.hpp"

#include <fmt/core.h>

#include "anvil/core/error.hpp"
#include "anvil/output/atomic_file.hpp"

#if ANVIL_WITH_VTK
#include "vtk_io/figure_painter.hpp"
#endif

namespace anvil {

void write_figure(const Drawing& drawing, const std::filesystem::path& file) {
  if (file.extension() == ".svg") {
    write_text_atomically(file, write_svg(drawing));
  } else if (file.extension() == ".png") {
#if ANVIL_WITH_VTK
    paint_png(drawing, file);
#else
    throw InputError(fmt::format("'{}' needs a build with VTK; this one writes .svg", file.string()));
#endif
  } else {
    throw InputError(fmt::format("'{}' is neither .png nor .svg", file.string()));
  }
}

}  // namespace anvil
