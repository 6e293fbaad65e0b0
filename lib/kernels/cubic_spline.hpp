// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numbers>
#include <string_view>

#include "anvil/core/lane_math.hpp"

namespace anvil {

/// Cubic B-spline (Monaghan and Lattanzio 1985). W(r) = normalisation(D) / h^D * value(r / h).
struct CubicSpline {
  static constexpr std::string_view name = "cubic_spline";
  static constexpr std::string_view summary = "cubic B-spline, support 2 h";
  static constexpr double support = 2.0;  // in smoothing lengths

  static constexpr double normalisation(int dimension) {
    if (dimension == 1) return 2.0 / 3.0;
    return dimension == 2 ? 10.0 / (7.0 * std::numbers::pi) : 1.0 / std::numbers::pi;
  }

  /// 1 - 1.5 q^2 + 0.75 q^3 up to 1, (2 - q)^3 / 4 up to 2, zero beyond; here as a difference of truncated cubes.
  template <class T>
  static ANVIL_INLINE T value(const T& q) {
    const T outer = max(T(2.0) - q, T(0.0));
    const T inner = max(T(1.0) - q, T(0.0));
    return T(0.25) * outer * outer * outer - inner * inner * inner;
  }

  /// (dw/dq) / q. Each piece is held at its value at q = 1 on the other side, which keeps q = 0 regular.
  template <class T>
  static ANVIL_INLINE T slope_over_q(const T& q) {
    const T outer_q = max(q, T(1.0));
    const T outer = max(T(2.0) - outer_q, T(0.0));
    const T inner = max(T(1.0) - q, T(0.0));
    return T(-0.75) * outer * outer / outer_q - T(2.25) * inner;
  }

  /// dw/dq, without a division: for one dimension, where the direction is a sign.
  template <class T>
  static ANVIL_INLINE T slope(const T& q) {
    const T outer = max(T(2.0) - q, T(0.0));
    const T inner = max(T(1.0) - q, T(0.0));
    return T(3.0) * inner * inner - T(0.75) * outer * outer;
  }
};

}  // namespace anvil
