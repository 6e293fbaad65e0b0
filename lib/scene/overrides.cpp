// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/overrides.hpp"

#include <fmt/format.h>

#include <boost/algorithm/string.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "anvil/scene/nearest_name.hpp"
#include "anvil/scene/schema.hpp"

namespace anvil {
namespace {

/// One override on its way into the document.
struct Override {
  std::string place;              // --set KEY=VALUE
  std::vector<std::string> path;  // KEY, split at its dots
  toml::table holder;             // owns the value, under `value`
};

/// The value as TOML, or as a text when it is not TOML.
toml::table parse_value(const std::string& text, const std::string& place) {
  const bool one_line = text.find_first_of("\r\n") == std::string::npos;
  if (one_line) {
    try {
      return toml::parse("value = " + text, place);
    } catch (const toml::parse_error&) {
      // a bare word, or something the reader will refuse by its key
    }
  }
  toml::table quoted = toml::parse("value = ''", place);
  *quoted.get_as<std::string>("value") = text;
  return quoted;
}

std::optional<Override> split_override(const std::string& text, ReadContext& context) {
  Override result;
  result.place = "--set " + text;
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    context.problems.add({result.place}, "an override is written KEY=VALUE, for example time.end=1e-5");
    return std::nullopt;
  }
  const std::string key = boost::trim_copy(text.substr(0, equals));
  boost::split(result.path, key, boost::is_any_of("."));
  for (const auto& part : result.path) {
    if (!part.empty()) continue;
    context.problems.add({result.place}, fmt::format("'{}' is not a key: something is missing beside a dot", key));
    return std::nullopt;
  }
  result.holder = parse_value(boost::trim_copy(text.substr(equals + 1)), result.place);
  return result;
}

const SectionKeys* find_section(const std::vector<SectionKeys>& sections, std::string_view name) {
  for (const auto& section : sections)
    if (!section.name.empty() && section.name == name) return &section;
  return nullptr;
}

/// The table with that `name` in an array of tables, or null and a problem.
toml::table* find_element(toml::table& document, const Override& one, ReadContext& context) {
  const std::string& section = one.path[0];
  std::vector<std::string> names;
  if (toml::array* elements = document.get_as<toml::array>(section)) {
    for (toml::node& element : *elements) {
      toml::table* table = element.as_table();
      if (table == nullptr) continue;
      names.push_back((*table)["name"].value_or(std::string()));
      if (names.back() == one.path[1]) return table;
    }
  }
  context.problems.add({one.place}, fmt::format("there is no {} named '{}'{}", section, one.path[1],
                                                suggestion(one.path[1], views_of(names))));
  return nullptr;
}

/// The table the value belongs to, made where it does not exist yet; null and a problem when something else is there.
toml::table* find_table(toml::table& document, const Override& one, Occurrence occurrence, ReadContext& context) {
  toml::table* table = &document;
  std::size_t depth = 0;
  if (occurrence == Occurrence::list && one.path.size() > 1) {
    table = find_element(document, one, context);
    depth = 2;
  }
  for (; table != nullptr && depth + 1 < one.path.size(); ++depth) {
    const std::string& name = one.path[depth];
    if (!table->contains(name))
      table->insert(toml::key(name, toml::source_region(one.holder.get("value")->source())), toml::table{});
    table = table->get_as<toml::table>(name);
    if (table == nullptr) context.problems.add({one.place}, fmt::format("'{}' is a value and has no keys", name));
  }
  return table;
}

void apply_override(toml::table& document, Override one, ReadContext& context) {
  const auto sections = scene_sections();
  const SectionKeys* section = find_section(sections, one.path[0]);
  if (section == nullptr && one.path.size() > 1) {
    std::vector<std::string_view> names;
    for (const auto& known : sections)
      if (!known.name.empty()) names.push_back(known.name);
    context.problems.add({one.place},
                         fmt::format("section '{}' is unknown{}", one.path[0], suggestion(one.path[0], names)));
    return;
  }
  const Occurrence occurrence = section == nullptr ? Occurrence::top_level : section->occurrence;
  if (occurrence == Occurrence::list && one.path.size() == 2) {
    context.problems.add({one.place},
                         fmt::format("say which key of {0} '{1}': {0}.{1}.KEY=VALUE", one.path[0], one.path[1]));
    return;
  }
  toml::table* table = find_table(document, one, occurrence, context);
  if (table == nullptr) return;
  auto value = one.holder.find("value");
  toml::key key(one.path.back(), toml::source_region(value->second.source()));
  table->erase(one.path.back());  // so that the new key's place is kept
  table->insert(key, std::move(value->second));
}

}  // namespace

void apply_overrides(toml::table& document, std::span<const std::string> overrides, ReadContext& context) {
  for (const auto& text : overrides)
    if (auto one = split_override(text, context)) apply_override(document, std::move(*one), context);
}

}  // namespace anvil
