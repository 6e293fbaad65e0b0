// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/figures/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace anvil {

double nice_step(double span, int intervals) {
  const double rough = span / intervals;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 2.5, 5.0})
    if (rough <= 1.001 * factor * power) return factor * power;
  return 10.0 * power;
}

std::vector<double> multiples_between(double low, double high, double step) {
  constexpr double slack = 1e-6;  // of a step: the ends themselves are rounded numbers
  std::vector<double> ticks;
  const auto last = static_cast<long long>(std::floor(high / step + slack));
  for (auto i = static_cast<long long>(std::ceil(low / step - slack)); i <= last; ++i)
    ticks.push_back(static_cast<double>(i) * step);
  return ticks;
}

std::string tick_format(double step, double largest) {
  if (largest >= 1e5 || largest < 1e-3) return "%.2e";
  int decimals = 0;
  for (double digits = step; decimals < 6 && std::abs(digits - std::round(digits)) > 1e-6 * digits; digits *= 10.0)
    ++decimals;
  return fmt::format("%.{}f", decimals);
}

}  // namespace anvil
