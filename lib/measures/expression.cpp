// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/expression.hpp"

#include <fmt/core.h>
#include <muParser.h>

#include <algorithm>
#include <string_view>

#include "anvil/core/error.hpp"
#include "anvil/scene/nearest_name.hpp"

namespace anvil {
namespace {

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

[[noreturn]] void refuse_expression(const std::string& expression, const mu::Parser::exception_type& error) {
  throw InputError(fmt::format("cannot compute '{}': {}", expression, error.GetMsg()));
}

mu::Parser make_parser(const std::string& expression) {
  mu::Parser parser;
  parser.DefineNameChars("0123456789_.abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");
  parser.SetExpr(expression);
  return parser;
}

}  // namespace

std::vector<NamedValues> columns_of(const History& history) {
  std::vector<NamedValues> names;
  for (const auto& column : history.columns())
    names.push_back({column.name, column.unit, column.values.data(), 1, column.values.size()});
  return names;
}

std::vector<std::string> used_names(const std::string& expression) {
  try {
    const mu::Parser parser = make_parser(expression);
    std::vector<std::string> names;
    for (const auto& used : parser.GetUsedVar()) names.push_back(used.first);
    return names;
  } catch (const mu::Parser::exception_type& error) {
    refuse_expression(expression, error);
  }
}

Evaluated evaluate(const std::string& expression, std::span<const NamedValues> names) {
  try {
    mu::Parser parser = make_parser(expression);
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
    result.values.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      for (auto& variable : variables) variable.value = variable.source->first[i * variable.source->stride];
      result.values.push_back(parser.Eval());
    }
    return result;
  } catch (const mu::Parser::exception_type& error) {
    refuse_expression(expression, error);
  }
}

}  // namespace anvil
