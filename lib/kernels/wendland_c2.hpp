// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numbers>
#include <string_view>

#include "anvil/core/lane_math.hpp"

namespace anvil {

/// Wendland C2 (Wendland 1995; Dehnen and Aly 2012, table 1: the function for three dimensions, used in one and two as
/// well). W(r) = normalisation(D) / h^D * value(r / h).
struct WendlandC2 {
  static constexpr std::string_view name = "wendland_c2";
  static constexpr std::string_view summary = "Wendland C2, support 2 h, does not pair particles";
  static constexpr double support = 2.0;  // in smoothing lengths

  static constexpr double normalisation(int dimension) {
    if (dimension == 1) return 0.75;
    return dimension == 2 ? 7.0 / (4.0 * std::numbers::pi) : 21.0 / (16.0 * std::numbers::pi);
  }

  /// (1 - q/2)^4 (1 + 2 q) up to 2, zero beyond.
  template <class T>
  static ANVIL_INLINE T value(const T& q) {
    const T inside = max(T(1.0) - T(0.5) * q, T(0.0));
    const T square = inside * inside;
    return square * square * (T(1.0) + T(2.0) * q);
  }

  /// (dw/dq) / q = -5 (1 - q/2)^3.
  template <class T>
  static ANVIL_INLINE T slope_over_q(const T& q) {
    const T inside = max(T(1.0) - T(0.5) * q, T(0.0));
    return T(-5.0) * inside * inside * inside;
  }
};

}  // namespace anvil
