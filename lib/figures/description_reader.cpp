// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <type_traits>
#include <variant>

#include "anvil/core/data_path.hpp"
#include "anvil/figures/description.hpp"
#include "anvil/scene/nearest_name.hpp"
#include "anvil/scene/text_file.hpp"
#include "anvil/scene/toml_text.hpp"
#include "anvil/scene/value_reader.hpp"

namespace anvil {
namespace {

template <class Owner>
struct FigureKey {
  Key key;
  std::variant<int Owner::*, bool Owner::*, std::string Owner::*, std::vector<double> Owner::*> member;
};

template <class Owner>
using FigureKeys = std::vector<FigureKey<Owner>>;

FigureKeys<FigureDescription> figure_keys() {
  return {{{.name = "title", .kind = ValueKind::text}, &FigureDescription::title},
          {{.name = "width", .kind = ValueKind::integer, .range = Range::positive}, &FigureDescription::width},
          {{.name = "height", .kind = ValueKind::integer, .range = Range::positive}, &FigureDescription::height},
          {{.name = "columns", .kind = ValueKind::integer, .range = Range::positive}, &FigureDescription::columns}};
}

FigureKeys<PanelDescription> panel_keys() {
  return {{{.name = "title", .kind = ValueKind::text}, &PanelDescription::title},
          {{.name = "equal_scales", .kind = ValueKind::flag}, &PanelDescription::equal_scales}};
}

FigureKeys<AxisDescription> axis_keys() {
  return {{{.name = "quantity", .kind = ValueKind::text}, &AxisDescription::quantity},
          {{.name = "label", .kind = ValueKind::text}, &AxisDescription::label},
          {{.name = "unit", .kind = ValueKind::text}, &AxisDescription::unit},
          {{.name = "logarithmic", .kind = ValueKind::flag}, &AxisDescription::logarithmic},
          {{.name = "range", .kind = ValueKind::numbers}, &AxisDescription::range}};
}

FigureKeys<CurveDescription> curve_keys() {
  return {{{.name = "field", .kind = ValueKind::text}, &CurveDescription::field},
          {{.name = "times", .kind = ValueKind::numbers, .unit = "s", .range = Range::not_negative},
           &CurveDescription::times},
          {{.name = "where", .kind = ValueKind::text}, &CurveDescription::where},
          {{.name = "line", .kind = ValueKind::numbers, .unit = "m"}, &CurveDescription::line},
          {{.name = "exact", .kind = ValueKind::flag}, &CurveDescription::exact},
          {{.name = "history", .kind = ValueKind::text}, &CurveDescription::history},
          {{.name = "file", .kind = ValueKind::text}, &CurveDescription::file},
          {{.name = "x_column", .kind = ValueKind::text}, &CurveDescription::x_column},
          {{.name = "y_column", .kind = ValueKind::text}, &CurveDescription::y_column},
          {{.name = "label", .kind = ValueKind::text}, &CurveDescription::label},
          {{.name = "style", .kind = ValueKind::choice, .choices = {"line", "points", "reference", "wall"}},
           &CurveDescription::style}};
}

FigureKeys<MapDescription> map_keys() {
  return {{{.name = "field", .kind = ValueKind::text}, &MapDescription::field},
          {{.name = "label", .kind = ValueKind::text}, &MapDescription::label},
          {{.name = "unit", .kind = ValueKind::text}, &MapDescription::unit},
          {{.name = "range", .kind = ValueKind::numbers}, &MapDescription::range}};
}

class DescriptionReader {
 public:
  explicit DescriptionReader(ReadContext& context) : context_(context) {}

  FigureDescription read(const toml::table& document) {
    FigureDescription figure;
    read_keys(document, "", figure_keys(), {"panel"}, figure);
    for_each_table(document, "panel", "", [&](const toml::table& table, const std::string& path) {
      figure.panels.push_back(read_panel(table, path));
    });
    if (figure.panels.empty() && !document.contains("panel"))
      context_.problems.add({context_.file}, "the figure has no [[panel]]: at least one is needed");
    return figure;
  }

 private:
  PanelDescription read_panel(const toml::table& table, const std::string& path) {
    PanelDescription panel;
    read_keys(table, path, panel_keys(), {"x", "y", "curve", "map"}, panel);
    read_axis(table, path, "x", panel.x);
    read_axis(table, path, "y", panel.y);
    for_each_table(table, "curve", path, [&](const toml::table& curve, const std::string& curve_path) {
      panel.curves.push_back(read_curve(curve, curve_path));
    });
    if (const toml::table* map = table_at(table, "map", path)) {
      panel.map.emplace();
      read_keys(*map, path + ".map", map_keys(), {}, *panel.map);
      check_range(*map, path + ".map", panel.map->range);
      if (panel.map->field.empty())
        context_.problems.add(context_.place_of(*map), fmt::format("'{}.map' lacks the key 'field'", path));
    }
    if (panel.curves.empty() && !panel.map)
      context_.problems.add(context_.place_of(table), fmt::format("'{}' shows nothing: give it a [[panel.curve]] or a "
                                                                  "[panel.map]",
                                                                  path));
    return panel;
  }

