// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkLookupTable.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>

#include <array>
#include <string>
#include <vector>

namespace anvil {

/// DejaVu Sans, almost black, `height` pixels high.
void set_font(vtkTextProperty* property, int height);

/// One line of text at a point of the renderer (0 to 1 in both directions), `alignment` of VTK_TEXT_LEFT and so on.
void add_text(vtkRenderer* renderer, const std::string& text, const std::array<double, 2>& at, int height,
              int alignment);

/// An upright colour bar over the part of the renderer from `left`, `bottom` to `right`, `top` (0 to 1) with round
/// numbers to its right and `label` above it.
void add_color_bar(vtkRenderer* renderer, vtkLookupTable* colors, const std::string& label,
                   const std::array<double, 4>& part, int height);

/// A title from a point of the renderer to the right, in smaller letters when it would take more than `width` (0 to 1).
void add_title(vtkRenderer* renderer, const std::string& text, const std::array<double, 2>& at, double width,
               int height);

/// A square in each colour of the table with its name, from the top of the part down.
void add_legend(vtkRenderer* renderer, vtkLookupTable* colors, const std::vector<std::string>& names,
                const std::array<double, 4>& part, int height);

/// "12.5 µs": a time in the unit that reads best.
std::string time_text(double seconds);

}  // namespace anvil
