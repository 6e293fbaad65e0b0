// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "anvil/scene/scene.hpp"

namespace anvil {

/// Two keys, or a key and the space it describes, that do not go together.
struct Contradiction {
  std::string key;  // full path of the key to change, for example body.rod.shape
  std::string sentence;
};

/// Everything in a scene, each of whose keys is valid by itself, that cannot work as a whole: bodies without particles,
/// sides that are no whole number of spacings, overlaps, bodies behind a wall, impossible strain states and times.
std::vector<Contradiction> find_contradictions(const Scene& scene);

/// Throws one InputError with all contradictions, if there are any. read_scene has done this already.
void check_scene(const Scene& scene);

}  // namespace anvil