  void read_axis(const toml::table& panel, const std::string& path, const std::string& name, AxisDescription& axis) {
    const toml::table* table = table_at(panel, name, path);
    if (table == nullptr) return;
    const std::string axis_path = fmt::format("{}.{}", path, name);
    read_keys(*table, axis_path, axis_keys(), {}, axis);
    check_range(*table, axis_path, axis.range);
    if (name == "y" && !axis.quantity.empty())
      context_.problems.add(
          context_.place_of(*table),
          fmt::format("key '{}.quantity' belongs to x; what is drawn upward is a curve's", axis_path));
  }

  CurveDescription read_curve(const toml::table& table, const std::string& path) {
    CurveDescription curve;
    read_keys(table, path, curve_keys(), {}, curve);
    const auto given = static_cast<int>(!curve.field.empty()) + static_cast<int>(!curve.history.empty()) +
                       static_cast<int>(!curve.file.empty());
    if (given != 1)
      context_.problems.add(context_.place_of(table),
                            fmt::format("'{}' must have exactly one of the keys field, history and file", path));
    if (curve.field.empty() && (curve.exact || !curve.times.empty() || !curve.where.empty() || !curve.line.empty()))
      context_.problems.add(context_.place_of(table),
                            fmt::format("'{}' has no field, which the keys times, where, line and exact need", path));
    if (!curve.line.empty() && curve.line.size() != 6)
      context_.problems.add(context_.place_of(table),
                            fmt::format("key '{}.line' must be six numbers, the x, y and z of both ends, found {}",
                                        path, curve.line.size()));
    if (!curve.line.empty() && (!curve.where.empty() || curve.exact))
      context_.problems.add(context_.place_of(table),
                            fmt::format("'{}' has a line, with which where and exact cannot go", path));
    if (!curve.file.empty() && (curve.x_column.empty() || curve.y_column.empty()))
      context_.problems.add(context_.place_of(table),
                            fmt::format("'{}' lacks x_column or y_column, the columns of its file", path));
    return curve;
  }

  /// The table of that name, or nullptr; a problem when it is something else.
  const toml::table* table_at(const toml::table& parent, const std::string& name, const std::string& path) {
    const toml::node* node = parent.get(name);
    if (node != nullptr && !node->is_table())
      context_.problems.add(context_.place_of(*node), fmt::format("'{}.{}' must be a table", path, name));
    return node == nullptr ? nullptr : node->as_table();
  }

  template <class Visitor>
  void for_each_table(const toml::table& parent, const std::string& name, const std::string& path, Visitor&& visit) {
    const toml::node* node = parent.get(name);
    if (node == nullptr) return;
    const std::string base = path.empty() ? name : fmt::format("{}.{}", path, name);
    const toml::array* tables = node->as_array();
    const bool all =
        tables != nullptr && std::all_of(tables->begin(), tables->end(), [](auto& t) { return t.is_table(); });
    if (!all) {
      context_.problems.add(context_.place_of(*node), fmt::format("'{}' must be written as [[{}]]", base,
                                                                  name == "curve" ? "panel.curve" : name));
      return;
    }
    int number = 0;
    for (const toml::node& table : *tables) visit(*table.as_table(), fmt::format("{}.{}", base, ++number));
  }

  void check_range(const toml::table& table, const std::string& path, const std::vector<double>& range) {
    if (range.empty() || (range.size() == 2 && range[0] < range[1])) return;
    context_.problems.add(context_.place_of(*table.get("range")),
                          fmt::format("key '{}.range' must be two ascending numbers, as [low, high]", path));
  }

  template <class Owner>
  void read_keys(const toml::table& table, const std::string& path, const FigureKeys<Owner>& keys,
                 std::vector<std::string_view> known, Owner& owner) {
    for (const auto& row : keys) {
      known.push_back(row.key.name);
      const toml::node* node = table.get(row.key.name);
      if (node == nullptr) continue;
      const std::string key_path = path.empty() ? std::string(row.key.name) : fmt::format("{}.{}", path, row.key.name);
      const auto value = read_value(row.key, *node, key_path, context_);
      if (value) std::visit([&](auto member) { assign(owner.*member, *value); }, row.member);
    }
    report_unknown(table, known, path, context_);
  }

  static void assign(int& member, const Value& value) { member = static_cast<int>(std::get<long long>(value)); }
  template <class Plain>
  static void assign(Plain& member, const Value& value) {
    member = std::get<Plain>(value);
  }

  ReadContext& context_;
};

}  // namespace

FigureDescription read_figure_description_text(const std::string& text, const std::string& file) {
  const toml::table document = parse_toml(text, file);
  ReadContext context;
  context.file = file;
  FigureDescription figure = DescriptionReader(context).read(document);
  context.problems.throw_if_any();
  return figure;
}

FigureDescription read_figure_description(const std::filesystem::path& file) {
  FigureDescription figure = read_figure_description_text(read_text_file(file), file.string());
  figure.folder = file.parent_path();
  return figure;
}

std::filesystem::path locate_figure(const std::string& argument) {
  std::error_code failure;
  if (std::filesystem::exists(argument, failure)) return argument;
  std::vector<std::string> names;
  for (const auto& file : list_bundled("figures", ".toml"))
    names.push_back(std::filesystem::path(file).stem().string());
  if (std::find(names.begin(), names.end(), argument) != names.end())
    return find_bundled("figures", argument + ".toml");
  throw InputError(fmt::format("there is no file '{}' and no bundled figure of that name{}", argument,
                               suggestion(argument, views_of(names))));
}

}  // namespace anvil
