// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "anvil/output/frame.hpp"
#include "vtk_io/render.hpp"

namespace anvil {

/// A three-dimensional frame, whole and with a quarter cut away, side by side into a PNG file. Errors as render_result.
void render_rod(const Frame& frame, const RenderOptions& options, const std::filesystem::path& png);

/// A frame in one or two dimensions, seen along z, into a PNG file. Errors as render_result.
void render_flat(const Frame& frame, const RenderOptions& options, const std::filesystem::path& png);

}  // namespace anvil
