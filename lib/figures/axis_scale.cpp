// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/figures/axis_scale.hpp"

#include <fmt/printf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "anvil/core/error.hpp"
#include "anvil/figures/ticks.hpp"

namespace anvil {
namespace {

std::string superscript(int number) {
  const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char digit : std::to_string(std::abs(number))) text += digits[digit - '0'];
  return number < 0 ? "⁻" + text : text;
}

/// The range of the axis, or of those values that can stand on it; 0 to 1 when there are none.
std::pair<double, double> ends_of(const Axis& axis, const std::vector<double>& values) {
  if (axis.range) return {(*axis.range)[0], (*axis.range)[1]};
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : values) {
    if (!std::isfinite(value) || (axis.logarithmic && value <= 0.0)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return low <= high ? std::pair(low, high) : std::pair(0.0, 1.0);
}

}  // namespace

std::string tick_label(double value, double step, double largest) {
  if (std::abs(value) < 1e-9 * step) value = 0.0;
  std::string text;
  if (largest >= 1e5 || largest < 1e-3) {
    if (value == 0.0) return "0";
    const int exponent = static_cast<int>(std::floor(std::log10(largest)));
    const double unit = std::pow(10.0, exponent);
    text = fmt::sprintf(tick_format(step / unit, largest / unit), value / unit) + "×10" + superscript(exponent);
  } else {
    text = fmt::sprintf(tick_format(step, largest), value);
  }
  return text.starts_with('-') ? "−" + text.substr(1) : text;
}

AxisScale::AxisScale(const Axis& axis, const std::vector<double>& values, bool tight, int intervals)
    : logarithmic_(axis.logarithmic) {
  const auto [low, high] = ends_of(axis, values);
  if (axis.range && !(low < high)) throw InputError(fmt::format("the range of the axis '{}' is empty", axis.label));
  if (logarithmic_ && !(low > 0.0))
    throw InputError(fmt::format("the logarithmic axis '{}' has nothing above zero to show", axis.label));
  low_ = logarithmic_ ? std::log10(low) : low;
  high_ = logarithmic_ ? std::log10(high) : high;
  make_room_around_one_value();
  const double step = nice_step(high_ - low_, intervals);
  if (!axis.range) round_outward(tight, step);
  if (logarithmic_)
    make_logarithmic_ticks();
  else
    make_linear_ticks(step);
}

void AxisScale::make_room_around_one_value() {
  if (high_ - low_ > 1e-12 * std::max(std::abs(low_), std::abs(high_))) return;
  const double room = low_ == 0.0 || logarithmic_ ? 0.5 : 0.5 * std::abs(low_);
  low_ -= room;
  high_ += room;
}

void AxisScale::round_outward(bool tight, double step) {
  if (logarithmic_) {
    const double room = tight ? 0.0 : 0.05 * (high_ - low_);
    low_ -= room;
    high_ += room;
    return;
  }
  const double span = high_ - low_;
  const double lower = step * std::floor(low_ / step + 1e-6);
  const double upper = step * std::ceil(high_ / step - 1e-6);
  if (tight) {
    // Particles lie half a spacing inside their body: the axis still ends where the body does.
    constexpr double near = 0.015;
    if (low_ - lower <= near * span) low_ = lower;
    if (upper - high_ <= near * span) high_ = upper;
    return;
  }
  // A line along a tick stays clear of the frame, and a trifle beyond a tick does not cost a whole step.
  constexpr double trifle = 0.02;
  const auto beside_tick = [&](double value) {
    return std::abs(value - step * std::round(value / step)) <= trifle * span;
  };
  low_ = beside_tick(low_) ? low_ - 2.0 * trifle * span : lower;
  high_ = beside_tick(high_) ? high_ + 2.0 * trifle * span : upper;
}

double AxisScale::share_of(double value) const {
  if (logarithmic_) {
    if (!(value > 0.0)) return std::numeric_limits<double>::quiet_NaN();
    value = std::log10(value);
  }
  return (value - low_) / (high_ - low_);
}

void AxisScale::make_linear_ticks(double step) {
  const double largest = std::max(std::abs(low_), std::abs(high_));
  for (const double value : multiples_between(low_, high_, step))
    ticks_.push_back({(value - low_) / (high_ - low_), tick_label(value, step, largest)});
}

void AxisScale::make_logarithmic_ticks() {
  const int first = static_cast<int>(std::floor(low_));
  const int last = static_cast<int>(std::ceil(high_));
  const bool label_fractions = high_ - low_ < 1.5;  // few powers of ten to read
  const int every = 1 + (last - first) / 8;
  for (int power = first; power <= last; ++power)
    for (int factor = 1; factor < 10; ++factor) {
      const double share = (power + std::log10(factor) - low_) / (high_ - low_);
      if (share < -1e-9 || share > 1.0 + 1e-9) continue;
      std::string label;
      if (factor == 1 && (power - first) % every == 0) label = "10" + superscript(power);
      if (label_fractions && (factor == 2 || factor == 5)) label = fmt::format("{}×10{}", factor, superscript(power));
      if (factor == 1 || every == 1) ticks_.push_back({share, label});
    }
}

}  // namespace anvil
