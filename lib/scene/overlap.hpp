// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/scene/scene.hpp"

namespace anvil {

/// Whether two bodies share space: exact for boxes and intervals, otherwise whether any of their particles are closer
/// than half a spacing.
template <int D>
bool bodies_overlap(const BodyDescription& first, const BodyDescription& second, double spacing);

}  // namespace anvil
