// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/core.h>

#include "anvil/scene/reader.hpp"
#include "anvil/solver/simulation.hpp"
#include "command_line.hpp"

namespace anvil {

int execute_check(const Arguments& arguments) {
  Usage usage{"anvil check SCENE [--set KEY=VALUE]...",
              "Reads a scene file, or the bundled scene of that name, and builds it without running it.", "SCENE"};
  add_scene_options(usage);
  const auto values = parse(usage, arguments);
  if (!values) return 0;
  const Scene scene = read_scene(locate_scene(required(*values, usage, "SCENE")), repeated(*values, "set"));
  const auto simulation = make_simulation(scene);
  fmt::print("scene is fine: {}, {} particles\n", scene.name, simulation->particle_count());
  return 0;
}

}  // namespace anvil
