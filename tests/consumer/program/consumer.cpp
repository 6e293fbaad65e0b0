// SPDX-License-Identifier: BSD-3-Clause
// Runs the first steps of a scene file through an installed Anvil: consumer SCENE
#include <cstdio>
#include <exception>

#include "anvil/scene/reader.hpp"
#include "anvil/solver/simulation.hpp"
#include "anvil/version.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 1;
  try {
    const anvil::Scene scene = anvil::read_scene(argv[1]);
    const auto simulation = anvil::make_simulation(scene);
    while (simulation->step() < 10) simulation->advance(scene.time.end);
    std::printf("Anvil %s: %zu particles of '%s' at %.3e s after %lld steps\n", anvil::version.data(),
                simulation->particle_count(), scene.title.c_str(), simulation->time(),
                static_cast<long long>(simulation->step()));
    return simulation->time() > 0.0 && simulation->time() < scene.time.end ? 0 : 3;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
