// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toml++/toml.h>

#include <string>

namespace anvil {

/// Throws InputError with file, line, column and the reason in plain words.
toml::table parse_toml(const std::string& text, const std::string& file);

}  // namespace anvil
