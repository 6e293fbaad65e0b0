// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "anvil/core/error.hpp"
#include "anvil/scene/reader.hpp"

namespace anvil {

/// A small scene in three dimensions that uses defaults wherever it can.
inline const std::string small_scene = R"(
[domain]
dimension = 3
[discretisation]
spacing = 1e-3
[time]
end = 1e-6
[[body]]
name = "bar"
shape = { type = "box", min = [0, 0, 0], max = [4e-3, 4e-3, 8e-3] }
material = "soft"
[material.soft]
density = 1000
eos = { type = "linear", bulk_modulus = 2e9 }
)";

/// What reading says about a faulty scene; fails the test and returns nothing when it reads without an error.
inline std::string message_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    read_scene_text(text, "scene", overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no error was thrown";
  return {};
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace anvil
