// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "anvil/figures/drawing.hpp"

namespace anvil {

/// Writes a drawing as PNG or SVG, by the name of the file. Throws InputError for another ending.
void write_figure(const Drawing& drawing, const std::filesystem::path& file);

}  // namespace anvil
