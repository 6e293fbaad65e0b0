// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/value_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "anvil/scene/nearest_name.hpp"

namespace anvil {
namespace {

std::optional<double> finite_number(const toml::node& node) {
  if (!node.is_number()) return std::nullopt;
  const auto number = node.value<double>();
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<std::vector<double>> finite_numbers(const toml::node& node) {
  const toml::array* items = node.as_array();
  if (items == nullptr) return std::nullopt;
  std::vector<double> numbers;
  for (const toml::node& item : *items) {
    const auto number = finite_number(item);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<Value> read_points(const toml::node& node) {
  const toml::array* items = node.as_array();
  if (items == nullptr || items->empty()) return std::nullopt;
  Points points;
  for (const toml::node& item : *items) {
    auto point = finite_numbers(item);
    if (!point || point->empty() || (!points.empty() && point->size() != points.front().size())) return std::nullopt;
    points.push_back(std::move(*point));
  }
  return points;
}

std::optional<Value> read_texts(const toml::node& node) {
  const toml::array* items = node.as_array();
  if (items == nullptr) return std::nullopt;
  Texts texts;
  for (const toml::node& item : *items) {
    if (!item.is_string()) return std::nullopt;
    texts.push_back(item.as_string()->get());
  }
  return texts;
}

std::optional<Value> read_named_numbers(const toml::node& node) {
  const toml::table* items = node.as_table();
  if (items == nullptr) return std::nullopt;
  NamedNumbers numbers;
  for (const auto& [name, item] : *items) {
    const auto number = finite_number(item);
    if (!number) return std::nullopt;
    numbers[std::string(name.str())] = *number;
  }
  return numbers;
}

bool is_name(std::string_view text) {
  constexpr std::size_t longest = 64;  // names become parts of file names
  return !text.empty() && text.size() <= longest && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

/// The node as what a kind holds in memory; nothing when it is of another type.
std::optional<Value> value_of_kind(ValueKind kind, const toml::node& node, int dimension) {
  switch (kind) {
    case ValueKind::number:
      return finite_number(node);
    case ValueKind::integer:
      if (!node.is_integer()) return std::nullopt;
      return static_cast<long long>(node.as_integer()->get());
    case ValueKind::flag:
      return node.value_exact<bool>();
    case ValueKind::text:
    case ValueKind::choice:
      return node.value_exact<std::string>();
    case ValueKind::name:
      if (!node.is_string() || !is_name(node.as_string()->get())) return std::nullopt;
      return node.as_string()->get();
    case ValueKind::vector: {
      const auto numbers = finite_numbers(node);
      if (!numbers || (dimension != 0 && numbers->size() != static_cast<std::size_t>(dimension))) return std::nullopt;
      return numbers;
    }
    case ValueKind::numbers:
      return finite_numbers(node);
    case ValueKind::points:
      return read_points(node);
    case ValueKind::choices:
      return read_texts(node);
    case ValueKind::named_numbers:
      return read_named_numbers(node);
    case ValueKind::entry:
      break;
  }
  return std::nullopt;
}

bool in_range(double number, Range range) {
  switch (range) {
    case Range::positive:
      return number > 0.0;
    case Range::not_negative:
      return number >= 0.0;
    case Range::fraction:
      return number >= 0.0 && number <= 1.0;
    case Range::half_fraction:
      return number >= 0.0 && number <= 0.5;
    case Range::any:
      break;
  }
  return true;
}

bool in_range(const Value& value, Range range) {
  if (const auto* number = std::get_if<double>(&value)) return in_range(*number, range);
  if (const auto* integer = std::get_if<long long>(&value)) return in_range(static_cast<double>(*integer), range);
  if (const auto* several = std::get_if<std::vector<double>>(&value))
    return std::all_of(several->begin(), several->end(), [&](double number) { return in_range(number, range); });
  if (const auto* numbers = std::get_if<NamedNumbers>(&value))
    return std::all_of(numbers->begin(), numbers->end(),
                       [&](const auto& item) { return in_range(item.second, range); });
  return true;
}

/// The first text of the value that is none of the choices, if any.
std::optional<std::string> not_a_choice(const Value& value, const std::vector<std::string_view>& choices) {
  Texts texts;
  if (const auto* text = std::get_if<std::string>(&value)) texts = {*text};
  if (const auto* integer = std::get_if<long long>(&value)) texts = {std::to_string(*integer)};
  if (const auto* several = std::get_if<Texts>(&value)) texts = *several;
  for (const auto& text : texts)
    if (std::find(choices.begin(), choices.end(), text) == choices.end()) return text;
  return std::nullopt;
}

std::string shortened(std::string text) {
  constexpr std::size_t longest = 60;
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  const auto both_blank = [](char a, char b) { return a == ' ' && b == ' '; };
  text.erase(std::unique(text.begin(), text.end(), both_blank), text.end());
  if (text.size() <= longest) return text;
  std::size_t cut = longest;
  while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0) == 0x80) --cut;  // not inside a UTF-8 character
  return text.substr(0, cut) + "...";
}

/// What was found instead of what was expected.
std::string found_value(const toml::node& node, const Key& key) {
  if (const auto* items = node.as_array(); items != nullptr && key.kind == ValueKind::vector && finite_numbers(node))
    return fmt::format("{} of them", items->size());
  if (const auto* items = node.as_table(); items != nullptr && key.kind == ValueKind::named_numbers) {
    for (const auto& [name, item] : *items)
      if (const auto number = finite_number(item); !number || !in_range(*number, key.range))
        return fmt::format("{} for '{}'", found_value(item, {.name = key.name}), shortened(std::string(name.str())));
  }
  if (node.is_string()) return fmt::format("the text \"{}\"", shortened(node.as_string()->get()));
  if (node.is_table()) return "a table";
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  std::ostringstream text;
  node.visit([&](const auto& any) { text << any; });
  return shortened(text.str());
}

/// What a user can do about it, when that is plain to see.
std::string advice(const Key& key, const toml::node& node, const std::optional<Value>& value) {
  if (value && !key.choices.empty()) {
    if (const auto wrong = not_a_choice(*value, key.choices)) {
      const std::string_view nearest = nearest_name(*wrong, key.choices);
      return nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest);
    }
  }
  const bool numeric = key.kind == ValueKind::number || key.kind == ValueKind::integer;
  if (numeric && node.is_string() && node.as_string()->get().find_first_of("0123456789") != std::string::npos)
    return "; write the bare number in SI units, without quotes and unit";
  return "";
}

std::string entry_of(const std::string& path) { return path.empty() ? "the scene" : fmt::format("'{}'", path); }

std::vector<std::string_view> types_of(std::span<const EntryKind> kinds) {
  std::vector<std::string_view> types;
  for (const EntryKind& kind : kinds) types.push_back(kind.type);
  return types;
}

std::string joined_path(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

/// The kind that the table names by `type`, or null and a problem.
const EntryKind* find_kind(const Key& key, const toml::table& table, const std::string& path, ReadContext& context) {
  const toml::node* type = table.get("type");
  const std::string type_path = joined_path(path, "type");
  if (type == nullptr) {
    context.problems.add(context.place_of(table), fmt::format("key '{}' is missing: it must be one of {}", type_path,
                                                              fmt::join(types_of(key.entries()), ", ")));
    return nullptr;
  }
  const std::string name = type->value_or(std::string());
  for (const EntryKind& kind : key.entries()) {
    if (kind.type != name) continue;
    if (context.dimension == 0 ||
        std::find(kind.dimensions.begin(), kind.dimensions.end(), context.dimension) != kind.dimensions.end())
      return &kind;
    context.problems.add(
        context.place_of(*type),
        fmt::format("key '{}' cannot be {} here: it is made for scenes of dimension {}, and this one has {}", type_path,
                    name, fmt::join(kind.dimensions, " or "), context.dimension));
    return nullptr;
  }
  const auto types = types_of(key.entries());
  const std::string_view nearest = nearest_name(name, types);
  context.problems.add(
      context.place_of(*type),
      fmt::format("key '{}' must be one of {}, found {}{}", type_path, fmt::join(types, ", "), found_value(*type, key),
                  nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest)));
  return nullptr;
}

}  // namespace

Place ReadContext::place_of(const toml::node& node) const { return place_of(node.source()); }

Place ReadContext::place_of(const toml::key& key, const toml::node& value) const {
  return place_of(key.source().path ? key.source() : value.source());
}

Place ReadContext::place_of(const toml::source_region& source) const {
  if (!source.path) return {file, 0, 0};
  if (source.path->starts_with("--set ")) return {*source.path, 0, 0};
  return {*source.path, source.begin.line, source.begin.column};
}

std::optional<Value> read_value(const Key& key, const toml::node& node, const std::string& path, ReadContext& context) {
  auto value = value_of_kind(key.kind, node, context.dimension);
  if (value && in_range(*value, key.range) && (key.choices.empty() || !not_a_choice(*value, key.choices))) return value;
  context.problems.add(context.place_of(node),
                       fmt::format("key '{}' must be {}, found {}{}", path, expected_value(key, context.dimension),
                                   found_value(node, key), advice(key, node, value)));
  return std::nullopt;
}

Value default_value(const Key& key, int dimension) {
  Value value = key.standard.value();
  // Before the dimension is known, one number stands for all.
  if (auto* numbers = std::get_if<std::vector<double>>(&value);
      numbers != nullptr && key.kind == ValueKind::vector && dimension > 0)
    numbers->assign(static_cast<std::size_t>(dimension), numbers->front());
  return value;
}

void report_missing(const Key& key, const toml::table& table, const std::string& path, ReadContext& context) {
  context.problems.add(context.place_of(table),
                       fmt::format("{} lacks the key '{}' ({}): it must be {}", entry_of(path), key.name, key.help,
                                   expected_value(key, context.dimension)));
}

void report_unknown(const toml::table& table, std::span<const std::string_view> known, const std::string& path,
                    ReadContext& context) {
  for (const auto& [key, node] : table) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    context.problems.add(
        context.place_of(key, node),
        fmt::format("key '{}' is unknown{}", shortened(joined_path(path, key.str())), suggestion(key.str(), known)));
  }
}

std::optional<TypedEntry> read_entry(const Key& key, const toml::table& table, const std::string& path,
                                     std::span<const std::string_view> shared, ReadContext& context) {
  const EntryKind* kind = find_kind(key, table, path, context);
  if (kind == nullptr) return std::nullopt;
  TypedEntry entry{std::string(kind->type), {}};
  std::vector<std::string_view> known(shared.begin(), shared.end());
  known.emplace_back("type");
  for (const Key& parameter : kind->keys) {
    known.push_back(parameter.name);
    const std::string name(parameter.name);
    const std::string parameter_path = joined_path(path, name);
    if (const toml::node* node = table.get(name); node != nullptr) {
      context.places[parameter_path] = context.place_of(*node);
      if (auto value = read_value(parameter, *node, parameter_path, context))
        entry.parameters.set(name, std::move(*value));
    } else if (parameter.standard) {
      entry.parameters.set(name, default_value(parameter, context.dimension));
    } else if (!parameter.optional) {
      report_missing(parameter, table, path, context);
    }
  }
  report_unknown(table, known, path, context);
  return entry;
}

TypedEntry default_entry(const Key& key, int dimension) {
  TypedEntry entry{std::get<std::string>(key.standard.value()), {}};
  for (const EntryKind& kind : key.entries())
    if (kind.type == entry.type)
      for (const Key& parameter : kind.keys)
        if (parameter.standard) entry.parameters.set(std::string(parameter.name), default_value(parameter, dimension));
  return entry;
}

}  // namespace anvil
