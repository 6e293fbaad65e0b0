// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/schema.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "anvil/scene/writer.hpp"

namespace anvil {
namespace {

/// Each key that a scene file can hold, those of shapes, laws and boundaries included, with the path to it.
std::vector<std::pair<std::string, const Key*>> all_keys() {
  std::vector<std::pair<std::string, const Key*>> keys;
  for (const SectionKeys& section : scene_sections()) {
    for (const Key* key : section.keys) {
      const std::string path = std::string(section.name) + "." + std::string(key->name);
      keys.emplace_back(path, key);
      if (key->kind != ValueKind::entry) continue;
      for (const EntryKind& kind : key->entries())
        for (const Key& own : kind.keys)
          keys.emplace_back(path + "." + std::string(kind.type) + "." + std::string(own.name), &own);
    }
  }
  return keys;
}

bool is_numeric(ValueKind kind) {
  return kind == ValueKind::number || kind == ValueKind::vector || kind == ValueKind::numbers ||
         kind == ValueKind::points;
}

TEST(Schema, EveryKeyHasHelp) {
  for (const auto& [path, key] : all_keys()) EXPECT_FALSE(key->help.empty()) << path;
}

TEST(Schema, EveryKeyIsRequiredOrHasADefault) {
  for (const auto& [path, key] : all_keys()) {
    EXPECT_FALSE(key->standard && key->optional) << path << " has a default and needs no other mark";
    EXPECT_TRUE(key->derived.empty() || key->optional) << path << " follows from others, so it is optional";
  }
}

/// Units have one spelling each, and the last word of a key's name says which it must be.
TEST(Schema, NumbersCarryTheUnitOfTheirName) {
  const std::set<std::string_view> units = {"",  "m",    "m/s",      "m/s2",    "s",   "1/s",  "kg/m3",   "Pa",
                                            "K", "J/kg", "J/(kg K)", "W/(m K)", "rad", "Pa s", "degrees", "m2/s2"};
  const std::map<std::string_view, std::string_view> by_name = {
      {"modulus", "Pa"}, {"stress", "Pa"}, {"pressure", "Pa"}, {"density", "kg/m3"}, {"velocity", "m/s"},
      {"spacing", "m"},  {"length", "m"},  {"radius", "m"},    {"min", "m"},         {"max", "m"},
      {"centre", "m"},   {"point", "m"},   {"base", "m"},      {"end", "s"},         {"interval", "s"},
      {"ratio", ""},     {"fraction", ""}, {"normal", ""},     {"cfl", ""},
  };
  for (const auto& [path, key] : all_keys()) {
    if (!is_numeric(key->kind)) {
      EXPECT_EQ(key->unit, "") << path;
      continue;
    }
    EXPECT_EQ(units.count(key->unit), 1u) << path << " in " << key->unit;
    const auto known = by_name.find(key->name.substr(key->name.rfind('_') + 1));
    if (known != by_name.end()) {
      EXPECT_EQ(key->unit, known->second) << path;
    }
  }
}

TEST(Schema, DefaultsAreAmongTheChoices) {
  for (const auto& [path, key] : all_keys()) {
    if (key->kind != ValueKind::choice) continue;
    ASSERT_FALSE(key->choices.empty()) << path;
    if (!key->standard) continue;
    EXPECT_EQ(std::count(key->choices.begin(), key->choices.end(), std::get<std::string>(*key->standard)), 1) << path;
  }
}

TEST(Schema, DefaultEntriesNeedNoFurtherKeys) {
  for (const auto& [path, key] : all_keys()) {
    if (key->kind != ValueKind::entry) continue;
    ASSERT_FALSE(key->entries().empty()) << path;
    if (!key->standard) continue;
    const auto named = [type = std::get<std::string>(*key->standard)](const EntryKind& kind) {
      return kind.type == type;
    };
    const auto kinds = key->entries();
    const auto found = std::find_if(kinds.begin(), kinds.end(), named);
    ASSERT_NE(found, kinds.end()) << path;
    for (const Key& own : found->keys) EXPECT_TRUE(own.standard || own.optional) << path << "." << own.name;
  }
}

TEST(Schema, NamesAreUniqueWithinTheirSection) {
  std::set<std::string> seen;
  for (const auto& [path, key] : all_keys()) EXPECT_TRUE(seen.insert(path).second) << path;
}

/// ANVIL_UPDATE_PAGES=1 in the environment writes the page anew instead.
TEST(Schema, ReferencePageIsUpToDate) {
  const std::string file = ANVIL_SOURCE_DIR "/docs/scene_keys.md";
  std::ostringstream page;
  write_scene_reference(page);
  if (std::getenv("ANVIL_UPDATE_PAGES") != nullptr) std::ofstream(file) << page.str();
  std::ostringstream committed;
  committed << std::ifstream(file).rdbuf();
  EXPECT_EQ(committed.str(), page.str())
      << "run this test once with ANVIL_UPDATE_PAGES=1 and commit docs/scene_keys.md";
}

}  // namespace
}  // namespace anvil
