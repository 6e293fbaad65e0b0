// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/key.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace anvil {
namespace {

std::string expected_number(const Key& key, std::string_view noun) {
  const std::string unit = key.unit.empty() ? "" : fmt::format(" in {}", key.unit);
  switch (key.range) {
    case Range::positive:
      return fmt::format("a positive {}{}", noun, unit);
    case Range::not_negative:
      return fmt::format("a {}{}, zero or more", noun, unit);
    case Range::fraction:
      return fmt::format("a {}{} between 0 and 1", noun, unit);
    case Range::half_fraction:
      return fmt::format("a {}{} between 0 and 0.5", noun, unit);
    case Range::any:
      break;
  }
  return fmt::format("{} {}{}", noun == "integer" ? "an" : "a", noun, unit);
}

std::string expected_vector(const Key& key, int dimension) {
  const std::string unit = key.unit.empty() ? "" : fmt::format(" in {}", key.unit);
  if (dimension == 1) return fmt::format("a list of 1 number{}, as [x]", unit);
  if (dimension == 2) return fmt::format("a list of 2 numbers{}, as [x, y]", unit);
  if (dimension == 3) return fmt::format("a list of 3 numbers{}, as [x, y, z]", unit);
  return fmt::format("a list of numbers{}, one for each dimension", unit);
}

std::string one_of(const std::vector<std::string_view>& choices) {
  return fmt::format("{}{}", choices.size() == 1 ? "" : "one of ", fmt::join(choices, ", "));
}

std::string expected_entry(const Key& key) {
  std::vector<std::string_view> types;
  for (const EntryKind& kind : key.entries()) types.push_back(kind.type);
  if (key.name == "type") return one_of(types);  // its keys stand beside it
  return fmt::format("a table {{ type = \"...\", ... }} with a type out of {}", fmt::join(types, ", "));
}

}  // namespace

std::string expected_value(const Key& key, int dimension) {
  switch (key.kind) {
    case ValueKind::number:
      return expected_number(key, "number");
    case ValueKind::integer:
      if (key.choices.empty()) return expected_number(key, "integer");
      [[fallthrough]];
    case ValueKind::choice:
      return one_of(key.choices);
    case ValueKind::flag:
      return "true or false";
    case ValueKind::text:
      return "a text";
    case ValueKind::name:
      return "a name of letters, digits, '_' and '-'";
    case ValueKind::vector:
      return expected_vector(key, dimension);
    case ValueKind::numbers:
      return fmt::format("a list in which each value is {}", expected_number(key, "number"));
    case ValueKind::points:
      return key.unit.empty() ? "a list of lists of numbers"
                              : fmt::format("a list of lists of numbers in {}", key.unit);
    case ValueKind::choices:
      return fmt::format("a list of texts out of {}", fmt::join(key.choices, ", "));
    case ValueKind::named_numbers:
      return fmt::format("a table in which each value is {}", expected_number(key, "number"));
    case ValueKind::entry:
      return expected_entry(key);
  }
  return "";
}

}  // namespace anvil
