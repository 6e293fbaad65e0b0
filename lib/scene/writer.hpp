// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "anvil/scene/scene.hpp"

namespace anvil {

/// The scene as TOML with every key written out; read_scene_text gives the same scene back, bit by bit.
std::string write_scene(const Scene& scene);

/// The same as JSON, for provenance.
std::string write_scene_json(const Scene& scene);

/// One value as TOML.
std::string write_value(const Value& value);

}  // namespace anvil
