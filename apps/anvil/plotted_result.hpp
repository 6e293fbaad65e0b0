// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "anvil/figures/figure_builder.hpp"

namespace anvil {

/// The result in a folder, with frames of any format this build reads. Throws InputError when there is none.
PlottedResult open_result(const std::filesystem::path& folder);

}  // namespace anvil
