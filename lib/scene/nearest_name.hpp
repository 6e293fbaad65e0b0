// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace anvil {

/// The known name that `name` most likely stands for, "" when none is near: at most a third of its letters, rounded
/// up, differ.
std::string_view nearest_name(std::string_view name, std::span<const std::string_view> known);

/// "; did you mean 'X'?" with the nearest of the known names, "; known are: A, B" when none is near, "" when none is
/// known. Written to follow a sentence that says what is wrong with `name`.
std::string suggestion(std::string_view name, std::span<const std::string_view> known);

/// Views of a list of strings, which have to outlive them.
std::vector<std::string_view> views_of(std::span<const std::string> names);

}  // namespace anvil
