// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/reader.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <set>
#include <type_traits>

#include "anvil/core/data_path.hpp"
#include "anvil/scene/check.hpp"
#include "anvil/scene/nearest_name.hpp"
#include "anvil/scene/overrides.hpp"
#include "anvil/scene/schema.hpp"
#include "anvil/scene/text_file.hpp"
#include "anvil/scene/toml_text.hpp"
#include "anvil/scene/value_reader.hpp"

namespace anvil {
namespace {

namespace fs = std::filesystem;

/// Visitor of for_each_section: fills the scene from the document.
class SceneReader {
 public:
  SceneReader(const toml::table& document, ReadContext& context) : document_(document), context_(context) {}

  template <class Owner>
  void operator()(const Section<Owner>& section, Owner& owner) {
    const toml::table absent;
    const toml::table* table = &document_;
    if (section.occurrence == Occurrence::once) {
      const toml::node* node = document_.get(section.name);
      table = node == nullptr ? &absent : as_section(*node, section.name, section.occurrence);
      if (node != nullptr) context_.places[std::string(section.name)] = context_.place_of(*node);
    }
    if (table != nullptr) read_section(section, *table, std::string(section.name), owner);
    if constexpr (std::is_same_v<Owner, Domain>) context_.dimension = owner.dimension;
  }

  template <class Owner>
  void operator()(const Section<Owner>& section, std::vector<Owner>& owners) {
    const toml::node* node = document_.get(section.name);
    if (node == nullptr) return;
    if (section.occurrence == Occurrence::by_name)
      read_named(section, *node, owners);
    else
      read_list(section, *node, owners);
  }

 private:
  const toml::table* as_section(const toml::node& node, std::string_view name, Occurrence occurrence) {
    const toml::table* table = node.as_table();
    if (table == nullptr) report_no_section(node, name, occurrence);
    return table;
  }

  void report_no_section(const toml::node& node, std::string_view name, Occurrence occurrence) {
    context_.problems.add(context_.place_of(node),
                          fmt::format("'{}' must be a section {}", name, section_heading(name, occurrence)));
  }

  template <class Owner>
  void read_named(const Section<Owner>& section, const toml::node& node, std::vector<Owner>& owners) {
    const toml::table* elements = as_section(node, section.name, section.occurrence);
    if (elements == nullptr) return;
    for (const auto& [name, element] : *elements) {
      const toml::table* table = as_section(element, section.name, section.occurrence);
      if (table == nullptr) continue;
      owners.emplace_back();
      owners.back().name = std::string(name.str());
      read_element(section, *table, owners.back());
    }
  }

  template <class Owner>
  void read_list(const Section<Owner>& section, const toml::node& node, std::vector<Owner>& owners) {
    const toml::array* elements = node.as_array();
    if (elements == nullptr ||
        !std::all_of(elements->begin(), elements->end(), [](auto& item) { return item.is_table(); })) {
      report_no_section(node, section.name, section.occurrence);
      return;
    }
    for (const toml::node& element : *elements) {
      const toml::table& table = *element.as_table();
      owners.emplace_back();
      owners.back().name = table["name"].value_or(fmt::format("{}", owners.size()));
      read_element(section, table, owners.back());
    }
  }

  template <class Owner>
  void read_element(const Section<Owner>& section, const toml::table& table, Owner& owner) {
    std::string path = fmt::format("{}.{}", section.name, owner.name);
    if (context_.places.count(path) != 0) {
      context_.problems.add(context_.place_of(table),
                            fmt::format("there is another {} named '{}'", section.name, owner.name));
      path += " (again)";  // so that the places of its keys are not mixed up
    }
    context_.places[path] = context_.place_of(table);
    read_section(section, table, path, owner);
  }

  template <class Owner>
  void read_section(const Section<Owner>& section, const toml::table& table, const std::string& path, Owner& owner) {
    std::vector<std::string_view> known;
    for (const auto& row : section.rows) known.push_back(row.key.name);
    if (section.occurrence == Occurrence::top_level)
      for (const auto& other : scene_sections())
        if (!other.name.empty()) known.push_back(other.name);
    bool inline_entry = false;
    for (const auto& row : section.rows) {
      inline_entry = inline_entry || (row.key.kind == ValueKind::entry && row.key.name == "type");
      read_row(row, table, path, known, owner);
    }
    // A section that is an entry itself had its unknown keys reported with those of the entry.
    if (!inline_entry) report_unknown(table, known, path, context_);
  }

