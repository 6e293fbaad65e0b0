// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "anvil/scene/scene.hpp"

namespace anvil {

enum class ValueKind {
  number,
  integer,
  flag,
  text,
  name,     // a text that can be part of a file name and of a --set KEY
  vector,   // as many numbers as the scene has dimensions
  numbers,  // any number of them
  points,   // a list of lists of numbers, all of one length
  choice,
  choices,        // any number of texts out of a list
  named_numbers,  // a table of numbers by name
  entry           // a table with a `type`: a shape, a law, a boundary
};

/// What values of a number make sense.
enum class Range { any, positive, not_negative, fraction /* 0..1 */, half_fraction /* 0..0.5 */ };

struct EntryKind;

/// One key of a scene file, as a user meets it. The reader, `anvil list`, the reference page and the tests are made
/// from tables of these. A key without a default must be given, unless it is `optional`.
struct Key {
  std::string_view name;
  ValueKind kind = ValueKind::number;
  std::string_view unit = "";  // "" for pure numbers and texts
  // The default. One component of a vector stands for all of them; the text of an entry is its `type`.
  std::optional<Value> standard = std::nullopt;
  Range range = Range::any;
  std::string_view help = "";
  std::vector<std::string_view> choices = {};  // also allowed for integers
  bool optional = false;
  std::string_view derived = "";  // how an optional key follows from the others when it is absent, in words
  std::span<const EntryKind> (*entries)() = nullptr;  // for ValueKind::entry
};

/// One kind of shape, law or boundary: its name in `type`, one line for `anvil list`, and its keys.
struct EntryKind {
  std::string_view type;
  std::string_view summary;
  std::vector<Key> keys;
  std::vector<int> dimensions = {1, 2, 3};  // of the scenes it can be part of
};

/// What a value of the key has to be, for messages and for the reference page: "a positive number in m".
/// `dimension` 0 stands for a scene whose dimension is not known.
std::string expected_value(const Key& key, int dimension);

}  // namespace anvil
