// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numbers>
#include <string_view>

#include "anvil/core/lane_math.hpp"

namespace anvil {

/// Quintic B-spline (Schoenberg 1946; Morris 1996 for SPH). W(r) = normalisation(D) / h^D * value(r / h).
struct QuinticSpline {
  static constexpr std::string_view name = "quintic_spline";
  static constexpr std::string_view summary = "quintic B-spline, support 3 h";
  static constexpr double support = 3.0;  // in smoothing lengths

  static constexpr double normalisation(int dimension) {
    if (dimension == 1) return 1.0 / 120.0;
    return dimension == 2 ? 7.0 / (478.0 * std::numbers::pi) : 1.0 / (120.0 * std::numbers::pi);
  }

  /// (3 - q)^5 - 6 (2 - q)^5 + 15 (1 - q)^5, each bracket only where positive.
  template <class T>
  static ANVIL_INLINE T value(const T& q) {
    return fifth_power(max(T(3.0) - q, T(0.0))) - T(6.0) * fifth_power(max(T(2.0) - q, T(0.0))) +
           T(15.0) * fifth_power(max(T(1.0) - q, T(0.0)));
  }

  /// (dw/dq) / q. Below q = 1 the three brackets sum to a polynomial without a constant, which divides by q exactly;
  /// each piece is held at its value at q = 1, -50, on the other side.
  template <class T>
  static ANVIL_INLINE T slope_over_q(const T& q) {
    const T outer_q = max(q, T(1.0));
    const T outer = fourth_power(max(T(3.0) - outer_q, T(0.0))) - T(6.0) * fourth_power(max(T(2.0) - outer_q, T(0.0)));
    const T inner_q = min(q, T(1.0));
    const T inner = inner_q * inner_q * (T(120.0) - T(50.0) * inner_q) - T(70.0);
    return T(-5.0) * outer / outer_q + inner;
  }

 private:
  template <class T>
  static ANVIL_INLINE T fourth_power(const T& a) {
    const T square = a * a;
    return square * square;
  }
  template <class T>
  static ANVIL_INLINE T fifth_power(const T& a) {
    return fourth_power(a) * a;
  }
};

}  // namespace anvil
