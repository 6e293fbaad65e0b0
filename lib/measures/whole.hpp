// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "anvil/measures/mirror.hpp"

namespace anvil {

/// Planes in which a model between symmetry planes has to be mirrored one after the other to become the whole: where
/// two meet at 45 degrees, or at a smaller angle by a power of two, others than these. Other angles leave a gap.
std::vector<Plane> planes_to_the_whole(const std::vector<Plane>& symmetry_planes);

}  // namespace anvil
