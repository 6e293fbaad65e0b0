// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "anvil/output/array_names.hpp"
#include "anvil/output/frame.hpp"
#include "vtk_io/series_file.hpp"

namespace anvil {

/// Reads a particle file: .vtp or .vtu, of Anvil or of another program whose arrays have other `names`, or .vtk in
/// VTK's legacy format. Throws InputError when it does not exist, is truncated or torn, holds no points or lacks an
/// array that `names` asks for.
Frame read_frame(const std::filesystem::path& file, const ArrayNames& names = {});

/// The frames of a result, first to last: `result` is a result folder, a .pvd, or a single particle file.
/// Throws InputError when there are none.
std::vector<SeriesEntry> read_series(const std::filesystem::path& result);

/// Whether the file ends as a VTK XML file does: a write that ran out of space leaves one that does not.
bool is_complete_vtk_file(const std::filesystem::path& file);

}  // namespace anvil
