// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/figures/expression.hpp"

#include <fmt/core.h>
#include <muParser.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "anvil/core/error.hpp"
#include "anvil/scene/nearest_name.hpp"

namespace anvil {
namespace {

void add_components(const std::string& name, const std::string& unit, int components, const std::vector<double>& values,
                    std::vector<NamedValues>& names) {
  constexpr std::array<std::string_view, 3> axes = {"x", "y", "z"};
  constexpr std::array<std::string_view, 6> pairs = {"xx", "yy", "zz", "xy", "yz", "xz"};
  const auto stride = static_cast<std::size_t>(components);
  for (std::size_t c = 0; c < stride; ++c) {
    std::string full = name;
    if (components == 3) full = fmt::format("{}.{}", name, axes[c]);
    if (components == 6) full = fmt::format("{}.{}", name, pairs[c]);
    names.push_back({full, unit, values.data() + c, stride, values.size() / stride});
  }
}

/// The variables of a parser, filled value by value.
struct Variable {
  const NamedValues* source;
  double value = 0.0;
};

/// Whether the result of an expression has the unit of its names: sums do, products and roots do not.
bool keeps_unit(const std::string& expression) {
  if (expression.find_first_of("*/^") != std::string::npos) return false;
  return expression.find("sqrt") == std::string::npos && expression.find("log") == std::string::npos &&
         expression.find("exp") == std::string::npos;
}

[[noreturn]] void refuse_name(const std::string& name, std::span<const NamedValues> names) {
  std::vector<std::string_view> known;
  for (const auto& one : names) known.push_back(one.name);
  throw InputError(fmt::format("there is nothing called '{}' to draw{}", name, suggestion(name, known)));
}

}  // namespace

std::vector<NamedValues> fields_of(const Frame& frame) {
  std::vector<NamedValues> names;
  add_components("position", "m", 3, frame.positions, names);
  for (const auto& array : frame.arrays) add_components(array.name, array.unit, array.components, array.values, names);
  return names;
}

std::vector<NamedValues> columns_of(const History& history) {
  std::vector<NamedValues> names;
  for (const auto& column : history.columns())
    names.push_back({column.name, column.unit, column.values.data(), 1, column.values.size()});
  return names;
}

Evaluated evaluate(const std::string& expression, std::span<const NamedValues> names) {
  try {
    mu::Parser parser;
    parser.DefineNameChars("0123456789_.abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");
    parser.SetExpr(expression);
    std::vector<Variable> variables;
    for (const auto& used : parser.GetUsedVar()) {
      const std::string& name = used.first;
      const auto found = std::find_if(names.begin(), names.end(), [&](const auto& one) { return one.name == name; });
      if (found == names.end()) refuse_name(name, names);
      variables.push_back({&*found});
    }
    Evaluated result;
    std::size_t count = names.empty() ? 0 : names.front().count;
    if (!variables.empty() && keeps_unit(expression)) result.unit = variables.front().source->unit;
    for (auto& variable : variables) {
      parser.DefineVar(variable.source->name, &variable.value);
      if (variable.source->unit != result.unit) result.unit.clear();
      count = variable.source->count;
    }
    for (std::size_t i = 0; i < count; ++i) {
      for (auto& variable : variables) variable.value = variable.source->first[i * variable.source->stride];
      result.values.push_back(parser.Eval());
    }
    return result;
  } catch (const mu::Parser::exception_type& error) {
    throw InputError(fmt::format("cannot compute '{}': {}", expression, error.GetMsg()));
  }
}

}  // namespace anvil
