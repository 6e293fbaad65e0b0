// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/study/cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "anvil/figures/color_scale.hpp"
#include "anvil/study/axis_labels.hpp"

namespace anvil {
namespace {

std::optional<double> number_in(const std::string& text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  if (std::from_chars(text.data(), end, number).ptr != end) return std::nullopt;
  return number;
}

bool ends_in_spacing(const StudyGrid& grid) { return grid.axes.back().key == "discretisation.spacing"; }

std::string point_name(const StudyGrid& grid, const StudyRun& run) {
  const auto number = number_in(run.axis_values.back());
  return ends_in_spacing(grid) && number ? fmt::format("{:.4g} mm", 1e3 * *number) : run.axis_values.back();
}

/// The title of the grid, where there are several, and the values of all axes but the last.
std::string curve_name(const StudyDescription& study, const StudyRun& run) {
  std::vector<std::string> parts(run.axis_values.begin(), run.axis_values.end() - 1);
  if (study.grids.size() > 1 || parts.empty()) parts.insert(parts.begin(), study.grids[run.grid].title);
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::optional<std::vector<double>> mean_errors(const StudyGrid& grid, const StudyRun& run) {
  std::vector<double> errors(grid.measures.size(), 0.0);
  for (const auto& row : run.rows)
    for (std::size_t m = 0; m < errors.size(); ++m)
      errors[m] += std::abs(row.values[m]) / static_cast<double>(run.rows.size());
  // Zero cannot stand on a logarithmic axis; beyond one a run has little to do with its reference.
  if (!std::ranges::all_of(errors, [](double error) { return error > 0.0 && error <= 1.0; })) return std::nullopt;
  return errors;
}

using Pick = double (*)(const CostPoint&);
double seconds_of(const CostPoint& point) { return point.seconds; }
double particle_steps_of(const CostPoint& point) { return point.particle_steps; }

std::vector<bool> front_of(const std::vector<CostPoint>& points, Pick cost, std::size_t measure) {
  std::vector<double> costs, errors;
  for (const auto& point : points) {
    costs.push_back(cost(point));
    errors.push_back(point.kept_errors[measure]);
  }
  return pareto_front(costs, errors);
}

std::string short_name(const std::string& key) { return key.substr(key.rfind('.') + 1); }

StudyTable point_table(const StudyDescription& study, const std::vector<StudyRun>& runs,
                       const std::vector<CostPoint>& points) {
  const auto& measures = study.grids.front().measures;
  StudyTable table;
  table.title =
      "accuracy and cost; nothing is both cheaper and better than what has a * (an error counts for no less than those "
      "of "
      "finer runs)";
  table.rows = {{"settings", short_name(study.grids.front().axes.back().key), "particles", "neighbours", "steps",
                 "particle-steps", "CPU s"}};
  table.alignment = "llrrrrr" + std::string(measures.size(), 'l');
  std::vector<std::vector<bool>> fronts;
  for (std::size_t m = 0; m < measures.size(); ++m) {
    table.rows[0].push_back(measures[m]);
    fronts.push_back(front_of(points, seconds_of, m));
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    const StudyRun& run = runs[points[k].run];
    auto& cells = table.rows.emplace_back(std::vector<std::string>{
        points[k].curve, points[k].name, fmt::format("{}", run.particles), fmt::format("{:.1f}", run.neighbours),
        fmt::format("{}", run.steps), fmt::format("{:.3g}", points[k].particle_steps),
        fmt::format("{:.3g}", run.cpu_seconds)});
    for (std::size_t m = 0; m < measures.size(); ++m)
      cells.push_back(fmt::format("{:.5f}{}", points[k].errors[m], fronts[m][k] ? " *" : ""));
  }
  return table;
}

StudyTable cheapest_table(const StudyDescription& study, const std::vector<CostPoint>& points, std::size_t measure) {
  constexpr std::array levels = {0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001};
  StudyTable table;
  table.title = fmt::format("the cheapest that reaches an error, {}", study.grids.front().measures[measure]);
  table.rows = {
      {"error below", "settings", short_name(study.grids.front().axes.back().key), "error", "CPU s", "particle-steps"}};
  table.alignment = "rllrrr";
  for (const double level : levels) {
    const CostPoint* best = nullptr;
    for (const auto& point : points)
      if (point.kept_errors[measure] <= level && (best == nullptr || point.seconds < best->seconds)) best = &point;
    if (best == nullptr) {
      table.rows.push_back({fmt::format("{:g} %", 100.0 * level), "none of these", "-", "-", "-", "-"});
      break;
    }
    table.rows.push_back({fmt::format("{:g} %", 100.0 * level), best->curve, best->name,
                          fmt::format("{:.3g} %", 100.0 * best->kept_errors[measure]),
                          fmt::format("{:.3g}", best->seconds), fmt::format("{:.3g}", best->particle_steps)});
  }
  return table;
}

/// The points of each curve, in the order in which curves come first.
struct CurvePoints {
  std::string name;
  std::vector<const CostPoint*> points;
};

std::vector<CurvePoints> curves_of(const std::vector<CostPoint>& points) {
  std::vector<CurvePoints> curves;
  for (const auto& point : points) {
    auto found = std::ranges::find(curves, point.curve, &CurvePoints::name);
    if (found == curves.end()) found = curves.insert(curves.end(), {point.curve, {}});
    found->points.push_back(&point);
  }
  return curves;
}

/// Curves beyond the last colour take the first ones again, darker.
Color distinct_color(std::size_t number) {
  constexpr std::size_t colors = 7;  // of curve_color
  const auto [red, green, blue] = curve_color(number);
  const auto dark = [&](unsigned char part) { return number < colors ? part : static_cast<unsigned char>(part / 2); };
  return {dark(red), dark(green), dark(blue)};
}

/// Leaves room around the points, on the right and above for their names.
void widen(Axis& axis, const std::vector<PlottedCurve>& curves, std::vector<double> PlottedCurve::*values) {
  double least = std::numeric_limits<double>::max(), greatest = 0.0;
  for (const auto& curve : curves)
    for (const double value : curve.*values) {
      least = std::min(least, value);
      greatest = std::max(greatest, value);
    }
  const double margin = std::pow(greatest / least, 0.04);
  axis.range = {least / margin, greatest * margin * margin * margin};
}

void widen(Panel& panel) {
  widen(panel.x, panel.curves, &PlottedCurve::x);
  widen(panel.y, panel.curves, &PlottedCurve::y);
}

/// A line and its points; the label goes to the line.
void add_curve(Panel& panel, PlottedCurve line) {
  PlottedCurve points = line;
  points.label.clear();
  points.style = CurveStyle::points;
  panel.curves.push_back(std::move(line));
  panel.curves.push_back(std::move(points));
}

void add_front(Panel& panel, const std::vector<CostPoint>& points, Pick cost, std::size_t measure) {
  const auto front = front_of(points, cost, measure);
  std::vector<const CostPoint*> best;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (front[k]) best.push_back(&points[k]);
  std::ranges::sort(best, {}, [&](const CostPoint* point) { return cost(*point); });
  PlottedCurve curve{.label = "Pareto front", .style = CurveStyle::reference, .color = {}, .x = {}, .y = {}};
  for (const auto* point : best) {
    curve.x.push_back(cost(*point));
    curve.y.push_back(point->kept_errors[measure]);
    curve.point_labels.push_back(point->name);
  }
  panel.curves.push_back(std::move(curve));
}

Panel cost_panel(const StudyDescription& study, const std::vector<CostPoint>& points, Pick cost,
                 const std::string& label, std::size_t measure) {
  Panel panel;
  panel.x = {.label = label, .logarithmic = true, .range = {}};
  panel.y = {.label = measure_label(study.grids.front().measures[measure]), .logarithmic = true, .range = {}};
  std::size_t color = 0;
  for (const auto& [name, members] : curves_of(points)) {
    PlottedCurve curve{.label = name, .style = CurveStyle::line, .color = distinct_color(color++), .x = {}, .y = {}};
    for (const auto* point : members) {
      curve.x.push_back(cost(*point));
      curve.y.push_back(point->errors[measure]);
    }
    add_curve(panel, std::move(curve));
  }
  add_front(panel, points, cost, measure);
  widen(panel);
  return panel;
}

/// Slope of the least-squares line through the logarithms; NaN for less than two points.
double fitted_order(const std::vector<double>& x, const std::vector<double>& y) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  const auto n = static_cast<double>(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double a = std::log(x[k]), b = std::log(y[k]);
    sx += a;
    sy += b;
    sxx += a * a;
    sxy += a * b;
  }
  return x.size() < 2 ? std::nan("") : (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace

std::vector<CostPoint> cost_points(const StudyDescription& study, const std::vector<StudyRun>& runs) {
  std::vector<CostPoint> points;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const StudyRun& run = runs[k];
    if (run.status != StudyStatus::finished || run.rows.empty()) continue;
    const StudyGrid& grid = study.grids[run.grid];
    if (auto errors = mean_errors(grid, run))
      points.push_back({k, curve_name(study, run), point_name(grid, run), *errors, *errors, run.cpu_seconds,
                        static_cast<double>(run.particles) * static_cast<double>(run.steps)});
  }
  for (auto& point : points)
    for (const auto& dearer : points)
      if (dearer.curve == point.curve && dearer.particle_steps > point.particle_steps)
        for (std::size_t m = 0; m < point.errors.size(); ++m)
          point.kept_errors[m] = std::max(point.kept_errors[m], dearer.errors[m]);
  return points;
}

std::vector<bool> pareto_front(std::span<const double> cost, std::span<const double> error) {
  constexpr double as_accurate = 1.001;  // a quarter model differs from the whole by rounding
  std::vector<bool> front(cost.size(), true);
  for (std::size_t a = 0; a < cost.size(); ++a)
    for (std::size_t b = 0; b < cost.size(); ++b)
      if (cost[b] <= cost[a] && error[b] <= as_accurate * error[a] && (cost[b] < cost[a] || error[b] < error[a]))
        front[a] = false;
  return front;
}

std::vector<StudyTable> cost_tables(const StudyDescription& study, const std::vector<StudyRun>& runs) {
  const auto points = cost_points(study, runs);
  std::vector<StudyTable> tables = {point_table(study, runs, points)};
  for (std::size_t m = 0; m < study.grids.front().measures.size(); ++m)
    tables.push_back(cheapest_table(study, points, m));
  return tables;
}

Figure cost_figure(const StudyDescription& study, const std::vector<StudyRun>& runs) {
  const auto points = cost_points(study, runs);
  const std::size_t measures = study.grids.front().measures.size();
  Figure figure;
  figure.title = study.title;
  figure.columns = 2;
  for (std::size_t m = 0; m < measures; ++m) {
    figure.panels.push_back(cost_panel(study, points, seconds_of, "CPU time of one thread [s]", m));
    figure.panels.push_back(cost_panel(study, points, particle_steps_of, "Particles × steps", m));
  }
  figure.size = {2200, 100 + 850 * static_cast<int>(measures)};
  return figure;
}

Figure convergence_figure(const StudyDescription& study, const std::vector<StudyRun>& runs) {
  const auto points = cost_points(study, runs);
  const auto& measures = study.grids.front().measures;
  Figure figure;
  figure.title = study.title;
  figure.columns = 1;
  for (std::size_t m = 0; m < measures.size(); ++m) {
    Panel& panel = figure.panels.emplace_back();
    panel.x = {
        .label = ends_in_spacing(study.grids.front()) ? "Spacing [mm]" : key_label(study.grids.front().axes.back().key),
        .logarithmic = true,
        .range = {}};
    panel.y = {.label = measure_label(measures[m]), .logarithmic = true, .range = {}};
    std::size_t color = 0;
    for (const auto& [name, members] : curves_of(points)) {
      PlottedCurve curve{.label = {}, .style = CurveStyle::line, .color = distinct_color(color++), .x = {}, .y = {}};
      for (const auto* point : members) {
        const StudyRun& run = runs[point->run];
        const auto number = number_in(run.axis_values.back());
        if (!number) continue;
        curve.x.push_back(ends_in_spacing(study.grids[run.grid]) ? 1e3 * *number : *number);
        curve.y.push_back(point->errors[m]);
      }
      const double order = fitted_order(curve.x, curve.y);
      curve.label = std::isfinite(order) ? fmt::format("{} (order {:.2f})", name, order) : name;
      add_curve(panel, std::move(curve));
    }
    widen(panel);
  }
  figure.size = {1600, 100 + 1000 * static_cast<int>(measures.size())};
  return figure;
}

}  // namespace anvil
