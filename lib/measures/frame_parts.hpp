// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "anvil/output/frame.hpp"

namespace anvil {

/// Takes the particles of walls, whose `body` is `first_wall` or more, out of a frame. Returns their positions, 3
/// numbers each, m; none when the frame has no array `body`.
std::vector<double> take_walls_out(Frame& frame, int first_wall);

/// Gives a frame that has none the array `mass`, from where its particles stood: on the corners of cubic cells that
/// fill the bodies, so that each has the volume of the parts of those cells, half a cell on a face. Mass per area or
/// length in fewer dimensions, as in the solver. Does nothing without `initial_position`.
void add_masses_of_face_lattice(Frame& frame);

}  // namespace anvil
