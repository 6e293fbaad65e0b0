// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/writer.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <sstream>

#include "anvil/scene/schema.hpp"

namespace anvil {
namespace {

std::string joined(const std::vector<std::string>& items) {
  std::string text;
  for (const auto& item : items) text += (text.empty() ? "" : ", ") + item;
  return text;
}

/// Overloads by what a Value holds.
struct ValueWriter {
  /// The shortest digits that read back to the same double, always with the looks of a float.
  std::string operator()(double number) const {
    std::string digits = fmt::format("{}", number);
    if (digits.find_first_of(".en") == std::string::npos) digits += ".0";
    return digits;
  }
  std::string operator()(long long number) const { return fmt::format("{}", number); }
  std::string operator()(bool flag) const { return flag ? "true" : "false"; }
  std::string operator()(const std::string& text) const {
    std::ostringstream quoted;
    quoted << toml::json_formatter(toml::value<std::string>(text));  // a JSON string is a basic string of TOML
    return quoted.str();
  }
  template <class Item>
  std::string operator()(const std::vector<Item>& list) const {
    std::vector<std::string> items;
    for (const auto& item : list) items.push_back((*this)(item));
    return "[" + joined(items) + "]";
  }
  std::string operator()(const NamedNumbers& numbers) const {
    std::vector<std::string> items;
    for (const auto& [name, number] : numbers) items.push_back((*this)(name) + " = " + (*this)(number));
    return items.empty() ? "{}" : "{ " + joined(items) + " }";
  }
};

std::string write_entry(const TypedEntry& entry) {
  std::string text = "{ type = " + write_value(entry.type);
  for (const auto& [key, value] : entry.parameters.all()) text += fmt::format(", {} = {}", key, write_value(value));
  return text + " }";
}

template <class Owner>
class SectionWriter {
 public:
  SectionWriter(std::string& text, const Owner& owner) : text_(text), owner_(owner) {}

  void write(const KeyRow<Owner>& row) {
    std::visit([&](auto member) { write_member(row.key.name, owner_.*member); }, row.member);
  }

 private:
  void write_line(std::string_view key, const std::string& value) { text_ += fmt::format("{} = {}\n", key, value); }
  void write_member(std::string_view key, int number) { write_line(key, fmt::format("{}", number)); }
  void write_member(std::string_view key, const TypedEntry& entry) {
    if (key != "type") return write_line(key, write_entry(entry));
    write_line(key, write_value(entry.type));
    for (const auto& [name, value] : entry.parameters.all()) write_line(name, write_value(value));
  }
  template <class Plain>
  void write_member(std::string_view key, const Plain& value) {
    write_line(key, write_value(Value(value)));
  }

  std::string& text_;
  const Owner& owner_;
};

/// Visitor of for_each_section.
struct SceneWriter {
  std::string text;

  template <class Owner>
  void operator()(const Section<Owner>& section, const Owner& owner) {
    if (section.occurrence != Occurrence::top_level)
      text += "\n" + section_heading(section.name, section.occurrence) + "\n";
    write_rows(section, owner);
  }

  template <class Owner>
  void operator()(const Section<Owner>& section, const std::vector<Owner>& owners) {
    for (const Owner& owner : owners) {
      text += section.occurrence == Occurrence::by_name ? fmt::format("\n[{}.{}]\n", section.name, owner.name)
                                                        : fmt::format("\n[[{}]]\n", section.name);
      write_rows(section, owner);
    }
  }

 private:
  template <class Owner>
  void write_rows(const Section<Owner>& section, const Owner& owner) {
    SectionWriter<Owner> writer(text, owner);
    for (const auto& row : section.rows) writer.write(row);
  }
};

}  // namespace

std::string write_value(const Value& value) { return std::visit(ValueWriter{}, value); }

std::string write_scene(const Scene& scene) {
  SceneWriter writer;
  for_each_section(scene, writer);
  return writer.text;
}

std::string write_scene_json(const Scene& scene) {
  const toml::table document = toml::parse(write_scene(scene));
  std::ostringstream json;
  json << toml::json_formatter(document);
  return json.str();
}

}  // namespace anvil
