// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "anvil/core/error.hpp"

namespace anvil {

/// Where the increasing function f crosses zero: secant steps from `guess` with first slope `slope`, kept inside the
/// bracket found so far. Ends when |f| <= tolerance or x no longer changes. Boost's solvers want a bracket from the
/// start; here the first step is exact for straight pieces and a bracket is seldom needed. Throws NumericalError.
template <class Function>
double find_increasing_root(const Function& f, double guess, double slope, double tolerance) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr int most_steps = 200;
  double lower = -infinity;
  double upper = infinity;
  double x = guess;
  double value = f(x);
  for (int step = 0; step < most_steps; ++step) {
    if (std::abs(value) <= tolerance) return x;
    if (std::isnan(value)) break;
    (value < 0.0 ? lower : upper) = x;
    const auto unchanged = [&](double other) {
      return std::abs(other - x) <= 2.0 * std::numeric_limits<double>::epsilon() * std::abs(x);
    };
    double next = x - value / slope;
    if (unchanged(next)) return x;  // before any bisection: the other end may still be infinitely far
    if (!(next > lower && next < upper)) next = 0.5 * (lower + upper);
    if (unchanged(next) || !(lower < upper)) return next;
    const double next_value = f(next);
    const double secant = (next_value - value) / (next - x);
    if (secant > 0.0) slope = secant;
    x = next;
    value = next_value;
  }
  throw NumericalError(
      "the exact solution finds no state between the waves: the load is beyond what the material's law describes");
}

}  // namespace anvil
