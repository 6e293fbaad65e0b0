// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "anvil/figures/figure_builder.hpp"
#include "anvil/output/array_names.hpp"

namespace anvil {

/// The result at `path` as list_frames takes it. Frames are read when they are asked for, and the last one is kept.
/// Throws InputError when there is none.
PlottedResult open_result(const std::filesystem::path& path, const ArrayNames& names = {});

}  // namespace anvil
