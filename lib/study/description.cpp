// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/study/description.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "anvil/core/data_path.hpp"
#include "anvil/core/error.hpp"
#include "anvil/figures/csv_columns.hpp"
#include "anvil/scene/nearest_name.hpp"
#include "anvil/scene/text_file.hpp"
#include "anvil/scene/toml_text.hpp"
#include "anvil/scene/value_reader.hpp"
#include "anvil/study/measures.hpp"

namespace anvil {
namespace {

namespace fs = std::filesystem;

/// A value as it stands behind --set KEY=; words without quotes.
std::string override_text(const toml::node& node) {
  if (const auto text = node.value_exact<std::string>()) return *text;
  if (const auto number = node.value_exact<double>()) return fmt::format("{}", *number);
  std::ostringstream stream;
  node.visit([&](const auto& value) { stream << value; });
  return stream.str();
}

class StudyReader {
 public:
  StudyReader(ReadContext& context, fs::path folder) : context_(context), folder_(std::move(folder)) {}

  StudyDescription read(const toml::table& document) {
    StudyDescription study;
    const Key report{
        .name = "report", .kind = ValueKind::choice, .choices = {"table", "orders", "speeds", "cost", "stability"}};
    const auto named = read_as<std::string>(report, document, "");
    if (named)
      study.report = static_cast<StudyReport>(std::ranges::find(report.choices, *named) - report.choices.begin());
    study.title = read_as<std::string>({.name = "title", .kind = ValueKind::text}, document, "").value_or("");
    for_each_table(document, "grid", "", [&](const toml::table& table, const std::string& path) {
      study.grids.push_back(read_grid(table, path));
    });
    if (study.grids.empty() && !document.contains("grid"))
      context_.problems.add({context_.file}, "the study has no [[grid]]: at least one is needed");
    for (const auto& grid : study.grids) {
      check_report(study.report, grid, document);
      if (study.report == StudyReport::cost && grid.measures != study.grids.front().measures)
        add_problem(document, fmt::format("the grid '{}' must have the measures of the first one", grid.title));
    }
    check_known(document, {"title", "report", "grid"}, "");
    return study;
  }

 private:
  /// What the tables and the figure of a report are made of must be there.
  void check_report(StudyReport report, const StudyGrid& grid, const toml::table& document) {
    if (report == StudyReport::table) return;
    if (grid.axes.empty())
      add_problem(document, fmt::format("the grid '{}' needs an axis, over which the report goes", grid.title));
    if (report == StudyReport::stability && grid.axes.size() != 2)
      add_problem(document, fmt::format("the grid '{}' needs two axes for its report", grid.title));
    if (report == StudyReport::speeds && std::ranges::find(grid.measures, "lattice_factor") == grid.measures.end())
      add_problem(document, fmt::format("the grid '{}' needs the measure lattice_factor for its report", grid.title));
  }

  StudyGrid read_grid(const toml::table& table, const std::string& path) {
    StudyGrid grid;
    grid.scene = required<std::string>({.name = "scene", .kind = ValueKind::text}, table, path);
    grid.title = read_as<std::string>({.name = "title", .kind = ValueKind::text}, table, path).value_or(grid.scene);
    std::error_code failure;
    if (fs::is_regular_file(folder_ / grid.scene, failure)) grid.scene = (folder_ / grid.scene).string();
    grid.times = required<std::vector<double>>(
        {.name = "times", .kind = ValueKind::numbers, .unit = "s", .range = Range::positive}, table, path);
    if (!std::is_sorted(grid.times.begin(), grid.times.end()))
      add_problem(table, fmt::format("key '{}.times' must ascend", path));
    grid.set = read_texts(table, "set", path);
    grid.bound = read_as<double>({.name = "bound", .kind = ValueKind::number, .range = Range::positive}, table, path)
                     .value_or(grid.bound);
    grid.refine = read_as<double>({.name = "refine", .kind = ValueKind::number, .range = Range::positive}, table, path)
                      .value_or(grid.refine);
    grid.against_finest =
        read_as<std::string>({.name = "against", .kind = ValueKind::choice, .choices = {"reference", "finest"}}, table,
                             path) == "finest";
    grid.measures = read_texts(table, "measures", path);
    if (grid.measures.empty()) add_problem(table, fmt::format("'{}' lacks the key 'measures'", path));
    for (const auto& measure : grid.measures) check_measure(table, measure, path);
    for_each_table(table, "axis", path, [&](const toml::table& axis, const std::string& axis_path) {
      grid.axes.push_back(read_axis(axis, axis_path));
    });
    for_each_table(table, "reference", path, [&](const toml::table& reference, const std::string& reference_path) {
      grid.references.push_back(read_reference_table(reference, reference_path));
      if (grid.axes.empty()) add_problem(reference, fmt::format("'{}' needs an axis to run along", reference_path));
    });
    if (grid.against_finest && grid.axes.empty())
      add_problem(table, fmt::format("'{}' needs an axis, along which a run is the finest", path));
    check_known(
        table, {"title", "scene", "set", "times", "measures", "axis", "reference", "against", "bound", "refine"}, path);
    return grid;
  }

  StudyAxis read_axis(const toml::table& table, const std::string& path) {
    StudyAxis axis;
    axis.key = required<std::string>({.name = "key", .kind = ValueKind::text}, table, path);
    const toml::array* values = table["values"].as_array();
    if (values == nullptr || values->empty())
      add_problem(table, fmt::format("key '{}.values' must be a list of at least one value", path));
    else
      for (const toml::node& value : *values) axis.values.push_back(override_text(value));
    check_known(table, {"key", "values"}, path);
    return axis;
  }

