// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "anvil/scene/check.hpp"

namespace anvil {

/// Motions and stresses at the start that a body cannot have, or that lack components.
void check_motions_and_stresses(const Scene& scene, std::vector<Contradiction>& found);

}  // namespace anvil
