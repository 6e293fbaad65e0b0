// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "anvil/study/measures.hpp"
#include "anvil/study/runner.hpp"

namespace anvil {
namespace {

void add_new(std::vector<std::string>& names, const std::string& name) {
  if (std::ranges::find(names, name) == names.end()) names.push_back(name);
}

/// Axes, measures and references of all grids, each once.
struct Columns {
  explicit Columns(const StudyDescription& study) {
    for (const auto& grid : study.grids) {
      for (const auto& axis : grid.axes) add_new(axes, axis.key);
      for (const auto& measure : grid.measures) add_new(measures, measure);
      for (const auto& reference : grid.references) add_new(references, reference.measure);
    }
  }
  std::vector<std::string> axes, measures, references;
};

std::string quoted(std::string text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2) text.insert(at, 1, '"');
  return '"' + text + '"';
}

/// Empty for what was not seen.
std::string number_text(double number) { return std::isfinite(number) ? fmt::format("{}", number) : ""; }

std::string heading(const Columns& columns) {
  std::string line = "grid,scene";
  for (const auto& axis : columns.axes) line += ',' + axis;
  line += ",time [s]";
  for (const auto& name : columns.measures) {
    const std::string_view unit = find_study_measure(name)->unit;
    line += unit.empty() ? ',' + name : fmt::format(",{} [{}]", name, unit);
  }
  for (const auto& name : columns.references) line += fmt::format(",{}_reference", name);
  return line + ",status,particles,neighbours,steps,particle_steps,wall_time [s],cpu_time [s],reason\n";
}

std::string axis_cell(const StudyGrid& grid, const StudyRun& run, const std::string& key) {
  for (std::size_t axis = 0; axis < grid.axes.size(); ++axis)
    if (grid.axes[axis].key == key) return quoted(run.axis_values[axis]);
  return "";
}

std::string measure_cell(const StudyGrid& grid, const StudyRow& row, const std::string& measure) {
  const auto found = std::ranges::find(grid.measures, measure) - grid.measures.begin();
  const auto place = static_cast<std::size_t>(found);
  return place < row.values.size() ? number_text(row.values[place]) : "";
}

std::string reference_cell(const StudyGrid& grid, const StudyRun& run, const std::string& measure) {
  for (const auto& reference : grid.references)
    if (reference.measure == measure)
      if (const auto value = reference.at(run.axis_values.back())) return number_text(*value);
  return "";
}

}  // namespace

std::string study_csv(const StudyDescription& study, const std::vector<StudyRun>& runs) {
  const Columns columns(study);
  std::string text = heading(columns);
  for (const auto& run : runs) {
    const StudyGrid& grid = study.grids[run.grid];
    // A run that failed before its first time has a line, too.
    const std::vector<StudyRow> nothing = {{std::nan(""), {}}};
    for (const auto& row : run.rows.empty() ? nothing : run.rows) {
      text += fmt::format("{},{}", run.grid + 1, quoted(std::filesystem::path(grid.scene).stem().string()));
      for (const auto& key : columns.axes) text += ',' + axis_cell(grid, run, key);
      text += ',' + number_text(row.time);
      for (const auto& measure : columns.measures) text += ',' + measure_cell(grid, row, measure);
      for (const auto& measure : columns.references) text += ',' + reference_cell(grid, run, measure);
      text += fmt::format(",{},{},{},{},{},{},{},{}\n", status_name(run.status), run.particles, run.neighbours,
                          run.steps, static_cast<std::int64_t>(run.particles) * run.steps, run.seconds, run.cpu_seconds,
                          quoted(run.reason));
    }
  }
  return text;
}

std::string_view status_name(StudyStatus status) {
  switch (status) {
    case StudyStatus::finished:
      return "finished";
    case StudyStatus::failed:
      return "failed";
    case StudyStatus::refused:
      break;
  }
  return "refused";
}

}  // namespace anvil