  template <class Owner>
  void read_row(const KeyRow<Owner>& row, const toml::table& table, const std::string& path,
                std::span<const std::string_view> known, Owner& owner) {
    const Key& key = row.key;
    const std::string key_path = path.empty() ? std::string(key.name) : fmt::format("{}.{}", path, key.name);
    const toml::node* node = table.get(key.name);
    if (node != nullptr) context_.places[key_path] = context_.place_of(*node);
    if (const auto* member = std::get_if<TypedEntry Owner::*>(&row.member)) {
      if (auto entry = read_entry_of(key, node, table, path, key_path, known)) owner.*(*member) = std::move(*entry);
      return;
    }
    std::optional<Value> value;
    if (node != nullptr)
      value = read_value(key, *node, key_path, context_);
    else if (key.standard)
      value = default_value(key, context_.dimension);
    else if (!key.optional)
      report_missing(key, table, path, context_);
    if (value) std::visit([&](auto member) { assign(owner.*member, std::move(*value)); }, row.member);
  }

  std::optional<TypedEntry> read_entry_of(const Key& key, const toml::node* node, const toml::table& section,
                                          const std::string& path, const std::string& key_path,
                                          std::span<const std::string_view> known) {
    if (key.name == "type") return read_entry(key, section, path, known, context_);
    if (node == nullptr) {
      if (key.standard) return default_entry(key, context_.dimension);
      report_missing(key, section, path, context_);
      return std::nullopt;
    }
    if (const toml::table* table = node->as_table()) return read_entry(key, *table, key_path, {}, context_);
    context_.problems.add(context_.place_of(*node),
                          fmt::format("key '{}' must be {}", key_path, expected_value(key, context_.dimension)));
    return std::nullopt;
  }

  static void assign(int& member, Value value) { member = static_cast<int>(std::get<long long>(value)); }
  static void assign(TypedEntry&, const Value&) {}  // entries are read apart
  template <class Plain>
  static void assign(Plain& member, Value value) {
    member = std::get<Plain>(std::move(value));
  }

