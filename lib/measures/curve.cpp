// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/curve.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace anvil {

double value_at(const Curve& curve, double x) {
  std::optional<double> largest;
  for (std::size_t i = 1; i < curve.x.size(); ++i) {
    const double left = curve.x[i - 1];
    const double right = curve.x[i];
    if (x < std::min(left, right) || x > std::max(left, right)) continue;
    const double weight = left == right ? 0.0 : (x - left) / (right - left);
    const double y = (1.0 - weight) * curve.y[i - 1] + weight * curve.y[i];
    largest = std::max(largest.value_or(y), y);
  }
  if (largest) return *largest;
  const bool before = std::abs(curve.x.front() - x) <= std::abs(curve.x.back() - x);
  return before ? curve.y.front() : curve.y.back();
}

double relative_distance(const Curve& curve, const Curve& reference) {
  double difference = 0.0;
  double scale = 0.0;
  for (std::size_t i = 0; i < reference.x.size(); ++i) {
    const double deviation = value_at(curve, reference.x[i]) - reference.y[i];
    difference += deviation * deviation;
    scale += reference.y[i] * reference.y[i];
  }
  return std::sqrt(difference / scale);
}

}  // namespace anvil
