// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "anvil/figures/figure.hpp"

namespace anvil {

struct Tick {
  double share;       // of the way along the axis, 0 to 1
  std::string label;  // empty: a minor tick
};

/// Where the values of an axis lie along it.
class AxisScale {
 public:
  /// `values`: everything that is drawn along the axis. Rounds outward to ticks unless the axis has a range of its own;
  /// with `tight` the ends are those of the values. Throws InputError naming the axis.
  AxisScale(const Axis& axis, const std::vector<double>& values, bool tight, int intervals);

  /// From end to end: in the unit of the axis, in powers of ten on a logarithmic one.
  [[nodiscard]] double span() const { return high_ - low_; }
  /// 0 at the low end, 1 at the high one; NaN where a logarithmic axis does not reach.
  [[nodiscard]] double share_of(double value) const;
  [[nodiscard]] const std::vector<Tick>& ticks() const { return ticks_; }

 private:
  void make_room_around_one_value();
  void round_outward(bool tight, double step);
  void make_linear_ticks(double step);
  void make_logarithmic_ticks();

  bool logarithmic_;
  double low_ = 0.0;  // of a logarithmic axis: the logarithms to base 10
  double high_ = 1.0;
  std::vector<Tick> ticks_;
};

/// "−0.5": with a minus sign instead of a hyphen, and "6 × 10⁻³" for very large and small steps.
std::string tick_label(double value, double step, double largest);

}  // namespace anvil
