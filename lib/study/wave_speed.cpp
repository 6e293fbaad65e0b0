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

/// Axial stress at initial positions, from left to right.
std::vector<std::pair<double, double>> stress_line(const Frame& frame) {
  const FrameArray* initial = frame.find("initial_position");
  const FrameArray* stress = frame.find("stress");
  if (initial == nullptr || stress == nullptr) throw InputError("waves are found by initial_position and stress");
  std::vector<std::pair<double, double>> line;
  for (std::size_t i = 0; i < frame.particle_count(); ++i)
    line.emplace_back(initial->values[3 * i], stress->values[6 * i]);
  std::sort(line.begin(), line.end());
  return line;
}

/// The rightmost place where |stress| is `level`.
double front_position(const Frame& frame, double level) {
  const auto line = stress_line(frame);
  for (std::size_t i = line.size() - 1; i > 0; --i) {
    const double ahead = std::abs(line[i].second) - level;
    const double behind = std::abs(line[i - 1].second) - level;
    if (ahead >= 0.0) return none;  // it has reached the end
    if (behind >= 0.0) return line[i].first + (line[i - 1].first - line[i].first) * ahead / (ahead - behind);
  }
  return none;
}

double speed(const StudySample& sample, double level) {
  if (sample.number == 0) return none;
  const Frame& before = sample.frames[sample.number - 1];
  const Frame& now = sample.frames[sample.number];
  return (front_position(now, level) - front_position(before, level)) / (now.time - before.time);
}

double exact_peak(const StudySample& sample) {
  double peak = 0.0;
  for (const auto& point : sample.exact().line(sample.number)) peak = std::max(peak, std::abs(point.stress));
  return peak;
}

/// The material the wave runs in.
WaveMaterial rightmost_material(const Scene& scene) {
  return plate_problem(scene, StrainMeasure::small).layers.back().material;
}

}  // namespace

double elastic_speed_ratio(const StudySample& sample, std::string_view) {
  const WaveMaterial material = rightmost_material(sample.scene);
  const double level = 0.5 * std::min(exact_peak(sample), material.elastic_limit());
  return speed(sample, level) / material.elastic_wave_speed();
}

double plastic_speed_ratio(const StudySample& sample, std::string_view) {
  const WaveMaterial material = rightmost_material(sample.scene);
  const double peak = exact_peak(sample);
  if (!(peak > material.elastic_limit())) return none;
  return speed(sample, 0.5 * (material.elastic_limit() + peak)) / material.plastic_wave_speed();
}

double precursor_error(const StudySample& sample, std::string_view) {
  const double limit = rightmost_material(sample.scene).elastic_limit();
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
