// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace anvil {

/// The folders that may hold what comes with Anvil (scenes, materials, reference), in the order they are searched:
/// $ANVIL_DATA when set, then ../share/anvil seen from the folder of the running program. Those that do not exist are
/// left out.
std::vector<std::filesystem::path> bundled_roots();

/// The bundled file `folder`/`name`, for example ("scenes", "rod_square.toml").
/// Throws InputError when `name` leaves the folder or no such file exists (naming the places searched), and
/// MissingResourceError when there is no bundled folder at all.
std::filesystem::path find_bundled(const std::string& folder, const std::string& name);

/// The names of all files in a bundled folder that end in `extension` (with its dot), sorted, each once.
std::vector<std::string> list_bundled(const std::string& folder, const std::string& extension);

}  // namespace anvil
