// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/study/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "anvil/study/cost.hpp"
#include "anvil/study/run_table.hpp"
#include "anvil/study/stability.hpp"

namespace anvil {
namespace {

std::string cell(double value, const char* format) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "-";
}

/// discretisation.smoothing_ratio is smoothing_ratio in headings.
std::string short_name(const std::string& key) { return key.substr(key.rfind('.') + 1); }

StudyTable plain_table(const RunTable& table) {
  const StudyGrid& grid = table.grid();
  StudyTable result;
  result.rows.emplace_back();
  for (const auto& axis : grid.axes) result.rows[0].push_back(short_name(axis.key));
  result.rows[0].emplace_back("time us");
  for (const auto& measure : grid.measures) result.rows[0].push_back(measure);
  result.rows[0].emplace_back("status");
  result.alignment = std::string(grid.axes.size(), 'l') + std::string(grid.measures.size() + 1, 'r') + 'l';
  for (const StudyRun* run : table.runs()) {
    for (const auto& row : run->rows) {
      auto& cells = result.rows.emplace_back(run->axis_values);
      cells.push_back(fmt::format("{:.4g}", 1e6 * row.time));
      for (const double value : row.values) cells.push_back(cell(value, "{:.4g}"));
      cells.emplace_back(status_name(run->status));
    }
    if (!run->rows.empty()) continue;
    auto& cells = result.rows.emplace_back(run->axis_values);
    cells.resize(cells.size() + 1 + grid.measures.size(), "-");
    cells.emplace_back(status_name(run->status));
  }
  return result;
}

StudyTable order_table(const RunTable& table) {
  const StudyGrid& grid = table.grid();
  StudyTable result;
  auto& heading = result.rows.emplace_back();
  for (const auto& axis : grid.axes) heading.push_back(short_name(axis.key));
  heading.emplace_back("particles");
  for (const double time : grid.times) {
    heading.push_back(fmt::format("{:.4g} us", 1e6 * time));
    heading.emplace_back("order");
  }
  result.alignment = std::string(grid.axes.size(), 'l') + std::string(1 + 2 * grid.times.size(), 'r');
  const std::size_t length = grid.axes.back().values.size();
  for (std::size_t k = 0; k < table.runs().size(); ++k) {
    auto cells = table.run(k).axis_values;
    cells.push_back(fmt::format("{}", table.run(k).particles));
    for (std::size_t time = 0; time < grid.times.size(); ++time) {
      cells.push_back(cell(table.value(k, time, 0), "{:.5f}"));
      cells.push_back(k % length == 0 ? "" : cell(table.order(k, time), "{:.2f}"));
    }
    result.rows.push_back(std::move(cells));
  }
  return result;
}

StudyTable speed_table(const RunTable& table, const StudyReference& reference) {
  const std::size_t alpha = table.measure_number("lattice_factor");
  const std::size_t speed = table.measure_number(reference.measure);
  const std::size_t last = table.grid().times.size() - 1;
  StudyTable result;
  result.title = short_name(reference.measure);
  result.rows.push_back(
      {short_name(table.grid().axes.back().key), "paper", "alpha", "measured", "less alpha", "less paper", "status"});
  result.alignment = "lrrrrrl";
  for (std::size_t k = 0; k < table.runs().size(); ++k) {
    const StudyRun& run = table.run(k);
    const double paper = reference.at(run.axis_values.back()).value_or(std::nan(""));
    const double expected = table.value(k, last, alpha);
    const double measured = table.value(k, last, speed);
    result.rows.push_back({run.axis_values.back(), cell(paper, "{:.3f}"), cell(expected, "{:.4f}"),
                           cell(measured, "{:.4f}"), cell(measured - expected, "{:+.4f}"),
                           cell(measured - paper, "{:+.4f}"), std::string(status_name(run.status))});
  }
  return result;
}

}  // namespace

std::vector<StudyTable> study_tables(const StudyDescription& study, const std::vector<StudyRun>& runs) {
  if (study.report == StudyReport::cost) return cost_tables(study, runs);
  if (study.report == StudyReport::stability) return stability_tables(study, runs);
  std::vector<StudyTable> tables;
  for (std::size_t number = 0; number < study.grids.size(); ++number) {
    const RunTable table(study, runs, number);
    const std::size_t first = tables.size();
    if (study.report == StudyReport::table) tables.push_back(plain_table(table));
    if (study.report == StudyReport::orders) tables.push_back(order_table(table));
    if (study.report == StudyReport::speeds)
      for (const auto& reference : table.grid().references) tables.push_back(speed_table(table, reference));
    for (std::size_t k = first; k < tables.size(); ++k)
      tables[k].title = table.grid().title + (tables[k].title.empty() ? "" : ", " + tables[k].title);
  }
  return tables;
}

}  // namespace anvil
