// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "anvil/figures/figure.hpp"

namespace anvil {

/// White at zero, blue below and red above it, darkest at the end of `range` that reaches further: the sign of a stress
/// shows. NaN is white, values outside have the colour of the end.
Color color_of(double value, const std::array<double, 2>& range);

/// Colours that can be told apart, also by most who do not see red and green (Okabe and Ito 2008), again from the first
/// after the last.
Color curve_color(std::size_t number);

}  // namespace anvil
