// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "anvil/output/frame.hpp"

namespace anvil {

/// A plane in space, in SI units. Its normal has any length but zero.
struct Plane {
  std::array<double, 3> point{0.0, 0.0, 0.0};
  std::array<double, 3> normal{0.0, 0.0, 1.0};
};

/// The frame and behind it its mirror image in the plane: what a model that was cut at a symmetry plane stands for.
/// Points (positions, initial_position), vectors and symmetric tensors are turned as such; other arrays are repeated.
/// A particle on the plane is not repeated but stands for both of its halves: its mass is doubled.
Frame with_mirror_image(const Frame& frame, const Plane& plane);

}  // namespace anvil