  StudyReference read_reference_table(const toml::table& table, const std::string& path) {
    StudyReference reference;
    reference.measure = required<std::string>({.name = "measure", .kind = ValueKind::text}, table, path);
    reference.file = required<std::string>({.name = "file", .kind = ValueKind::text}, table, path);
    reference.column = required<std::string>({.name = "column", .kind = ValueKind::text}, table, path);
    check_known(table, {"measure", "file", "column"}, path);
    try {
      std::error_code failure;
      const fs::path beside = folder_ / reference.file;
      const auto columns =
          read_csv_columns(fs::exists(beside, failure) ? beside : find_bundled("reference", reference.file));
      reference.axis = columns.at(0).values;
      reference.values = column_of(columns, reference.column, reference.file).values;
    } catch (const InputError& error) {
      add_problem(table, error.what());
    }
    return reference;
  }

  void check_measure(const toml::table& table, const std::string& measure, const std::string& path) {
    if (find_study_measure(measure)) return;
    const auto names = study_measure_names();
    add_problem(table, fmt::format("key '{}.measures' names '{}', which nobody measures{}", path, measure,
                                   suggestion(measure, names)));
  }

  std::vector<std::string> read_texts(const toml::table& table, const std::string& name, const std::string& path) {
    std::vector<std::string> texts;
    const toml::node* node = table.get(name);
    if (node == nullptr) return texts;
    if (const toml::array* array = node->as_array(); array != nullptr && array->is_homogeneous<std::string>()) {
      for (const toml::node& element : *array) texts.push_back(*element.value<std::string>());
    } else {
      context_.problems.add(context_.place_of(*node), fmt::format("key '{}.{}' must be a list of texts", path, name));
    }
    return texts;
  }

  template <class T>
  std::optional<T> read_as(const Key& key, const toml::table& table, const std::string& path) {
    const toml::node* node = table.get(key.name);
    if (node == nullptr) return std::nullopt;
    const auto value =
        read_value(key, *node, path.empty() ? std::string(key.name) : fmt::format("{}.{}", path, key.name), context_);
    if (!value) return std::nullopt;
    return std::get<T>(*value);
  }

  template <class T>
  T required(const Key& key, const toml::table& table, const std::string& path) {
    if (!table.contains(key.name)) report_missing(key, table, path, context_);
    return read_as<T>(key, table, path).value_or(T{});
  }

  template <class Visitor>
  void for_each_table(const toml::table& parent, const std::string& name, const std::string& path, Visitor&& visit) {
    const toml::node* node = parent.get(name);
    if (node == nullptr) return;
    const std::string full = path.empty() ? name : fmt::format("{}.{}", path, name);
    const toml::array* tables = node->as_array();
    if (tables == nullptr || !std::ranges::all_of(*tables, [](const toml::node& one) { return one.is_table(); })) {
      context_.problems.add(context_.place_of(*node),
                            fmt::format("'{}' must be written as [[{}]]", full, path.empty() ? name : "grid." + name));
      return;
    }
    int number = 0;
    for (const toml::node& table : *tables) visit(*table.as_table(), fmt::format("{}.{}", full, ++number));
  }

  void check_known(const toml::table& table, const std::vector<std::string_view>& known, const std::string& path) {
    report_unknown(table, known, path, context_);
  }

  void add_problem(const toml::table& table, const std::string& sentence) {
    context_.problems.add(context_.place_of(table), sentence);
  }

  ReadContext& context_;
  fs::path folder_;
};

}  // namespace

std::optional<double> StudyReference::at(const std::string& axis_value) const {
  double wanted = 0.0;
  const char* const end = axis_value.data() + axis_value.size();
  if (std::from_chars(axis_value.data(), end, wanted).ptr != end) return std::nullopt;
  for (std::size_t row = 0; row < axis.size(); ++row)
    if (std::abs(axis[row] - wanted) <= 1e-9 * std::abs(wanted)) return values[row];
  return std::nullopt;
}

std::size_t StudyGrid::run_count() const {
  std::size_t count = 1;
  for (const auto& axis : axes) count *= axis.values.size();
  return count;
}

std::vector<std::string> StudyGrid::values_of(std::size_t run) const {
  std::vector<std::string> values(axes.size());
  for (std::size_t axis = axes.size(); axis-- > 0; run /= axes[axis].values.size())
    values[axis] = axes[axis].values[run % axes[axis].values.size()];
  return values;
}

StudyDescription read_study(const fs::path& file) {
  const toml::table document = parse_toml(read_text_file(file), file.string());
  ReadContext context;
  context.file = file.string();
  StudyDescription study = StudyReader(context, file.parent_path()).read(document);
  context.problems.throw_if_any();
  study.name = file.stem().string();
  if (study.title.empty()) study.title = study.name;
  return study;
}

fs::path locate_study(const std::string& argument) {
  std::error_code failure;
  if (fs::is_regular_file(argument, failure)) return argument;
  std::vector<std::string> names;
  for (const auto& file : list_bundled("studies", ".toml")) names.push_back(fs::path(file).stem().string());
  if (std::ranges::find(names, argument) != names.end()) return find_bundled("studies", argument + ".toml");
  throw InputError(fmt::format("there is no file '{}' and no bundled study of that name{}", argument,
                               suggestion(argument, views_of(names))));
}

}  // namespace anvil
