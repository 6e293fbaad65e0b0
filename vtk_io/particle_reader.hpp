// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "anvil/output/frame.hpp"
#include "vtk_io/series_file.hpp"

namespace anvil {

/// Reads a particle file (.vtp or .vtu) that Anvil wrote. Throws InputError when it does not exist, is truncated or
/// torn, or holds something else.
Frame read_frame(const std::filesystem::path& file);

/// The frames of a result, first to last: `result` is a result folder, a .pvd, or a single particle file.
/// Throws InputError when there are none.
std::vector<SeriesEntry> read_series(const std::filesystem::path& result);

/// Whether the file ends as a VTK XML file does: a write that ran out of space leaves one that does not.
bool is_complete_vtk_file(const std::filesystem::path& file);

/// The number that a frame carries in its file's name (rod_000012.vtp: 12), -1 for other names.
int frame_index_of(const std::filesystem::path& file);

}  // namespace anvil
