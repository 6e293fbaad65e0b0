// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "anvil/output/frame.hpp"

namespace anvil {

/// How the file of another program calls what Anvil calls by the first name: {"velocity", "Vel"}.
using ArrayNames = std::map<std::string, std::string>;

/// From texts "velocity=Vel". Throws InputError for one without a name on both sides.
ArrayNames parse_array_names(const std::vector<std::string>& texts);

/// Gives the arrays of a frame the names Anvil knows them by, and those that come without a unit the one they have in
/// Anvil. Throws InputError, with the arrays there are, when one is missing.
void rename_arrays(Frame& frame, const ArrayNames& names);

}  // namespace anvil
