// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

namespace anvil {

/// Pressure on a face against time: time in s from the start of the run, pressure in Pa, positive in compression.
/// Zero before the history begins and after it ends; at a jump the later value holds.
class PressureHistory {
 public:
  /// No load.
  PressureHistory() = default;

  static PressureHistory constant(double pressure);
  static PressureHistory rectangular(double pressure, double duration);
  /// pressure exp(-t / decay_time)
  static PressureHistory exponential(double pressure, double decay_time);
  /// pressure sin(pi t / duration) up to `duration`
  static PressureHistory half_sine(double pressure, double duration);
  /// Straight lines between the points; two points at the same time make a jump. Throws InputError unless there are at
  /// least two points, as many times as pressures, and times that begin at 0 or later and never decrease.
  static PressureHistory tabulated(const std::vector<double>& times, const std::vector<double>& pressures);

  [[nodiscard]] double at(double time) const;

  /// Largest absolute pressure.
  [[nodiscard]] double peak() const;

  /// From `time` on the pressure is `pressure`, until the next step.
  struct Step {
    double time;
    double pressure;
  };
  /// The history up to `end` as steps. Exact where the pressure is constant; elsewhere steps of at most `resolution`,
  /// each at the mean pressure of its interval, so that the impulse is kept (by Simpson's rule).
  [[nodiscard]] std::vector<Step> steps(double end, double resolution) const;

 private:
  /// The pressure is monotone inside a segment.
  struct Segment {
    double begin;
    double end;
    std::function<double(double)> pressure;
  };
  static void add_steps(const Segment& segment, double begin, double end, double resolution, std::vector<Step>& steps);

  std::vector<Segment> segments_;
};

}  // namespace anvil
