// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/balance.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

constexpr std::array axes = {"x", "y", "z"};

double largest(const std::vector<double>& values) {
  double found = 0.0;
  for (const double value : values) found = std::max(found, std::abs(value));
  return found;
}

/// Largest component of the momentum in the run, N s, or what it would be if all of the mass moved one way with the
/// largest kinetic energy: bodies that meet head on have next to no momentum together.
double momentum_scale(const History& history) {
  double scale = 0.0;
  bool known = false;
  for (const char* axis : axes)
    if (const HistoryColumn* momentum = history.find(std::string("momentum_") + axis)) {
      scale = std::max(scale, largest(momentum->values));
      known = true;
    }
  if (!known) throw InputError("the history has no momentum: it cannot be judged");
  const HistoryColumn *mass = history.find("mass"), *kinetic = history.find("kinetic_energy");
  if (mass == nullptr || kinetic == nullptr) return scale;
  return std::max(scale, std::sqrt(2.0 * largest(mass->values) * largest(kinetic->values)));
}

/// From the first to the last row; 0 when the scene has nothing that this column counts.
double change_of(const History& history, const std::string& name) {
  const HistoryColumn* column = history.find(name);
  return column == nullptr || column->values.empty() ? 0.0 : column->values.back() - column->values.front();
}

/// Largest energy in the run, J. The total of what falls may be near zero all the time: its potential energy is not.
double energy_scale(const History& history) {
  double scale = largest(required_column(history, "total_energy"));
  if (const HistoryColumn* potential = history.find("potential_energy"))
    scale = std::max(scale, largest(potential->values));
  return scale;
}

/// 0 for nothing out of nothing: the balance of a scene at rest.
double relative(double value, double scale) { return value == 0.0 ? 0.0 : value / scale; }

}  // namespace

const std::vector<double>& required_column(const History& history, const std::string& name) {
  const HistoryColumn* column = history.find(name);
  if (column == nullptr || column->values.empty())
    throw InputError(fmt::format("the history has no column '{}', or no rows: it cannot be judged", name));
  return column->values;
}

std::vector<BalancePart> energy_parts(const History& history) {
  std::vector<BalancePart> parts;
  for (const auto& column : history.columns())
    if (column.unit.starts_with("J") && !column.values.empty())
      parts.push_back({column.name, column.values.front(), column.values.back()});
  return parts;
}

double energy_balance(const Result& result) {
  const auto& total = required_column(result.history, "total_energy");
  const double worked = change_of(result.history, "pressure_work") + change_of(result.history, "wall_work");
  return relative(total.back() - total.front() - worked, energy_scale(result.history));
}

double smoothing_share(const Result& result) {
  const HistoryColumn* loss = result.history.find("smoothing_loss");
  return loss == nullptr ? 0.0 : relative(loss->values.back(), energy_scale(result.history));
}

double momentum_balance(const Result& result) {
  double worst = 0.0;
  for (const char* axis : axes) {
    const HistoryColumn* momentum = result.history.find(std::string("momentum_") + axis);
    if (momentum == nullptr) continue;  // an axis the scene does not have
    required_column(result.history, std::string("wall_impulse_") + axis);
    const double pushed = change_of(result.history, std::string("wall_impulse_") + axis) +
                          change_of(result.history, std::string("pressure_impulse_") + axis) +
                          change_of(result.history, std::string("gravity_impulse_") + axis);
    worst = std::max(worst, std::abs(momentum->values.back() - momentum->values.front() - pushed));
  }
  return relative(worst, momentum_scale(result.history));
}

double unexplained_momentum(const Result& result) {
  return relative(required_column(result.history, "momentum_error").back(), momentum_scale(result.history));
}

double minimum_pair_distance(const Result& result) {
  const auto& distances = required_column(result.history, "minimum_pair_distance");
  return *std::min_element(distances.begin(), distances.end()) / result.scene.discretisation.spacing;
}

}  // namespace anvil
