// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "anvil/scene/key.hpp"

namespace anvil {

/// The kinds of boundaries a scene can hold, with their keys.
std::span<const EntryKind> boundary_kinds();

}  // namespace anvil
