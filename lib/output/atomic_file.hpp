// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace anvil {

/// Replaces `target` by what `write` puts into the file it is given: a temporary one in the same folder, which is
/// flushed to the disk and renamed. Whatever happens, `target` holds its old content or the whole new one. The
/// temporary file is removed when `write` throws. Throws MissingResourceError with path and reason when the machine
/// refuses (no space, no permission, no such folder).
void write_atomically(const std::filesystem::path& target,
                      const std::function<void(const std::filesystem::path& temporary)>& write);

/// The same for a text held in memory.
void write_text_atomically(const std::filesystem::path& target, std::string_view text);

/// The whole content of a file; throws InputError with path and reason when it cannot be read.
std::string read_text(const std::filesystem::path& path);

/// Makes a folder and those above it; throws MissingResourceError with path and reason.
void ensure_folder(const std::filesystem::path& folder);

/// Removes a file that may be missing; throws MissingResourceError with path and reason.
void remove_file(const std::filesystem::path& file);

/// Throws MissingResourceError: "cannot <action> '<path>': <reason of errno>".
[[noreturn]] void throw_system_error(const std::string& action, const std::filesystem::path& path, int error_number);

}  // namespace anvil
