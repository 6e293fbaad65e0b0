// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/figures/figure_builder.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "anvil/core/error.hpp"
#include "anvil/exact/scene_reference.hpp"
#include "anvil/figures/color_scale.hpp"
#include "anvil/figures/csv_columns.hpp"
#include "anvil/figures/profile.hpp"
#include "anvil/figures/unit.hpp"
#include "anvil/measures/expression.hpp"
#include "anvil/measures/frame_fields.hpp"

namespace anvil {
namespace {

/// What a field is called on an axis.
std::string name_of(const std::string& quantity) {
  const std::pair<const char*, const char*> names[] = {{"stress.xx", "Axial stress"},
                                                       {"velocity.x", "Velocity"},
                                                       {"initial_position.x", "Initial position"},
                                                       {"position.x", "Position"},
                                                       {"plastic_strain", "Plastic strain"},
                                                       {"specific_energy", "Specific energy"},
                                                       {"density", "Density"},
                                                       {"pressure", "Pressure"},
                                                       {"time", "Time"},
                                                       {"distance", "Distance"},
                                                       {"von_mises", "Von Mises stress"}};
  for (const auto& [field, name] : names)
    if (quantity == field) return name;
  std::string name = quantity;
  std::replace(name.begin(), name.end(), '_', ' ');
  if (!name.empty() && name.find_first_of("+-*/(^") == std::string::npos)
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

/// What columns of a history in one unit have in common.
std::string kind_of(const std::string& si_unit) {
  if (si_unit.starts_with("J")) return "Energy";
  if (si_unit.starts_with("N s")) return "Momentum";
  if (si_unit == "m") return "Length";
  return "";
}

std::string time_label(double seconds) {
  const Unit unit = readable_unit("s", std::abs(seconds));
  return fmt::format("{:.4g} {}", seconds / unit.factor, unit.name);
}

double largest_of(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

/// One member of ExactPoint per field that the exact solution knows.
double ExactPoint::*exact_member(const std::string& field) {
  const std::pair<const char*, double ExactPoint::*> members[] = {{"stress.xx", &ExactPoint::stress},
                                                                  {"velocity.x", &ExactPoint::velocity},
                                                                  {"density", &ExactPoint::density},
                                                                  {"pressure", &ExactPoint::pressure},
                                                                  {"deviatoric_stress.xx", &ExactPoint::deviator},
                                                                  {"specific_energy", &ExactPoint::energy}};
  for (const auto& [name, member] : members)
    if (field == name) return member;
  throw InputError(
      fmt::format("the exact solution knows stress.xx, velocity.x, density, pressure, deviatoric_stress.xx and "
                  "specific_energy; it cannot go with '{}'",
                  field));
}

/// Collects curves in SI units; units of the axes are settled when all are there.
class PanelBuilder {
 public:
  PanelBuilder(const PanelDescription& description, const std::filesystem::path& folder,
               const std::vector<PlottedResult>& results)
      : description_(description), folder_(folder), results_(results) {}

  Panel build() {
    panel_.title = description_.title;
    panel_.equal_scales = description_.equal_scales;
    for (const auto& curve : description_.curves) {
      if (!curve.field.empty()) add_profiles(curve);
      if (!curve.history.empty()) add_histories(curve);
      if (!curve.file.empty()) add_file(curve);
    }
    if (description_.map) add_map(*description_.map);
    if (description_.map) {
      finish_axis(description_.x, x_unit_, panel_.x, &PlottedCurve::x, &panel_.map->x);
      finish_axis(description_.y, y_unit_, panel_.y, &PlottedCurve::y, &panel_.map->y);
    } else {
      finish_axis(description_.x, x_unit_, panel_.x, &PlottedCurve::x, nullptr);
      finish_axis(description_.y, y_unit_, panel_.y, &PlottedCurve::y, nullptr);
    }
    return std::move(panel_);
  }

 private:
  [[nodiscard]] std::string along() const {
    return description_.x.quantity.empty() ? "initial_position.x" : description_.x.quantity;
  }

  /// All curves of a panel share its units; the first one settles what is not described.
  static void settle(std::string& unit, std::string& label, const std::string& new_unit, const std::string& quantity) {
    if (unit.empty()) unit = new_unit;
    if (label.empty()) label = name_of(quantity);
  }

  void add_profiles(const CurveDescription& curve) {
    std::vector<double> times = curve.times;
    if (results_.front().times.empty())
      throw InputError(fmt::format("the result '{}' has no frames", results_.front().label));
    if (times.empty()) times = {results_.front().times.back()};
    std::sort(times.begin(), times.end());
    for (const double time : times)
      for (const auto& result : results_) add_profile(curve, result, time, times.size() > 1);
    if (curve.exact) add_exact(curve, times);
  }

  void add_profile(const CurveDescription& curve, const PlottedResult& result, double time, bool several) {
    const Frame frame = result.frame(frame_at(result.times, time, result.label));
    Profile profile = curve.line.empty() ? profile_of_particles(frame, along(), curve.field, curve.where)
                                         : profile_on_line(frame, curve.field, curve.line);
    settle(x_unit_, panel_.x.label, profile.x.unit, curve.line.empty() ? along() : "distance");
    settle(y_unit_, panel_.y.label, profile.y.unit, curve.field);
    std::string label = curve.label;
    if (description_.curves.size() > 1 && label.empty()) label = name_of(curve.field);
    if (results_.size() > 1) append(label, result.label);
    if (several || label.empty()) append(label, time_label(frame.time));
    PlottedCurve plotted = new_curve(label, curve.style.empty() && profile.scattered ? "points" : curve.style);
    plotted.x = std::move(profile.x.values);
    plotted.y = std::move(profile.y.values);
    panel_.curves.push_back(std::move(plotted));
  }

  static void append(std::string& label, const std::string& part) { label += (label.empty() ? "" : ", ") + part; }

  PlottedCurve new_curve(const std::string& label, const std::string& style) {
    PlottedCurve curve;
    curve.label = label;
    if (style == "points" || style == "wall") curve.style = CurveStyle::points;
    if (style == "reference") curve.style = CurveStyle::reference;
    if (style == "wall")
      curve.color = {150, 150, 150};
    else if (curve.style != CurveStyle::reference)
      curve.color = curve_color(colors_used_++);
    return curve;
  }

  void add_exact(const CurveDescription& curve, const std::vector<double>& times) {
    if (along() != "initial_position.x")
      throw InputError("exact solutions are drawn along initial_position.x; leave x.quantity out");
    const auto member = exact_member(curve.field);
    if (!results_.front().scene)
      throw InputError("an exact solution needs the scene of the result: the folder that anvil run left behind");
    const Scene& scene = *results_.front().scene;
    std::vector<double> frame_times;  // exactly, not as the description rounds them
    const PlottedResult& result = results_.front();
    for (const double time : times) frame_times.push_back(result.times[frame_at(result.times, time, result.label)]);
    const SceneReference reference(scene, frame_times, strain_measure_of(scene));
    for (std::size_t i = 0; i < times.size(); ++i) {
      PlottedCurve plotted = new_curve(i == 0 && !has_exact_ ? short_name(reference.description()) : "", "reference");
      for (const auto& point : reference.line(i)) {
        plotted.x.push_back(point.initial_position);
        plotted.y.push_back(point.*member);
      }
      panel_.curves.push_back(std::move(plotted));
    }
    has_exact_ = true;
  }

  /// Without the method in parentheses.
  static std::string short_name(const std::string& description) {
    return description.substr(0, description.find(" ("));
  }

  void add_histories(const CurveDescription& curve) {
    for (const auto& result : results_) {
      if (!result.history)
        throw InputError(fmt::format("'{}' has no history.csv: name the folder of a result", result.label));
      const auto columns = columns_of(*result.history);
      Evaluated x = evaluate("time", columns);
      Evaluated y = evaluate(curve.history, columns);
      settle(x_unit_, panel_.x.label, x.unit, "time");
      settle(y_unit_, panel_.y.label, y.unit, description_.curves.size() > 1 ? kind_of(y.unit) : curve.history);
      std::string label = curve.label;
      if (label.empty() && description_.curves.size() > 1) label = name_of(curve.history);
      if (results_.size() > 1) append(label, result.label);
      PlottedCurve plotted = new_curve(label, curve.style);
      plotted.x = std::move(x.values);
      plotted.y = std::move(y.values);
      panel_.curves.push_back(std::move(plotted));
    }
  }

  void add_file(const CurveDescription& curve) {
    const auto columns = read_csv_columns(folder_ / curve.file);
    const CsvColumn& x = column_of(columns, curve.x_column, curve.file);
    const CsvColumn& y = column_of(columns, curve.y_column, curve.file);
    settle(x_unit_, panel_.x.label, x.si_unit, x.name);
    settle(y_unit_, panel_.y.label, y.si_unit, y.name);
    std::string label = curve.label.empty() ? curve.file : curve.label;
    const auto has_label = [&](const PlottedCurve& other) { return other.label == label; };
    if (std::any_of(panel_.curves.begin(), panel_.curves.end(), has_label)) label.clear();  // once in the legend
    PlottedCurve plotted = new_curve(label, curve.style);
    plotted.x = x.values;
    plotted.y = y.values;
    panel_.curves.push_back(std::move(plotted));
  }

  void finish_axis(const AxisDescription& wanted, const std::string& si, Axis& axis,
                   std::vector<double> PlottedCurve::*values, std::array<double, 2>* of_map) {
    double largest = of_map != nullptr ? std::max(std::abs((*of_map)[0]), std::abs((*of_map)[1])) : 0.0;
    for (const auto& curve : panel_.curves) largest = std::max(largest, largest_of(curve.*values));
    const Unit unit = wanted.unit.empty() ? readable_unit(si, largest) : find_unit(wanted.unit);
    if (!si.empty() && !wanted.unit.empty() && unit.si != si)
      throw InputError(fmt::format("an axis cannot be in {}: what it shows is in {}", wanted.unit, si));
    for (auto& curve : panel_.curves)
      for (double& value : curve.*values) value /= unit.factor;
    if (of_map != nullptr)
      for (double& edge : *of_map) edge /= unit.factor;
    axis.label = with_unit(wanted.label.empty() ? axis.label : wanted.label, unit);
    axis.logarithmic = wanted.logarithmic;
    if (wanted.range.size() == 2) axis.range = {wanted.range[0], wanted.range[1]};
  }

  void add_map(const MapDescription& wanted);

  const PanelDescription& description_;
  const std::filesystem::path& folder_;
  const std::vector<PlottedResult>& results_;
  Panel panel_;
  std::string x_unit_, y_unit_;  // SI
  std::size_t colors_used_ = 0;
  bool has_exact_ = false;
};

/// Index of the value nearest to `wanted` in an ascending list.
std::size_t nearest(const std::vector<double>& values, double wanted) {
  const auto after = std::lower_bound(values.begin(), values.end(), wanted);
  if (after == values.begin()) return 0;
  const auto i = static_cast<std::size_t>(after - values.begin());
  return i == values.size() || wanted - values[i - 1] < values[i] - wanted ? i - 1 : i;
}

/// The values of a frame from left to right.
struct Row {
  std::vector<double> places, values;
};

Row sorted_row(const std::vector<double>& places, const std::vector<double>& values) {
  std::vector<std::pair<double, double>> sorted;
  for (std::size_t i = 0; i < places.size(); ++i) sorted.emplace_back(places[i], values[i]);
  std::sort(sorted.begin(), sorted.end());
  Row row;
  for (const auto& [place, value] : sorted) {
    row.places.push_back(place);
    row.values.push_back(value);
  }
  return row;
}

/// Takes each cell from the nearest frame and particle: nothing is smoothed. In SI units.
PlottedMap make_map(const std::vector<Row>& rows, const std::vector<double>& times) {
  PlottedMap map;
  map.rows = 300;
  map.columns = 400;
  map.y = {times.front(), times.back()};
  map.x = {rows.front().places.front(), rows.front().places.back()};
  for (const Row& row : rows) map.x = {std::min(map.x[0], row.places.front()), std::max(map.x[1], row.places.back())};
  const auto centre = [](const std::array<double, 2>& edges, std::size_t cell, std::size_t cells) {
    return edges[0] + (edges[1] - edges[0]) * (static_cast<double>(cell) + 0.5) / static_cast<double>(cells);
  };
  for (std::size_t j = 0; j < map.rows; ++j) {
    const Row& row = rows[nearest(times, centre(map.y, j, map.rows))];
    for (std::size_t i = 0; i < map.columns; ++i)
      map.values.push_back(row.values[nearest(row.places, centre(map.x, i, map.columns))]);
  }
  return map;
}

void PanelBuilder::add_map(const MapDescription& wanted) {
  const PlottedResult& result = results_.front();
  if (result.times.size() < 2) throw InputError("a map over time needs two frames or more");
  std::vector<Row> rows;
  std::string unit;
  for (std::size_t i = 0; i < result.times.size(); ++i) {
    const Frame frame = result.frame(i);
    if (frame.dimension != 1) throw InputError("maps over time are drawn of scenes in one dimension");
    const Evaluated x = field_of(frame, along());
    const Evaluated field = field_of(frame, wanted.field);
    settle(x_unit_, panel_.x.label, x.unit, along());
    unit = field.unit;
    rows.push_back(sorted_row(x.values, field.values));
  }
  PlottedMap map = make_map(rows, result.times);
  const Unit shown = wanted.unit.empty() ? readable_unit(unit, largest_of(map.values)) : find_unit(wanted.unit);
  if (!unit.empty() && shown.si != unit)
    throw InputError(fmt::format("a map of '{}' cannot be in {}: it is in {}", wanted.field, wanted.unit, unit));
  for (double& value : map.values) value /= shown.factor;
  const auto [low, high] = std::minmax_element(map.values.begin(), map.values.end());
  map.range = {std::min(0.0, *low), std::max(0.0, *high)};
  if (wanted.range.size() == 2) map.range = {wanted.range[0], wanted.range[1]};
  if (map.range[0] == map.range[1]) map.range[1] = map.range[0] + 1.0;
  map.label = with_unit(wanted.label.empty() ? name_of(wanted.field) : wanted.label, shown);
  settle(y_unit_, panel_.y.label, "s", "time");
  panel_.map = std::move(map);
}

}  // namespace

std::size_t frame_at(const std::vector<double>& times, double time, const std::string& result) {
  if (times.empty()) throw InputError(fmt::format("the result '{}' has no frames", result));
  const std::size_t i = nearest(times, time);
  constexpr double same_time = 1e-3;  // of the whole run: times in descriptions are typed with few digits
  if (std::abs(times[i] - time) <= same_time * times.back()) return i;
  throw InputError(
      fmt::format("the result '{}' has no frame at {:.6g} s; the nearest is at {:.6g} s, the last at {:.6g} s", result,
                  time, times[i], times.back()));
}

Figure build_figure(const FigureDescription& description, const std::vector<PlottedResult>& results) {
  if (results.empty()) throw InputError("a figure needs a result");
  Figure figure;
  figure.title = description.title;
  figure.columns = description.columns;
  const auto panels = static_cast<int>(description.panels.size());
  const int columns = std::max(1, std::min(description.columns, panels));
  const int rows = (panels + columns - 1) / columns;
  figure.size = {description.width > 0 ? description.width : (columns == 1 ? 1600 : 1200 * columns),
                 description.height > 0 ? description.height : (rows == 1 ? 1200 : 900 * rows)};
  for (const auto& panel : description.panels)
    figure.panels.push_back(PanelBuilder(panel, description.folder, results).build());
  return figure;
}

}  // namespace anvil
