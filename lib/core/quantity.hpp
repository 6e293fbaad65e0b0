// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace anvil {

/// A number with a name and a unit: a column of the history in one row, a measure of a result, a reference.
struct Quantity {
  std::string name;  // snake_case, for example wall_impulse_z
  std::string unit;  // SI, "" for pure numbers
  double value = 0.0;
};

}  // namespace anvil
