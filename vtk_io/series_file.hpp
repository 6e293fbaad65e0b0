// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "anvil/output/frame.hpp"

namespace anvil {

/// Reads a ParaView collection (.pvd); files come back relative to where the .pvd was opened from.
/// Throws InputError when the file does not exist, is no complete XML document or lists an entry that makes no sense.
std::vector<SeriesEntry> read_series_file(const std::filesystem::path& pvd);

/// Writes a ParaView collection; `entries` name their files as the caller does, the collection relative to its own
/// folder, so that it can be moved together with the frames. Throws MissingResourceError with the path and the reason.
void write_series_file(const std::filesystem::path& pvd, const std::vector<SeriesEntry>& entries);

}  // namespace anvil
