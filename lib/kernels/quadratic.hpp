// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numbers>
#include <string_view>

#include "anvil/core/lane_math.hpp"

namespace anvil {

/// Quadratic kernel (Johnson, Stryk and Beissel 1996). W(r) = normalisation(D) / h^D * value(r / h).
/// Its slope does not vanish at q = 0: close particles repel each other, and the gradient jumps where they meet.
struct Quadratic {
  static constexpr std::string_view name = "quadratic";
  static constexpr std::string_view summary = "quadratic, support 2 h, slope not zero at the centre";
  static constexpr double support = 2.0;  // in smoothing lengths

  static constexpr double normalisation(int dimension) {
    if (dimension == 1) return 0.5;
    return dimension == 2 ? 1.0 / std::numbers::pi : 5.0 / (8.0 * std::numbers::pi);
  }

  /// 3/8 q^2 - 3/2 q + 3/2 up to 2, zero beyond.
  template <class T>
  static ANVIL_INLINE T value(const T& q) {
    const T inside = max(T(2.0) - q, T(0.0));
    return T(0.375) * inside * inside;
  }

  /// (dw/dq) / q. It grows like 1/q towards the centre and is held below q = 1e-6: a gradient, this times x_ij, then
  /// goes to zero for coinciding particles instead of being undefined.
  template <class T>
  static ANVIL_INLINE T slope_over_q(const T& q) {
    return T(-0.75) * max(T(2.0) - q, T(0.0)) / max(q, T(1e-6));
  }
};

}  // namespace anvil