  const toml::table& document_;
  ReadContext& context_;
};

/// The names of the materials the bodies of a document ask for.
std::set<std::string> materials_asked_for(const toml::table& document) {
  std::set<std::string> names;
  if (const toml::array* bodies = document.get_as<toml::array>("body"))
    for (const toml::node& body : *bodies)
      if (const toml::table* table = body.as_table())
        if (const auto name = (*table)["material"].value<std::string>()) names.insert(*name);
  return names;
}

/// Puts bundled materials beside those of the document where bodies ask for what it does not define.
void add_bundled_materials(toml::table& document) {
  const auto bundled = list_bundled("materials", ".toml");
  for (const auto& name : materials_asked_for(document)) {
    if (document.contains("material") && !document["material"].is_table()) return;  // the reader says so
    if (document["material"].as_table() != nullptr && document["material"].as_table()->contains(name)) continue;
    if (std::find(bundled.begin(), bundled.end(), name + ".toml") == bundled.end()) continue;
    const fs::path file = find_bundled("materials", name + ".toml");
    if (!document.contains("material")) document.insert("material", toml::table{});
    document["material"].as_table()->insert(name, parse_toml(read_text_file(file), file.string()));
  }
}

/// The place of a key, or of the nearest thing around it that has one.
Place nearest_place(std::string path, const ReadContext& context) {
  while (!path.empty()) {
    if (const auto found = context.places.find(path); found != context.places.end()) return found->second;
    const auto dot = path.rfind('.');
    path.resize(dot == std::string::npos ? 0 : dot);
  }
  return {context.file};
}

void report_missing_materials(const Scene& scene, ReadContext& context) {
  std::set<std::string> defined;
  for (const auto& material : scene.materials) defined.insert(material.name);
  std::set<std::string> known = defined;
  for (const auto& file : list_bundled("materials", ".toml")) known.insert(fs::path(file).stem().string());
  const std::vector<std::string> names(known.begin(), known.end());
  for (const auto& body : scene.bodies) {
    if (body.material.empty() || defined.count(body.material) != 0) continue;
    const std::string path = fmt::format("body.{}.material", body.name);
    context.problems.add(nearest_place(path, context),
                         fmt::format("key '{}' names the material '{}', which is neither in the scene nor bundled{}",
                                     path, body.material, suggestion(body.material, views_of(names))));
  }
}

void report_missing_reference(const Scene& scene, ReadContext& context) {
  if (scene.compare.reference.empty()) return;
  std::vector<std::string> names = {std::string(exact_reference), std::string(exact_small_strain_reference)};
  for (const auto& file : list_bundled("reference", ".toml")) names.push_back(fs::path(file).stem().string());
  if (std::find(names.begin(), names.end(), scene.compare.reference) != names.end()) return;
  const std::string path = "compare.reference";
  context.problems.add(nearest_place(path, context),
                       fmt::format("key '{}' names the reference '{}', which is neither exact nor bundled{}", path,
                                   scene.compare.reference, suggestion(scene.compare.reference, views_of(names))));
}

void drop_unused_materials(Scene& scene) {
  std::erase_if(scene.materials, [&](const MaterialDescription& material) {
    return std::none_of(scene.bodies.begin(), scene.bodies.end(),
                        [&](const BodyDescription& body) { return body.material == material.name; });
  });
}

/// The defaults that follow from other keys; see `derived` in the schema.
void fill_derived_defaults(Scene& scene) {
  if (scene.domain.strain_state.empty()) {
    const std::string_view by_dimension[] = {"uniaxial_strain", "plane_strain", "full"};
    scene.domain.strain_state = by_dimension[scene.domain.dimension - 1];
  }
  // Read before the dimension is known.
  if (scene.domain.gravity == std::vector<double>{0.0})
    scene.domain.gravity.assign(static_cast<std::size_t>(scene.domain.dimension), 0.0);
  if (scene.discretisation.momentum_form.empty())
    scene.discretisation.momentum_form = scene.discretisation.method == "cspm" ? "difference" : "sum";
  constexpr int usual_frames = 20;
  const int frames = scene.output.frames > 0 ? scene.output.frames : usual_frames;
  if (scene.output.interval == 0.0 || scene.output.frames > 0) scene.output.interval = scene.time.end / frames;
  scene.output.frames = 0;
  if (scene.output.interval == 0.0)
    scene.output.interval = 1.0;  // nothing lies between the frames of a run that ends at 0
}

void read_document(toml::table& document, const std::vector<std::string>& overrides, Scene& scene,
                   ReadContext& context) {
  // Overrides of materials come last: they may change a bundled one, which another override may have asked for.
  std::vector<std::string> ordered = overrides;
  const auto of_materials = std::stable_partition(ordered.begin(), ordered.end(),
                                                  [](const auto& text) { return !text.starts_with("material."); });
  apply_overrides(document, {ordered.begin(), of_materials}, context);
  add_bundled_materials(document);
  apply_overrides(document, {of_materials, ordered.end()}, context);

  for_each_section(scene, SceneReader(document, context));
  if (scene.bodies.empty() && !document.contains("body"))
    context.problems.add({context.file}, "the scene has no [[body]]: at least one is needed");
  report_missing_materials(scene, context);
  report_missing_reference(scene, context);
}

Scene read_scene_from(const std::string& text, const std::string& file, const std::string& name,
                      const std::vector<std::string>& overrides) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) throw InputError(file + ": the file is empty");
  toml::table document = parse_toml(text, file);
  ReadContext context;
  context.file = file;
  Scene scene{};
  scene.name = name;
  read_document(document, overrides, scene, context);
  context.problems.throw_if_any();

  fill_derived_defaults(scene);
  drop_unused_materials(scene);
  for (const auto& [key, sentence] : find_contradictions(scene))
    context.problems.add(nearest_place(key, context), fmt::format("key '{}': {}", key, sentence));
  context.problems.throw_if_any();
  return scene;
}

}  // namespace

Scene read_scene(const fs::path& file, const std::vector<std::string>& overrides) {
  return read_scene_from(read_text_file(file), file.string(), file.stem().string(), overrides);
}

Scene read_scene_text(const std::string& text, const std::string& name, const std::vector<std::string>& overrides) {
  return read_scene_from(text, name, name, overrides);
}

fs::path locate_scene(const std::string& argument) {
  std::error_code failure;
  if (argument.empty()) throw InputError("the name of the scene is empty");
  const bool folder = fs::is_directory(argument, failure);  // a result may bear the name of its scene
  if (!folder && fs::exists(argument, failure)) return argument;
  std::vector<std::string> names;
  for (const auto& file : list_bundled("scenes", ".toml")) names.push_back(fs::path(file).stem().string());
  if (std::find(names.begin(), names.end(), argument) != names.end()) return find_bundled("scenes", argument + ".toml");
  if (folder) return argument;  // the reader says what is wrong
  throw InputError(fmt::format("there is no file '{}' and no bundled scene of that name{}", argument,
                               suggestion(fs::path(argument).stem().string(), views_of(names))));
}

}  // namespace anvil
