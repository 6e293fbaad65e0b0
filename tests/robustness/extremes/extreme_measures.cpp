// SPDX-License-Identifier: BSD-3-Clause
#include "robustness/extremes/extreme_measures.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>

#include "anvil/exact/scene_reference.hpp"
#include "anvil/measures/frame_fields.hpp"
#include "anvil/measures/measures.hpp"
#include "anvil/measures/wave_comparison.hpp"
#include "anvil/scene/reader.hpp"

namespace anvil {
namespace {

double over_particles(const std::string& how, const std::string& expression, const Frame& frame) {
  const auto values = field_of(frame, expression).values;
  if (how == "max") return *std::max_element(values.begin(), values.end());
  if (how == "min") return *std::min_element(values.begin(), values.end());
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double over_history(const std::string& how, const std::string& column, const History& history) {
  const HistoryColumn* found = history.find(column);
  if (found == nullptr || found->values.empty()) throw std::runtime_error("the history has no column " + column);
  if (how == "end") return found->values.back();
  return *std::max_element(found->values.begin(), found->values.end(),
                           [](double a, double b) { return std::abs(a) < std::abs(b); });
}

/// The plane waves the case is one- or more-dimensional form of.
double against_exact(const std::string& name, const Result& result, const ExtremeCase& extreme) {
  Scene plane = result.scene;
  if (!extreme.exact.empty())
    plane = read_scene(ANVIL_SOURCE_DIR "/tests/robustness/extremes/scenes/plane.toml", extreme.exact);
  const SceneReference reference(plane, {result.frame.time}, strain_measure_of(plane));
  for (const auto& quantity : compare_waves(result.frame, reference, 0, result.scene.discretisation.spacing))
    if (quantity.name == name) return quantity.deviation;
  throw std::runtime_error("nothing measures " + name);
}

/// Sum of x v_y - y v_x over all particles; these have the same mass.
double spin(const std::vector<double>& position, const std::vector<double>& velocity) {
  double sum = 0.0;
  for (std::size_t i = 0; i < position.size(); i += 3)
    sum += position[i] * velocity[i + 1] - position[i + 1] * velocity[i];
  return sum;
}

double spin_kept(const Result& result, double rate) {
  const auto& start = result.frame.find("initial_position")->values;
  std::vector<double> turning(start.size(), 0.0);
  for (std::size_t i = 0; i < start.size(); i += 3) {
    turning[i] = -rate * start[i + 1];
    turning[i + 1] = rate * start[i];
  }
  return spin(result.frame.positions, result.frame.find("velocity")->values) / spin(start, turning);
}

/// The columns of the start, each at the mean place of its particles now: the widest gap between two over the mean one.
double widest_gap(const Frame& frame, double spacing) {
  const auto& start = frame.find("initial_position")->values;
  std::map<long long, std::pair<double, int>> columns;
  for (std::size_t i = 0; i < start.size(); i += 3) {
    auto& [sum, count] = columns[std::llround(4.0 * start[i] / spacing)];
    sum += frame.positions[i];
    ++count;
  }
  std::vector<double> places;
  for (const auto& [number, column] : columns) places.push_back(column.first / column.second);
  double widest = 0.0;
  for (std::size_t k = 1; k < places.size(); ++k) widest = std::max(widest, places[k] - places[k - 1]);
  return widest * static_cast<double>(places.size() - 1) / (places.back() - places.front());
}

}  // namespace

double measure_extreme(const std::string& name, const Result& result, const ExtremeCase& extreme) {
  const auto space = name.find(' ');
  const std::string first = name.substr(0, space), rest = space == std::string::npos ? "" : name.substr(space + 1);
  if (first == "max" || first == "min" || first == "mean") return over_particles(first, rest, result.frame);
  if (first == "end" || first == "most") return over_history(first, rest, result.history);
  if (name == "steps") return static_cast<double>(result.frame.step);
  if (name == "spin_kept")
    return spin_kept(result, extreme.velocity_gradient.at(result.scene.domain.dimension == 2 ? 2 : 3));
  if (name == "widest_gap") return widest_gap(result.frame, result.scene.discretisation.spacing);
  if (const Measure* measure = find_measure(name)) return measure->of(result);
  return against_exact(name, result, extreme);
}

}  // namespace anvil
