// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/study/wave_speed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "anvil/core/error.hpp"
#include "anvil/exact/scene_plate.hpp"

namespace anvil {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Axial stress over initial position, from left to right.
using StressLine = std::vector<std::pair<double, double>>;

StressLine stress_line(const Frame& frame) {
  const FrameArray* initial = frame.find("initial_position");
  const FrameArray* stress = frame.find("stress");
  if (initial == nullptr || stress == nullptr) throw InputError("waves are found by initial_position and stress");
  StressLine line;
  for (std::size_t i = 0; i < frame.particle_count(); ++i)
    line.emplace_back(initial->values[3 * i], stress->values[6 * i]);
  std::sort(line.begin(), line.end());
  return line;
}

StressLine exact_line(const SceneReference& exact, std::size_t time) {
  StressLine line;
  for (const auto& point : exact.line(time)) line.emplace_back(point.initial_position, point.stress);
  return line;
}

/// The rightmost place where |stress| is `level`.
double front_position(const StressLine& line, double level) {
  for (std::size_t i = line.size() - 1; i > 0; --i) {
    const double ahead = std::abs(line[i].second) - level;
    const double behind = std::abs(line[i - 1].second) - level;
    if (ahead >= 0.0) return none;  // it has reached the end
    if (behind >= 0.0) return line[i].first + (line[i - 1].first - line[i].first) * ahead / (ahead - behind);
  }
  return none;
}

double speed_ratio(const StudySample& sample, double level) {
  if (sample.number == 0) return none;
  const std::size_t now = sample.number;
  const double path = front_position(stress_line(sample.frames[now]), level) -
                      front_position(stress_line(sample.frames[now - 1]), level);
  const double exact_path = front_position(exact_line(sample.exact(), now), level) -
                            front_position(exact_line(sample.exact(), now - 1), level);
  return path / exact_path;  // both in the same time
}

double exact_peak(const StudySample& sample) {
  double peak = 0.0;
  for (const auto& point : sample.exact().line(sample.number)) peak = std::max(peak, std::abs(point.stress));
  return peak;
}

/// Of the material that the wave runs in; infinite when it does not yield.
double elastic_limit(const Scene& scene) {
  return plate_problem(scene, StrainMeasure::small).layers.back().material.elastic_limit();
}

}  // namespace

double elastic_speed_ratio(const StudySample& sample, std::string_view) {
  return speed_ratio(sample, 0.5 * std::min(exact_peak(sample), elastic_limit(sample.scene)));
}

double plastic_speed_ratio(const StudySample& sample, std::string_view) {
  const double limit = elastic_limit(sample.scene);
  const double peak = exact_peak(sample);
  return peak > limit ? speed_ratio(sample, 0.5 * (limit + peak)) : none;
}

double precursor_error(const StudySample& sample, std::string_view) {
  const double limit = elastic_limit(sample.scene);
  if (!std::isfinite(limit)) return none;
  const auto line = stress_line(sample.frames[sample.number]);
  // Finite strain moves the limit by less than a percent; plastic waves are further off.
  const auto in_precursor = [&](const auto& particle) {
    return std::abs(sample.exact().at(sample.number, particle.first).stress + limit) < 0.01 * limit;
  };
  const auto begin = std::find_if(line.begin(), line.end(), in_precursor);
  const auto end = std::find_if_not(begin, line.end(), in_precursor);
  constexpr std::ptrdiff_t shortest = 20;
  if (end - begin < shortest) return none;
  const auto quarter = (end - begin) / 4;
  double difference = 0.0;
  for (auto particle = begin + quarter; particle != end - quarter; ++particle)
    difference += particle->second - sample.exact().at(sample.number, particle->first).stress;
  return difference / static_cast<double>(end - begin - 2 * quarter) / -limit;
}

}  // namespace anvil
