// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace anvil {

/// The whole of a text file. Throws InputError when it is missing, a folder, unreadable, larger than any scene, or
/// binary.
std::string read_text_file(const std::filesystem::path& file);

}  // namespace anvil
