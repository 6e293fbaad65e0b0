// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkLookupTable.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>

#include <array>
#include <string>

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

/// "12.5 µs": a time in the unit that reads best.
std::string time_text(double seconds);

}  // namespace anvil
