// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "anvil/exact/scene_reference.hpp"
#include "anvil/measures/comparison.hpp"
#include "anvil/output/frame.hpp"

namespace anvil {

/// A frame of plane waves against the exact solution, particle by particle at initial positions; `time` is the number
/// of its time in the reference, `spacing` in m. All relative numbers of stress are over the largest exact stress,
/// those of velocity over the largest exact velocity.
///
///   stress_l1, velocity_l1   mean |difference|
///   stress_l2, velocity_l2   root of the mean square difference
///   peak_stress              the stress furthest from zero
///   stress_overshoot         how far the largest and smallest stresses go beyond the exact ones, the larger of the two
///   rise_width               of the steepest front, from 10 to 90 % of its jump, in spacings
///   plateau_1, plateau_2 ... mean stress of each stretch of 20 particles or more where the exact stress is constant
///   and
///                            not zero, from left to right, its outer quarters left out
///   plateau_error            the largest relative error of these
///
/// Throws InputError when the frame lacks arrays, and when nothing has happened yet by its time.
std::vector<ComparedQuantity> compare_waves(const Frame& frame, const SceneReference& reference, std::size_t time,
                                            double spacing);

}  // namespace anvil
