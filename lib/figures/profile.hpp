// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "anvil/measures/expression.hpp"
#include "anvil/output/frame.hpp"

namespace anvil {

/// A field of a frame along something, from left to right.
struct Profile {
  Evaluated x, y;
  bool scattered = false;  // particles of more than one dimension: points that no line should join
};

/// One point per particle, of those for which `where` is not 0 (all when it is empty). All three are names or
/// expressions as field_of takes them. Throws InputError also when no particle is left.
Profile profile_of_particles(const Frame& frame, const std::string& along, const std::string& field,
                             const std::string& where);

/// The field between the particles on a straight line, over the distance from its begin; NaN outside the bodies.
/// `ends`: x, y, z of both, m. Throws InputError also when the line meets no body.
Profile profile_on_line(const Frame& frame, const std::string& field, const std::vector<double>& ends);

}  // namespace anvil
