// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/exact/cylindrical_shell.hpp"
#include "anvil/scene/scene.hpp"

namespace anvil {

/// Whether the scene is one ring that moves along its radius.
bool is_shell(const Scene& scene);

/// Throws InputError with the reason when the scene is none, or its material has no reference: strength other than j2
/// without hardening, or an equation of state that lib/exact does not know.
ShellProblem shell_problem(const Scene& scene);

}  // namespace anvil
