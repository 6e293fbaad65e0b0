// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "anvil/scene/check.hpp"

namespace anvil {

/// Stabilisers and forces of pairs that do not go with the method, its steps or its boundaries.
void check_stabilisers(const Scene& scene, std::vector<Contradiction>& found);

}  // namespace anvil
