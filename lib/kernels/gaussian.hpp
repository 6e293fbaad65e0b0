// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numbers>
#include <string_view>

#include "anvil/core/lane_math.hpp"

namespace anvil {

/// Gaussian cut at 3 h (Gingold and Monaghan 1977; cut as by Sun 2017). W(r) = normalisation(D) / h^D * value(r / h).
/// The norm is the one of the whole Gaussian, so the integral over the support falls short of one by erfc(3) = 2.2e-5
/// in 1D, exp(-9) = 1.2e-4 in 2D and erfc(3) + 6 exp(-9) / sqrt(pi) = 4.4e-4 in 3D.
struct Gaussian {
  static constexpr std::string_view name = "gaussian";
  static constexpr std::string_view summary = "Gaussian cut at 3 h, with the norm of the whole one";
  static constexpr double support = 3.0;  // in smoothing lengths, itself outside

  static constexpr double normalisation(int dimension) {
    constexpr double line = std::numbers::inv_sqrtpi;
    if (dimension == 1) return line;
    return dimension == 2 ? line * line : line * line * line;
  }

  template <class T>
  static ANVIL_INLINE T value(const T& q) {
    return select(q < T(support), exp(T(0.0) - q * q), T(0.0));
  }

  /// (dw/dq) / q.
  template <class T>
  static ANVIL_INLINE T slope_over_q(const T& q) {
    return T(-2.0) * value(q);
  }
};

}  // namespace anvil
