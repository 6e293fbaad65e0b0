// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/scene/placement.hpp"

namespace anvil {

/// Fills a ring with layers of equal thickness, as near to `spacing` as fits, and each layer with particles at equal
/// angles, as near to `spacing` apart as a multiple of four allows: so a quarter holds a quarter of them, half an angle
/// away from both of its edges. A particle has its share of the layer's exact area. Order: by layer from the inside,
/// then by angle. Throws InputError for another shape than a ring, and when there are too many particles.
PlacedBody<2> place_concentric(const BodyDescription& body, double spacing);

}  // namespace anvil
