// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "anvil/figures/color_scale.hpp"
#include "anvil/study/axis_labels.hpp"
#include "anvil/study/cost.hpp"
#include "anvil/study/report.hpp"
#include "anvil/study/run_table.hpp"
#include "anvil/study/stability.hpp"

namespace anvil {
namespace {

double mean_over_times(const RunTable& table, std::size_t run) {
  double sum = 0.0;
  for (std::size_t time = 0; time < table.grid().times.size(); ++time) sum += table.value(run, time, 0);
  return sum / static_cast<double>(table.grid().times.size());
}

/// The values of all axes but the last, which tell the curves of a panel apart.
std::string curve_label(const StudyRun& run) {
  return fmt::format("{}", fmt::join(run.axis_values.begin(), run.axis_values.end() - 1, ", "));
}

Panel order_panel(const RunTable& table) {
  Panel panel;
  panel.x = {.label = key_label(table.grid().axes.back().key), .logarithmic = true, .range = {}};
  panel.y = {.label = measure_label(table.grid().measures.front()), .logarithmic = true, .range = {}};
  const std::size_t length = table.grid().axes.back().values.size();
  for (std::size_t first = 0; first < table.runs().size(); first += length) {
    PlottedCurve line{.label = curve_label(table.run(first)),
                      .style = CurveStyle::line,
                      .color = curve_color(first / length),
                      .x = {},
                      .y = {}};
    for (std::size_t k = first; k < first + length; ++k) {
      line.x.push_back(table.last_axis(k));
      line.y.push_back(mean_over_times(table, k));
    }
    PlottedCurve points = line;
    points.label.clear();
    points.style = CurveStyle::points;
    panel.curves.push_back(std::move(line));
    panel.curves.push_back(std::move(points));
  }
  return panel;
}

PlottedCurve speed_curve(const RunTable& table, const std::string& measure, CurveStyle style, std::size_t color) {
  PlottedCurve curve{.label = measure_label(measure), .style = style, .color = curve_color(color), .x = {}, .y = {}};
  for (std::size_t k = 0; k < table.runs().size(); ++k) {
    curve.x.push_back(table.last_axis(k));
    curve.y.push_back(table.value(k, table.grid().times.size() - 1, table.measure_number(measure)));
  }
  return curve;
}

Panel speed_panel(const RunTable& table) {
  Panel panel;
  panel.x.label = key_label(table.grid().axes.back().key);
  panel.y.label = "Speed / speed of the material";
  panel.curves.push_back(speed_curve(table, "lattice_factor", CurveStyle::reference, 0));
  std::size_t color = 0;
  for (const auto& reference : table.grid().references)
    panel.curves.push_back(speed_curve(table, reference.measure, CurveStyle::points, color++));
  return panel;
}

}  // namespace

std::vector<StudyFigure> study_figures(const StudyDescription& study, const std::vector<StudyRun>& runs) {
  if (study.report == StudyReport::table) return {};
  if (study.report == StudyReport::cost) {
    if (cost_points(study, runs).empty()) return {};
    return {{"", cost_figure(study, runs)}, {"_convergence", convergence_figure(study, runs)}};
  }
  if (study.report == StudyReport::stability) return stability_figures(study, runs);
  Figure figure;
  figure.title = study.title;
  figure.columns = std::min<int>(3, static_cast<int>(study.grids.size()));
  for (std::size_t number = 0; number < study.grids.size(); ++number) {
    const RunTable table(study, runs, number);
    figure.panels.push_back(study.report == StudyReport::orders ? order_panel(table) : speed_panel(table));
    figure.panels.back().title = table.grid().title;
  }
  const int rows = (static_cast<int>(figure.panels.size()) + figure.columns - 1) / figure.columns;
  figure.size = {800 * figure.columns, 100 + 650 * rows};
  return {{"", std::move(figure)}};
}

}  // namespace anvil
