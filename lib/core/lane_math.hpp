// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "anvil/core/inline.hpp"

namespace anvil {

// The functions which branchless code asks of its number type, for double: a vector of lanes brings its own, found by
// argument-dependent lookup. std::max and std::min would do, but are templates that may be emitted out of line.
ANVIL_INLINE double max(double a, double b) { return a < b ? b : a; }
ANVIL_INLINE double min(double a, double b) { return b < a ? b : a; }
ANVIL_INLINE double sqrt(double a) { return std::sqrt(a); }
ANVIL_INLINE double exp(double a) { return std::exp(a); }
ANVIL_INLINE double select(bool condition, double if_true, double if_false) { return condition ? if_true : if_false; }
ANVIL_INLINE bool any(bool condition) { return condition; }

}  // namespace anvil
