// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/figures/unit.hpp"

#include <fmt/core.h>

#include <cmath>

#include "anvil/core/error.hpp"
#include "anvil/scene/nearest_name.hpp"

namespace anvil {
namespace {

// Of each SI unit the largest first: readable_unit takes the first that leaves a number of one or more.
std::vector<Unit> make_units() {
  std::vector<Unit> units = {
      {"GPa", "Pa", 1e9},      {"MPa", "Pa", 1e6},      {"kPa", "Pa", 1e3},    {"Pa", "Pa", 1.0},
      {"m", "m", 1.0},         {"cm", "m", 1e-2},       {"mm", "m", 1e-3},     {"µm", "m", 1e-6},
      {"s", "s", 1.0},         {"ms", "s", 1e-3},       {"µs", "s", 1e-6},     {"ns", "s", 1e-9},
      {"km/s", "m/s", 1e3},    {"m/s", "m/s", 1.0},     {"mm/s", "m/s", 1e-3}, {"µm/s", "m/s", 1e-6},
      {"kg/m3", "kg/m3", 1.0}, {"g/cm3", "kg/m3", 1e3}, {"MJ", "J", 1e6},      {"kJ", "J", 1e3},
      {"J", "J", 1.0},         {"mJ", "J", 1e-3},       {"J/kg", "J/kg", 1.0}, {"kJ/kg", "J/kg", 1e3},
      {"kN", "N", 1e3},        {"N", "N", 1.0},         {"kN s", "N s", 1e3},  {"N s", "N s", 1.0},
      {"kg", "kg", 1.0},       {"g", "kg", 1e-3},       {"K", "K", 1.0},       {"%", "", 1e-2},
      {"1", "", 1.0},          {"", "", 1.0},
  };
  // What is summed over the particles of a scene in two dimensions or one: summed_unit.
  const std::size_t count = units.size();
  for (const std::string depth : {"/m", "/m2"})
    for (std::size_t i = 0; i < count; ++i)
      if (const Unit unit = units[i]; unit.si == "J" || unit.si == "N" || unit.si == "N s" || unit.si == "kg")
        units.push_back({unit.name + depth, unit.si + depth, unit.factor});
  return units;
}

const std::vector<Unit>& all_units() {
  static const std::vector<Unit> units = make_units();
  return units;
}

}  // namespace

Unit find_unit(const std::string& name) {
  std::string wanted = name;
  if (wanted == "us") wanted = "µs";
  if (wanted == "um") wanted = "µm";
  std::vector<std::string_view> names;
  for (const Unit& unit : all_units()) {
    if (unit.name == wanted) return unit;
    if (!unit.name.empty()) names.push_back(unit.name);
  }
  throw InputError(fmt::format("'{}' is no unit that figures know{}", name, suggestion(name, names)));
}

Unit readable_unit(const std::string& si, double largest) {
  if (si.empty()) return {};
  const Unit* smallest = nullptr;
  for (const Unit& unit : all_units()) {
    // Centimetres and grams per cubic centimetre are there for who asks.
    if (unit.si != si || unit.name == "cm" || unit.name == "g/cm3" || unit.name == "kJ/kg") continue;
    smallest = &unit;
    if (largest >= unit.factor) return unit;
  }
  if (smallest == nullptr) return {si, si, 1.0};
  return largest == 0.0 ? Unit{si, si, 1.0} : *smallest;
}

std::string with_unit(const std::string& label, const Unit& unit) {
  if (unit.name.empty() || unit.name == "1") return label;
  std::string name = unit.name;
  if (const auto place = name.find("m3"); place != std::string::npos) name.replace(place, 2, "m³");
  if (const auto place = name.find("m2"); place != std::string::npos) name.replace(place, 2, "m²");
  return label.empty() ? fmt::format("[{}]", name) : fmt::format("{} [{}]", label, name);
}

}  // namespace anvil
