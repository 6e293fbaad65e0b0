// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/exact/scene_shell.hpp"

#include <fmt/core.h>

#include "anvil/core/error.hpp"
#include "anvil/exact/scene_plate.hpp"

namespace anvil {

bool is_shell(const Scene& scene) { return scene.bodies.size() == 1 && scene.bodies.front().radial_velocity != 0.0; }

ShellProblem shell_problem(const Scene& scene) {
  if (!is_shell(scene)) throw InputError("there is no exact solution of this scene: it is no single collapsing ring");
  const BodyDescription& body = scene.bodies.front();
  const MaterialDescription& material = scene.materials.front();
  const Parameters& strength = material.strength.parameters;
  if (material.strength.type != "j2" || strength.number("hardening_modulus") != 0.0)
    throw InputError(fmt::format(
        "the solution of a shell is known for j2 without hardening, and the material '{}' has another strength",
        material.name));
  return {.density = material.density,
          .law = pressure_law_of(material),
          .shear_modulus = strength.number("shear_modulus"),
          .yield_stress = strength.number("yield_stress"),
          .inner_radius = body.shape.parameters.number("inner_radius"),
          .outer_radius = body.shape.parameters.number("outer_radius"),
          .speed = body.radial_velocity};
}

}  // namespace anvil
