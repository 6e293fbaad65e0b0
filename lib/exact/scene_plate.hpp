// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/exact/plate.hpp"
#include "anvil/scene/scene.hpp"

namespace anvil {

/// What strains mean in an exact solution. An updated Lagrangian method solves the finite problem; small strain is what
/// papers quote, and what a slender rod is solved in.
enum class StrainMeasure { finite, small };

/// The plane-wave problem a scene poses: its bodies as layers from left to right, its pressures and walls as faces.
/// A scene in uniaxial stress gives a rod, always in small strain. Throws InputError with the reason when the scene is
/// none of this: several dimensions, gaps between bodies, laws without an exact solution, loads that are not at the
/// ends.
PlateProblem plate_problem(const Scene& scene, StrainMeasure measure);

/// The law of the exact solutions for a material's equation of state. Throws InputError when there is none.
PressureLaw pressure_law_of(const MaterialDescription& material);

/// Whether every layer is elastic however hard it is hit.
bool is_elastic(const Scene& scene);

}  // namespace anvil
