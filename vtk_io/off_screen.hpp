// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <array>
#include <filesystem>

namespace anvil {

/// An off-screen window, all of it covered by a renderer in the colour of the background: what nothing covers would be
/// black. Titles and colour bars go into this renderer, which is the first of the window; views lie above it.
/// Throws MissingResourceError without a display, InputError for a size that makes no picture.
vtkSmartPointer<vtkRenderWindow> make_window(const std::array<int, 2>& size, const std::array<double, 3>& background);

vtkRenderer* background_of(vtkRenderWindow* window);

/// A renderer for bodies on the part of the window from `left`, `bottom` to `right`, `top` (0 to 1): parallel
/// projection and studio lights.
vtkSmartPointer<vtkRenderer> add_view(vtkRenderWindow* window, const std::array<double, 4>& part);

/// Draws the window into `png`, which gets its name when it is complete. Throws MissingResourceError.
void write_png(vtkRenderWindow* window, const std::filesystem::path& png);

}  // namespace anvil
