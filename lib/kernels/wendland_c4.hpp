// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numbers>
#include <string_view>

#include "anvil/core/lane_math.hpp"

namespace anvil {

/// Wendland C4 (Wendland 1995; Dehnen and Aly 2012, table 1: the function for three dimensions, used in one and two as
/// well). W(r) = normalisation(D) / h^D * value(r / h).
struct WendlandC4 {
  static constexpr std::string_view name = "wendland_c4";
  static constexpr std::string_view summary = "Wendland C4, support 2 h, smoother than C2 and narrower";
  static constexpr double support = 2.0;  // in smoothing lengths

  static constexpr double normalisation(int dimension) {
    if (dimension == 1) return 27.0 / 32.0;
    return dimension == 2 ? 9.0 / (4.0 * std::numbers::pi) : 495.0 / (256.0 * std::numbers::pi);
  }

  /// (1 - s)^6 (1 + 6 s + 35/3 s^2) with s = q/2 up to 1, zero beyond.
  template <class T>
  static ANVIL_INLINE T value(const T& q) {
    const T s = T(0.5) * q;
    const T inside = max(T(1.0) - s, T(0.0));
    const T cube = inside * inside * inside;
    return cube * cube * (T(1.0) + s * (T(6.0) + T(35.0 / 3.0) * s));
  }

  /// (dw/dq) / q = -14/3 (1 - s)^5 (1 + 5 s).
  template <class T>
  static ANVIL_INLINE T slope_over_q(const T& q) {
    const T inside = max(T(1.0) - T(0.5) * q, T(0.0));
    const T square = inside * inside;
    return T(-14.0 / 3.0) * square * square * inside * (T(1.0) + T(2.5) * q);
  }
};

}  // namespace anvil
