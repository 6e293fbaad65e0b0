// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/core.h>
#include <toml++/toml.h>

#include <array>
#include <filesystem>
#include <string>

#include "anvil/core/data_path.hpp"
#include "anvil/core/error.hpp"
#include "anvil/kernels/kernel.hpp"
#include "anvil/output/atomic_file.hpp"
#include "anvil/scene/nearest_name.hpp"
#include "anvil/scene/reader.hpp"
#include "anvil/scene/schema.hpp"
#include "anvil/scene/writer.hpp"
#include "anvil/study/description.hpp"
#include "command_line.hpp"
#include "table.hpp"

namespace anvil {
namespace {

std::string stem_of(const std::string& file) { return std::filesystem::path(file).stem().string(); }

void list_scenes() {
  std::vector<TableRow> rows;
  for (const auto& file : list_bundled("scenes", ".toml"))
    rows.push_back({stem_of(file), read_scene(find_bundled("scenes", file)).title});
  print_table(rows, "ll");
}

void list_studies() {
  std::vector<TableRow> rows;
  for (const auto& file : list_bundled("studies", ".toml"))
    rows.push_back({stem_of(file), read_study(find_bundled("studies", file)).title});
  print_table(rows, "ll");
}

std::string material_summary(const std::filesystem::path& file) {
  const toml::table material = toml::parse(read_text(file), file.string());
  return fmt::format("{} kg/m3, eos {}, strength {}", material["density"].value_or(0.0),
                     material["eos"]["type"].value_or(""), material["strength"]["type"].value_or(""));
}

void list_materials() {
  std::vector<TableRow> rows;
  for (const auto& file : list_bundled("materials", ".toml"))
    rows.push_back({stem_of(file), material_summary(find_bundled("materials", file))});
  print_table(rows, "ll");
}

void list_kernels() {
  std::vector<TableRow> rows;
  for (const auto name : kernel_names()) rows.push_back({std::string(name), std::string(kernel_summary(name))});
  print_table(rows, "ll");
}

/// The kinds of shapes, laws and boundaries, wherever a key of the schema takes one.
void list_models() {
  std::vector<TableRow> rows;
  for (const auto& section : scene_sections())
    for (const Key* key : section.keys) {
      if (key->entries == nullptr) continue;
      for (const auto& kind : key->entries())
        rows.push_back(
            {fmt::format("{}.{}", section.name, key->name), std::string(kind.type), std::string(kind.summary)});
    }
  print_table(rows, "lll");
}

std::string default_of(const Key& key) {
  if (key.standard) return write_value(*key.standard);
  return key.optional ? "may be absent" : "must be given";
}

void list_keys() {
  std::vector<TableRow> rows = {{"key", "default", "value", "meaning"}};
  for (const auto& section : scene_sections())
    for (const Key* key : section.keys) {
      const std::string name = section.name.empty() ? std::string(key->name)  //
                                                    : fmt::format("{}.{}", section.name, key->name);
      rows.push_back({name, default_of(*key), expected_value(*key, 0), std::string(key->help)});
    }
  print_table(rows, "llll");
}

struct Topic {
  std::string_view name;
  void (*print)();
};
constexpr std::array topics = {Topic{"scenes", list_scenes},       Topic{"studies", list_studies},
                               Topic{"materials", list_materials}, Topic{"kernels", list_kernels},
                               Topic{"models", list_models},       Topic{"keys", list_keys}};

void list_topic(const std::string& name) {
  std::vector<std::string_view> names;
  for (const auto& topic : topics) {
    if (topic.name == name) return topic.print();
    names.push_back(topic.name);
  }
  throw InputError(fmt::format("there is no list of '{}'{}", name, suggestion(name, names)));
}

}  // namespace

int execute_list(const Arguments& arguments) {
  Usage usage{"anvil list [scenes|studies|materials|kernels|models|keys]",
              "Lists what comes with anvil, one line each; without an argument, all but the keys of scene files.",
              "TOPIC"};
  const auto values = parse(usage, arguments);
  if (!values) return 0;
  if (values->count("TOPIC") != 0) {
    list_topic((*values)["TOPIC"].as<std::string>());
    return 0;
  }
  for (const auto& topic : topics) {
    if (topic.name == "keys") continue;
    fmt::print("{}\n", topic.name);
    topic.print();
    fmt::print("\n");
  }
  return 0;
}

}  // namespace anvil
