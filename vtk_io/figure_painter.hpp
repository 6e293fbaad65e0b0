// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "anvil/figures/drawing.hpp"

namespace anvil {

/// Paints a drawing off-screen into a PNG file, which gets its name when it is complete. Throws MissingResourceError
/// without a way to draw or to write.
void paint_png(const Drawing& drawing, const std::filesystem::path& png);

}  // namespace anvil
