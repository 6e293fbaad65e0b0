// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

#include "anvil/output/history.hpp"

namespace anvil {

/// Numbers under a name, `stride` apart: one component of a field, or a column.
struct NamedValues {
  std::string name;
  std::string unit;  // SI
  const double* first;
  std::size_t stride;
  std::size_t count;
};

/// The columns of a history by their names; they point into it.
std::vector<NamedValues> columns_of(const History& history);

/// The result of an expression, and its SI unit as far as it is plain: that of the names in a sum, else "".
struct Evaluated {
  std::vector<double> values;
  std::string unit;
};

/// The names in an expression, each once. Throws InputError when it cannot be read.
std::vector<std::string> used_names(const std::string& expression);

/// Value by value: names, numbers, + - * / ^, parentheses and functions such as abs, sqrt, max, log10 (muParser).
/// Throws InputError, with the nearest known name where a name is unknown.
Evaluated evaluate(const std::string& expression, std::span<const NamedValues> names);

}  // namespace anvil
