// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/study/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "anvil/kernels/lattice_sum.hpp"
#include "anvil/study/axis_labels.hpp"
#include "anvil/study/run_table.hpp"

namespace anvil {
namespace {

struct OutcomeRow {
  std::string_view name;
  Color color;
};
constexpr std::array<OutcomeRow, outcome_count> outcomes = {{{"stable", {0, 158, 115}},
                                                             {"inaccurate", {240, 228, 66}},
                                                             {"energy growth", {230, 159, 0}},
                                                             {"clumping", {204, 121, 167}},
                                                             {"penetration", {0, 114, 178}},
                                                             {"step collapse", {213, 94, 0}},
                                                             {"not a number", {40, 40, 40}},
                                                             {"turned inside out", {110, 64, 150}},
                                                             {"refused", {200, 200, 200}}}};

/// A number, or the length of a vector such as [0.0, 0.0, -227.0].
std::optional<double> number_in(const std::string& text) {
  const bool vector = text.starts_with('[');
  double sum = 0.0;
  const char* const end = text.data() + text.size() - (vector ? 1 : 0);
  for (const char* place = text.data() + (vector ? 1 : 0);; ++place) {
    while (place != end && *place == ' ') ++place;
    double number = 0.0;
    const auto [next, error] = std::from_chars(place, end, number);
    if (error != std::errc()) return std::nullopt;
    if (!vector) return next == end ? std::optional(number) : std::nullopt;
    sum += number * number;
    place = next;
    while (place != end && *place == ' ') ++place;
    if (place == end) return std::sqrt(sum);
    if (*place != ',') return std::nullopt;
  }
}

bool is_numeric(const StudyAxis& axis) {
  return std::ranges::all_of(axis.values, [](const auto& value) { return number_in(value).has_value(); });
}

/// NaN where the grid does not measure it, or the run did not come so far.
double last_value(const StudyGrid& grid, const StudyRun& run, std::string_view measure) {
  const auto place = static_cast<std::size_t>(std::ranges::find(grid.measures, measure) - grid.measures.begin());
  if (run.rows.size() < grid.times.size() || place == grid.measures.size()) return std::nan("");
  return run.rows.back().values[place];
}

/// What the guards of the solver say (lib/solver/guards.cpp).
Outcome outcome_of_failure(const std::string& reason) {
  const auto says = [&](const char* words) { return reason.find(words) != std::string::npos; };
  if (!reason.starts_with("step ")) return Outcome::refused;  // no guard: what is measured cannot be had
  if (says("beyond the boundary")) return Outcome::penetration;
  if (says("minimum_step_fraction")) return Outcome::step_collapse;
  if (says("inside out")) return Outcome::inversion;
  return Outcome::not_a_number;
}

std::string short_name(const std::string& key) { return key.substr(key.rfind('.') + 1); }

/// The axis of that key, or the number of axes.
std::size_t axis_of(const StudyGrid& grid, std::string_view key) {
  return static_cast<std::size_t>(std::ranges::find(grid.axes, key, &StudyAxis::key) - grid.axes.begin());
}

/// Through the runs of the least and greatest values of the other axis.
std::optional<PlottedCurve> analytic_curve(const RunTable& table) {
  const StudyGrid& grid = table.grid();
  const std::size_t cfl = axis_of(grid, "time.cfl");
  if (cfl == grid.axes.size()) return std::nullopt;
  PlottedCurve curve{.label = "von Neumann limit", .style = CurveStyle::line, .color = {0, 0, 0}, .x = {}, .y = {}};
  const std::size_t other = 1 - cfl;
  for (const StudyRun* run : table.runs()) {
    if (!run->scene || run->axis_values[cfl] != grid.axes[cfl].values.front()) continue;
    const double limit = analytic_cfl(*run->scene);
    const double place = *number_in(run->axis_values[other]);
    curve.x.push_back(cfl == 1 ? limit : place);
    curve.y.push_back(cfl == 1 ? place : limit);
  }
  if (curve.x.empty() || !std::isfinite(curve.x[0]) || !std::isfinite(curve.y[0])) return std::nullopt;
  return curve;
}

std::vector<double> numbers_of(const StudyAxis& axis) {
  std::vector<double> values;
  for (const auto& text : axis.values) values.push_back(*number_in(text));
  return values;
}

/// Where an axis begins and its step: those of its values where they are evenly spaced, else of their numbers.
struct EvenAxis {
  double begin = 0.0, step = 1.0;
  bool even = false;
};
EvenAxis even_axis(const std::vector<double>& values) {
  constexpr double same = 1e-6;
  if (values.size() < 2) return {values[0], 1.0, true};
  const double step = values[1] - values[0];
  for (std::size_t k = 1; k < values.size(); ++k)
    if (std::abs(values[k] - values[k - 1] - step) > same * std::abs(step) || step <= 0.0) return {};
  return {values[0], step, true};
}

/// Logarithmic where the values are positive and not evenly spaced, with some room at both ends.
Axis axis_for(const StudyAxis& axis) {
  const std::vector<double> values = numbers_of(axis);
  const auto [least, greatest] = std::ranges::minmax(values);
  const bool logarithmic = least > 0.0 && !even_axis(values).even;
  const double share = 0.6 / std::max<double>(1.0, static_cast<double>(values.size()) - 1.0);
  if (logarithmic) {
    const double margin = std::pow(greatest / least, share);
    return {.label = key_label(axis.key), .logarithmic = true, .range = {{least / margin, greatest * margin}}};
  }
  const double margin = share * (greatest - least);
  return {.label = key_label(axis.key), .logarithmic = false, .range = {{least - margin, greatest + margin}}};
}

Panel stability_panel(const RunTable& table) {
  const StudyGrid& grid = table.grid();
  Panel panel;
  panel.title = grid.title;
  panel.x = axis_for(grid.axes[1]);
  panel.y = axis_for(grid.axes[0]);
  for (int kind = 0; kind < outcome_count; ++kind) {
    const auto& [name, color] = outcomes[static_cast<std::size_t>(kind)];
    PlottedCurve dots{
        .label = std::string(name), .style = CurveStyle::points, .color = color, .x = {}, .y = {}, .point_size = 3.5};
    for (const StudyRun* run : table.runs())
      if (outcome_of(grid, *run) == static_cast<Outcome>(kind)) {
        dots.x.push_back(*number_in(run->axis_values[1]));
        dots.y.push_back(*number_in(run->axis_values[0]));
      }
    if (!dots.x.empty()) panel.curves.push_back(std::move(dots));
  }
  if (auto curve = analytic_curve(table)) panel.curves.push_back(std::move(*curve));
  return panel;
}

/// The outcome of one run of a grid with a value of its last axis that the grid does not have.
Outcome outcome_at(const StudyGrid& grid, const std::string& first, double last, const std::vector<std::string>& set) {
  StudyDescription once;
  once.grids = {grid};
  once.grids[0].axes[0].values = {first};
  once.grids[0].axes[1].values = {fmt::format("{}", last)};
  auto runs = prepare_study(once, set);
  run_study(once, runs, 1, [](const StudyPosition&) {});
  return outcome_of(grid, runs[0]);
}

StabilityLimit find_limit(const RunTable& table, std::size_t row, const std::vector<std::string>& set) {
  const StudyGrid& grid = table.grid();
  const std::size_t columns = grid.axes[1].values.size();
  StabilityLimit limit;
  limit.first = grid.axes[0].values[row];
  limit.largest = std::nan("");
  limit.analytic = std::nan("");
  double unstable = std::nan("");
  for (std::size_t column = 0; column < columns && !std::isfinite(unstable); ++column) {
    const StudyRun& run = table.run(row * columns + column);
    if (run.scene && grid.axes[1].key == "time.cfl") limit.analytic = analytic_cfl(*run.scene);
    (outcome_of(grid, run) == Outcome::stable ? limit.largest : unstable) = *number_in(run.axis_values[1]);
  }
  limit.beyond = !std::isfinite(unstable);
  if (limit.beyond || !std::isfinite(limit.largest)) return limit;
  while (unstable - limit.largest > grid.refine * limit.largest) {
    const double middle = 0.5 * (unstable + limit.largest);
    (outcome_at(grid, limit.first, middle, set) == Outcome::stable ? limit.largest : unstable) = middle;
  }
  return limit;
}

}  // namespace

std::string_view outcome_name(Outcome outcome) { return outcomes[static_cast<std::size_t>(outcome)].name; }

Outcome outcome_of(const StudyGrid& grid, const StudyRun& run) {
  constexpr double largest_imbalance = 0.25;  // forms that do not conserve energy are off by 10 % at any time step
  constexpr double smallest_distance = 0.02;
  if (run.status == StudyStatus::refused) return Outcome::refused;
  if (run.status == StudyStatus::failed) return outcome_of_failure(run.reason);
  const double error = last_value(grid, run, grid.measures.front());
  if (!std::isfinite(error)) return Outcome::not_a_number;
  if (std::abs(last_value(grid, run, "energy_balance")) > largest_imbalance) return Outcome::energy_growth;
  if (last_value(grid, run, "minimum_pair_distance") < smallest_distance) return Outcome::clumping;
  return std::abs(error) > grid.bound ? Outcome::inaccurate : Outcome::stable;
}

double analytic_cfl(const Scene& scene) {
  const Discretisation& how = scene.discretisation;
  if (how.method == "total_lagrangian") return std::nan("");
  return largest_stable_cfl(make_kernel(how.kernel), scene.domain.dimension, how.smoothing_ratio, how.method != "sph");
}

std::vector<StudyTable> stability_tables(const StudyDescription& study, const std::vector<StudyRun>& runs) {
  std::vector<StudyTable> tables;
  for (std::size_t number = 0; number < study.grids.size(); ++number) {
    const RunTable table(study, runs, number);
    const auto& axes = table.grid().axes;
    StudyTable& result = tables.emplace_back();
    result.title = table.grid().title;
    auto& heading = result.rows.emplace_back();
    heading.push_back(fmt::format("{} \\ {}", short_name(axes[0].key), short_name(axes[1].key)));
    heading.insert(heading.end(), axes[1].values.begin(), axes[1].values.end());
    result.alignment = std::string(1 + axes[1].values.size(), 'l');
    for (std::size_t k = 0; k < table.runs().size(); ++k) {
      if (k % axes[1].values.size() == 0) result.rows.push_back({table.run(k).axis_values[0]});
      result.rows.back().emplace_back(outcome_name(outcome_of(table.grid(), table.run(k))));
    }
  }
  return tables;
}

std::vector<StudyFigure> stability_figures(const StudyDescription& study, const std::vector<StudyRun>& runs) {
  Figure figure;
  figure.title = study.title;
  for (std::size_t number = 0; number < study.grids.size(); ++number) {
    const RunTable table(study, runs, number);
    if (is_numeric(table.grid().axes[0]) && is_numeric(table.grid().axes[1]))
      figure.panels.push_back(stability_panel(table));
  }
  if (figure.panels.empty()) return {};
  const int count = static_cast<int>(figure.panels.size());
  figure.columns = std::min(2, count);
  figure.size = {1100 * figure.columns, 100 + 900 * ((count + figure.columns - 1) / figure.columns)};
  return {{"", std::move(figure)}};
}

std::string stability_csv(const StudyDescription& study, const std::vector<StudyRun>& runs) {
  std::string text = "grid,first_axis,first,second_axis,second,outcome,error,reason\n";
  for (const auto& run : runs) {
    const StudyGrid& grid = study.grids[run.grid];
    std::string reason = run.reason;
    std::ranges::replace(reason, '"', '\'');
    const double error = last_value(grid, run, grid.measures.front());
    text += fmt::format("{},{},\"{}\",{},\"{}\",{},{},\"{}\"\n", run.grid + 1, grid.axes[0].key, run.axis_values[0],
                        grid.axes[1].key, run.axis_values[1], outcome_name(outcome_of(grid, run)),
                        std::isfinite(error) ? fmt::format("{}", error) : "", reason);
  }
  return text;
}

std::optional<StabilityMap> stability_map(const StudyDescription& study, const std::vector<StudyRun>& runs,
                                          std::size_t grid) {
  const RunTable table(study, runs, grid);
  const auto& axes = table.grid().axes;
  if (!is_numeric(axes[0]) || !is_numeric(axes[1])) return std::nullopt;
  const EvenAxis across = even_axis(numbers_of(axes[1])), up = even_axis(numbers_of(axes[0]));
  StabilityMap map;
  map.grid.origin = {across.begin, up.begin, 0.0};
  map.grid.step = {across.step, up.step};
  map.grid.nodes = {static_cast<int>(axes[1].values.size()), static_cast<int>(axes[0].values.size())};
  map.frame.scene = table.grid().scene;
  map.frame.positions = points_of(map.grid);
  map.frame.arrays = {{"outcome", "", 1, true, {}},
                      {table.grid().measures.front(), "", 1, false, {}},
                      {short_name(axes[0].key), "", 1, false, {}},
                      {short_name(axes[1].key), "", 1, false, {}}};
  for (const StudyRun* run : table.runs()) {
    map.frame.arrays[0].values.push_back(static_cast<double>(outcome_of(table.grid(), *run)));
    map.frame.arrays[1].values.push_back(last_value(table.grid(), *run, table.grid().measures.front()));
    map.frame.arrays[2].values.push_back(*number_in(run->axis_values[0]));
    map.frame.arrays[3].values.push_back(*number_in(run->axis_values[1]));
  }
  return map;
}

std::vector<StabilityLimit> find_stability_limits(const StudyDescription& study, const std::vector<StudyRun>& runs,
                                                  const std::vector<std::string>& set) {
  std::vector<StabilityLimit> limits;
  for (std::size_t number = 0; number < study.grids.size(); ++number) {
    if (study.grids[number].refine == 0.0 || !is_numeric(study.grids[number].axes[1])) continue;
    const RunTable table(study, runs, number);
    for (std::size_t row = 0; row < study.grids[number].axes[0].values.size(); ++row) {
      limits.push_back(find_limit(table, row, set));
      limits.back().grid = number;
    }
  }
  return limits;
}

StudyTable limit_table(const StudyDescription& study, const std::vector<StabilityLimit>& limits) {
  StudyTable table;
  table.title = "largest stable value of the last axis";
  table.rows = {{"grid", "settings", "axis", "largest stable", "von Neumann"}};
  table.alignment = "lllrr";
  for (const auto& limit : limits)
    table.rows.push_back(
        {study.grids[limit.grid].title, limit.first, short_name(study.grids[limit.grid].axes[1].key),
         std::isfinite(limit.largest) ? fmt::format("{}{:.3g}", limit.beyond ? "above " : "", limit.largest) : "none",
         std::isfinite(limit.analytic) ? fmt::format("{:.3g}", limit.analytic) : "-"});
  return table;
}

}  // namespace anvil
