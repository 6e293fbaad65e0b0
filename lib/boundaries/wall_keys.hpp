// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "anvil/scene/key.hpp"

namespace anvil {

/// The kinds of walls made of dummy particles: long_range_wall, dummy_wall, repulsive_wall. They differ in the force of
/// the first row and share all other keys, so that one can be put in the place of another.
std::vector<EntryKind> dummy_wall_kinds();

}  // namespace anvil
