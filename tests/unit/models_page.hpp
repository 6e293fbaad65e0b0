// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <string_view>
#include <variant>

namespace anvil::testing_support {

/// Whether MODELS.md has a table row that starts with `name` below the heading "## section".
inline bool models_page_has_row(std::string_view section, std::string_view name) {
  std::ifstream page(ANVIL_SOURCE_DIR "/MODELS.md");
  const std::string heading = "## " + std::string(section);
  const std::string row = "| `" + std::string(name) + "` |";
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("## ")) inside = line == heading;
    if (inside && line.starts_with(row)) return true;
  }
  return false;
}

/// The alternatives of a variant as the types of a typed test.
template <class Variant>
struct AlternativesOf;
template <class... Alternatives>
struct AlternativesOf<std::variant<Alternatives...>> {
  using Types = ::testing::Types<Alternatives...>;
};

}  // namespace anvil::testing_support
