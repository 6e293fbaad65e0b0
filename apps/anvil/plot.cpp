// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/core.h>

#include <filesystem>
#include <string>
#include <vector>

#include "anvil/core/error.hpp"
#include "anvil/figures/description.hpp"
#include "anvil/figures/drawing.hpp"
#include "anvil/figures/figure_builder.hpp"
#include "command_line.hpp"
#include "figure_file.hpp"
#include "frames.hpp"
#include "option_values.hpp"
#include "plotted_result.hpp"

namespace anvil {
namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

Usage make_usage() {
  Usage usage{
      "anvil plot RESULT [--figure FIGURE | --field F | --history H | --map F] [-o FILE] [options]",
      "Draws profiles, histories and maps over time of a result off-screen, as PNG or SVG by the name of FILE.\n"
      "RESULT is the folder of a result, its .pvd, or a single frame, of anvil or of another program.\n"
      "A figure description (docs/figures.md) says all of it; the other options make simple figures.",
      "RESULT"};
  auto add = usage.options.add_options();
  const auto text = [](const char* name) { return po::value<std::string>()->value_name(name); };
  const auto texts = [](const char* name) { return po::value<std::vector<std::string>>()->value_name(name); };
  add("output,o", texts("FILE"), "file to write, .png or .svg; can be repeated (default: <result>.png)");
  add("figure", text("FIGURE"), "description of the figure: a file, or the name of a bundled one");
  add("field", texts("F"), "profile of a field, such as stress.xx, or of an expression; a panel for each");
  add("history", texts("H"), "column of history.csv over time, such as kinetic_energy; all in one panel");
  add("map", texts("F"), "field over position and time (x-t diagram); a panel for each");
  add("times", text("T,T,..."), "times of the profiles in s (default: the last frame)");
  add("exact", po::bool_switch(), "the exact solution below the profiles");
  add("along", text("QUANTITY"),
      "what profiles are drawn along, as position.z or radius (default: initial_position.x)");
  add("where", text("CONDITION"), "only particles for which it holds, as \"abs(position.x) < 1e-3\"");
  add("line", text("A:B"), "profiles between the particles on a line from x,y,z to x,y,z (m)");
  add("reference", texts("FILE:X:Y"), "columns X and Y of a CSV file, in every panel of profiles; can be repeated");
  add("log", text("AXES"), "logarithmic axes: x, y or xy");
  add("unit", text("UNIT"), "unit of the fields, such as GPa (default: by their size)");
  add("title", text("TEXT"), "first line of the figure (default: the title of the scene)");
  add("also", texts("RESULT"), "a further result in the same panels; can be repeated");
  add("array", texts("ANVIL=FILE"),
      "the array of another program's file that stands for one of Anvil's, as velocity=Vel; can be repeated");
  return usage;
}

std::string text_of(const po::variables_map& values, const std::string& option) {
  return values.count(option) == 0 ? "" : values[option].as<std::string>();
}

std::vector<double> times_from(const po::variables_map& values) {
  return values.count("times") == 0 ? std::vector<double>{} : numbers_of("times", text_of(values, "times"), ',', 0);
}

std::vector<double> line_from(const po::variables_map& values) {
  if (values.count("line") == 0) return {};
  const auto [begin, end] = line_of("line", text_of(values, "line"));
  return {begin[0], begin[1], begin[2], end[0], end[1], end[2]};
}

/// The file lies where the command is given, not beside a description.
CurveDescription reference_from(const std::string& text) {
  const auto last = text.rfind(':');
  const auto first = last == std::string::npos || last == 0 ? last : text.rfind(':', last - 1);
  if (first == std::string::npos || first == 0)
    throw InputError(fmt::format("--reference takes FILE:X:Y, a CSV file and two of its columns, found '{}'", text));
  CurveDescription curve;
  curve.file = fs::absolute(text.substr(0, first)).string();
  curve.x_column = text.substr(first + 1, last - first - 1);
  curve.y_column = text.substr(last + 1);
  curve.label = fs::path(curve.file).stem().string();
  curve.style = "reference";
  return curve;
}

void set_logarithmic(FigureDescription& figure, const std::string& axes) {
  if (axes.find_first_not_of("xy") != std::string::npos)
    throw InputError(fmt::format("--log takes x, y or xy, found '{}'", axes));
  for (auto& panel : figure.panels) {
    panel.x.logarithmic = axes.find('x') != std::string::npos;
    panel.y.logarithmic = axes.find('y') != std::string::npos;
  }
}

/// The figure that the options describe.
FigureDescription describe(const po::variables_map& values) {
  FigureDescription figure;
  for (const auto& field : repeated(values, "field")) {
    PanelDescription& panel = figure.panels.emplace_back();
    panel.x.quantity = text_of(values, "along");
    panel.y.unit = text_of(values, "unit");
    CurveDescription& curve = panel.curves.emplace_back();
    curve.field = field;
    curve.times = times_from(values);
    curve.exact = values["exact"].as<bool>();
    curve.where = text_of(values, "where");
    curve.line = line_from(values);
    for (const auto& reference : repeated(values, "reference")) panel.curves.push_back(reference_from(reference));
  }
  const auto histories = repeated(values, "history");
  if (!histories.empty()) {
    PanelDescription& panel = figure.panels.emplace_back();
    panel.y.unit = text_of(values, "unit");
    for (const auto& history : histories) panel.curves.emplace_back().history = history;
  }
  for (const auto& field : repeated(values, "map")) {
    PanelDescription& panel = figure.panels.emplace_back();
    panel.x.quantity = text_of(values, "along");
    panel.map.emplace();
    panel.map->field = field;
    panel.map->unit = text_of(values, "unit");
  }
  set_logarithmic(figure, text_of(values, "log"));
  return figure;
}

FigureDescription description_from(const po::variables_map& values, const Usage& usage) {
  const bool described = values.count("figure") != 0;
  const bool simple = values.count("field") + values.count("history") + values.count("map") != 0;
  if (described == simple)
    throw InputError(
        fmt::format("say what to draw: either --figure, or --field, --history or --map; usage: {}", usage.synopsis));
  if (!described) return describe(values);
  for (const char* option : {"times", "along", "unit", "where", "line", "reference", "log"})
    if (values.count(option) != 0)
      throw InputError(fmt::format("--{} does not go with --figure: the description says it", option));
  return read_figure_description(locate_figure(values["figure"].as<std::string>()));
}

std::vector<PlottedResult> results_from(const po::variables_map& values, const Usage& usage) {
  const ArrayNames names = parse_array_names(repeated(values, "array"));
  std::vector<PlottedResult> results = {open_result(required(values, usage, "RESULT"), names)};
  for (const auto& folder : repeated(values, "also")) results.push_back(open_result(folder, names));
  return results;
}

/// plate.png beside the folder of the result.
fs::path default_picture(const fs::path& result) {
  return bare_name(result).string() + (ANVIL_WITH_VTK ? ".png" : ".svg");
}

}  // namespace

int execute_plot(const Arguments& arguments) {
  Usage usage = make_usage();
  const auto values = parse(usage, arguments);
  if (!values) return 0;
  const std::string folder = required(*values, usage, "RESULT");
  FigureDescription description = description_from(*values, usage);
  const auto results = results_from(*values, usage);
  if (values->count("title") != 0) description.title = (*values)["title"].as<std::string>();
  if (description.title.empty() && results.front().scene) description.title = results.front().scene->title;
  const Drawing drawing = lay_out(build_figure(description, results));
  auto files = repeated(*values, "output");
  if (files.empty()) files = {default_picture(folder).string()};
  for (const auto& file : files) {
    write_figure(drawing, file);
    fmt::print("{}\n", file);
  }
  return 0;
}

}  // namespace anvil
