// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "anvil/scene/check.hpp"

namespace anvil {

/// Planes of symmetry that meet at angles images cannot fill, periods that are none, and what knows nothing of images.
void check_planes_and_periods(const Scene& scene, std::vector<Contradiction>& found);

/// Walls of dummy particles that are drawn wrongly, would blow the bodies away or leak by construction.
void check_dummy_walls(const Scene& scene, std::vector<Contradiction>& found);

/// Symmetry planes in which the lattice of a total Lagrangian body is not its own mirror image, bodies cut where they
/// would meet others.
void check_mirrored_lattices(const Scene& scene, std::vector<Contradiction>& found);

}  // namespace anvil
