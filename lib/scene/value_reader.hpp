// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toml++/toml.h>

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "anvil/scene/key.hpp"
#include "anvil/scene/problems.hpp"

namespace anvil {

/// What the reading of one scene gathers on its way. Keys are called by their full path: body.rod.shape.min.
struct ReadContext {
  std::string file;
  int dimension = 0;  // 0 as long as it is not known
  Problems problems;
  std::map<std::string, Place> places;

  /// Where the node stands, or the file when the node was made and not read.
  [[nodiscard]] Place place_of(const toml::node& node) const;
  [[nodiscard]] Place place_of(const toml::key& key, const toml::node& value) const;
  [[nodiscard]] Place place_of(const toml::source_region& source) const;
};

/// The value of a key, or nothing and a problem when the node does not hold what the key expects.
std::optional<Value> read_value(const Key& key, const toml::node& node, const std::string& path, ReadContext& context);

/// The default of a key that has one, with vectors at their full length.
Value default_value(const Key& key, int dimension);

/// Adds the problem of a required key that is absent from the section or entry `path`.
void report_missing(const Key& key, const toml::table& table, const std::string& path, ReadContext& context);

/// Adds a problem for each key of the table that is not known.
void report_unknown(const toml::table& table, std::span<const std::string_view> known, const std::string& path,
                    ReadContext& context);

/// A shape, law or boundary from the table that holds its `type` and its keys. Keys in `shared` belong to somebody
/// else.
std::optional<TypedEntry> read_entry(const Key& key, const toml::table& table, const std::string& path,
                                     std::span<const std::string_view> shared, ReadContext& context);

/// The entry of that type with all its defaults.
TypedEntry default_entry(const Key& key, int dimension);

}  // namespace anvil
