// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/comparison.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>

#include "anvil/core/error.hpp"
#include "anvil/measures/measures.hpp"
#include "anvil/scene/nearest_name.hpp"

namespace anvil {
namespace {

constexpr std::array reported_for_every_run = {"momentum_balance", "unexplained_momentum", "energy_balance",
                                               "smoothing_share", "minimum_pair_distance"};

template <class Table>
std::vector<std::string_view> names_of(const Table& table) {
  std::vector<std::string_view> names;
  for (const auto& row : table) names.push_back(row.name);
  return names;
}

void check_time(const Result& result, const Reference& reference) {
  constexpr double same_time = 1e-6;  // times in scenes and references are typed with fewer digits
  if (reference.time && std::abs(result.frame.time - *reference.time) > same_time * *reference.time)
    throw InputError(fmt::format("the last frame is at {:.6g} s, '{}' holds at {:.6g} s; run the scene to that time",
                                 result.frame.time, reference.title, *reference.time));
}

double measure(const std::string& name, const Result& result) {
  const Measure* found = find_measure(name);
  if (found == nullptr)
    throw InputError(fmt::format("nothing measures '{}'{}", name, suggestion(name, names_of(measures()))));
  return found->of(result);
}

ComparedQuantity compare_quantity(const ReferenceQuantity& reference, const Result& result) {
  const double value = measure(reference.name, result);
  return {reference.name,  reference.unit,        value,
          reference.value, reference.uncertainty, (value - reference.value) / std::abs(reference.value),
          std::nullopt};
}

ComparedQuantity compare_profile(const ReferenceProfile& reference, const Result& result) {
  const ProfileMeasure* found = find_profile_measure(reference.name);
  if (found == nullptr)
    throw InputError(fmt::format("nothing measures the profile '{}'{}", reference.name,
                                 suggestion(reference.name, names_of(profile_measures()))));
  const double distance = relative_distance(found->of(result), reference.curve);
  return {reference.name + "_profile_l2", "", distance, std::nullopt, 0.0, distance, std::nullopt};
}

}  // namespace

bool ComparedQuantity::within() const { return !allowed || std::abs(deviation) <= *allowed; }

void set_tolerances(std::vector<ComparedQuantity>& quantities, const NamedNumbers& tolerance) {
  for (const auto& [name, allowed] : tolerance) {
    bool found = false;
    for (auto& quantity : quantities) {
      if (quantity.name != name) continue;
      quantity.allowed = allowed;
      found = true;
    }
    if (!found)
      throw InputError(fmt::format("compare.tolerance.{} names nothing that is compared{}", name,
                                   suggestion(name, names_of(quantities))));
  }
}

std::vector<ComparedQuantity> compare(const Result& result, const Reference& reference, const NamedNumbers& tolerance) {
  check_time(result, reference);
  std::vector<ComparedQuantity> quantities;
  for (const auto& quantity : reference.quantities) quantities.push_back(compare_quantity(quantity, result));
  for (const auto& profile : reference.profiles) quantities.push_back(compare_profile(profile, result));
  for (const char* name : reported_for_every_run) {
    const double value = measure(name, result);
    quantities.push_back({name, std::string(find_measure(name)->unit), value, std::nullopt, 0.0, value, std::nullopt});
  }
  if (!result.scene.bodies.empty() && result.scene.bodies.front().shape.type == "ring") {
    const double circularity = measure("shell_circularity", result);
    quantities.push_back({"shell_circularity", "", circularity, std::nullopt, 0.0, circularity, std::nullopt});
  }
  set_tolerances(quantities, tolerance);
  return quantities;
}

}  // namespace anvil
