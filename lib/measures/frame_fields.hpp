// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "anvil/measures/expression.hpp"
#include "anvil/output/frame.hpp"

namespace anvil {

/// One number per particle: a name, or an expression of names (see evaluate). Names are
/// - arrays of one component ("pressure") and components ("velocity.x", "stress.xy", "position.z");
/// - lengths of vectors ("velocity");
/// - "T.von_mises", "T.mean", "T.max_shear", "T.principal_1" (the largest) to "T.principal_3" of a symmetric tensor T,
///   and "von_mises" for that of the stress;
/// - "radius": the distance from the z axis in three dimensions, from the origin in fewer.
/// Throws InputError, with the nearest name and those there are, where a name is unknown.
Evaluated field_of(const Frame& frame, const std::string& expression);

/// Every name that field_of knows for this frame.
std::vector<std::string> field_names(const Frame& frame);

/// Von Mises (1913): sqrt(3/2 s:s) of the deviator s of a symmetric tensor XX YY ZZ XY YZ XZ.
double von_mises(const double* tensor);

}  // namespace anvil
