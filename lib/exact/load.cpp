// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/exact/load.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();

void check_positive_time(double time, const char* name) {
  if (!(time > 0.0)) throw InputError(std::string("the ") + name + " of a pressure history must be above zero");
}

}  // namespace

PressureHistory PressureHistory::constant(double pressure) { return rectangular(pressure, forever); }

PressureHistory PressureHistory::rectangular(double pressure, double duration) {
  check_positive_time(duration, "duration");
  PressureHistory history;
  history.segments_.push_back({0.0, duration, [pressure](double) { return pressure; }});
  return history;
}

PressureHistory PressureHistory::exponential(double pressure, double decay_time) {
  check_positive_time(decay_time, "decay time");
  PressureHistory history;
  history.segments_.push_back(
      {0.0, forever, [pressure, decay_time](double time) { return pressure * std::exp(-time / decay_time); }});
  return history;
}

PressureHistory PressureHistory::half_sine(double pressure, double duration) {
  check_positive_time(duration, "duration");
  const auto sine = [pressure, duration](double time) {
    return pressure * std::sin(std::numbers::pi * time / duration);
  };
  PressureHistory history;
  history.segments_ = {{0.0, 0.5 * duration, sine}, {0.5 * duration, duration, sine}};
  return history;
}

PressureHistory PressureHistory::tabulated(const std::vector<double>& times, const std::vector<double>& pressures) {
  if (times.size() < 2 || times.size() != pressures.size())
    throw InputError("a tabulated pressure history needs at least two points, and as many times as pressures");
  if (times.front() < 0.0 || !std::is_sorted(times.begin(), times.end()))
    throw InputError("the times of a tabulated pressure history begin at 0 or later and never decrease");
  PressureHistory history;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    if (times[i + 1] == times[i]) continue;
    const double slope = (pressures[i + 1] - pressures[i]) / (times[i + 1] - times[i]);
    history.segments_.push_back({times[i], times[i + 1], [=, begin = times[i], start = pressures[i]](double time) {
                                   return start + slope * (time - begin);
                                 }});
  }
  return history;
}

double PressureHistory::at(double time) const {
  for (const Segment& segment : segments_)
    if (time >= segment.begin && time < segment.end) return segment.pressure(time);
  return 0.0;
}

double PressureHistory::peak() const {
  double largest = 0.0;
  for (const Segment& segment : segments_) {
    largest = std::max(largest, std::abs(segment.pressure(segment.begin)));
    if (std::isfinite(segment.end)) largest = std::max(largest, std::abs(segment.pressure(segment.end)));
  }
  return largest;
}

std::vector<PressureHistory::Step> PressureHistory::steps(double end, double resolution) const {
  std::vector<Step> steps;
  double covered = 0.0;
  for (const Segment& segment : segments_) {
    if (segment.begin >= end) break;
    if (segment.begin > covered) steps.push_back({covered, 0.0});
    add_steps(segment, segment.begin, std::min(segment.end, end), resolution, steps);
    covered = segment.end;
  }
  if (covered < end) steps.push_back({covered, 0.0});
  const auto repeated = [](const Step& a, const Step& b) { return a.pressure == b.pressure; };
  steps.erase(std::unique(steps.begin(), steps.end(), repeated), steps.end());
  return steps;
}

void PressureHistory::add_steps(const Segment& segment, double begin, double end, double resolution,
                                std::vector<Step>& steps) {
  const double middle = 0.5 * (begin + end);
  const double first = segment.pressure(begin);
  const double last = segment.pressure(end);
  if (std::abs(last - first) > resolution) {
    add_steps(segment, begin, middle, resolution, steps);
    add_steps(segment, middle, end, resolution, steps);
    return;
  }
  steps.push_back({begin, (first + 4.0 * segment.pressure(middle) + last) / 6.0});
}

}  // namespace anvil
