// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "anvil/scene/scene.hpp"

namespace anvil {

/// Reads a scene file, with `overrides` of the form KEY=VALUE put on top of it, fills in every default and checks that
/// the scene makes sense. Throws one InputError that lists everything that is wrong, one line each: `file:line:column:
/// key '...' must be ..., found ...`.
Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// The same for a text; `name` becomes the scene's name and stands for the file in messages.
Scene read_scene_text(const std::string& text, const std::string& name, const std::vector<std::string>& overrides = {});

/// The file a user means: a path, or the name of a bundled scene. Throws InputError with the nearest bundled name.
std::filesystem::path locate_scene(const std::string& argument);

}  // namespace anvil
