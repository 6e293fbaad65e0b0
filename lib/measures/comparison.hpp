// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "anvil/measures/reference.hpp"
#include "anvil/measures/result.hpp"

namespace anvil {

/// A quantity of a result beside its reference.
struct ComparedQuantity {
  std::string name;
  std::string unit;
  double value = 0.0;               // NaN: not to be seen in the result, which no tolerance allows
  std::optional<double> reference;  // absent: only reported
  double uncertainty = 0.0;         // of the reference
  double deviation = 0.0;           // relative to the reference; the value itself where there is none
  std::optional<double> allowed;    // largest absolute deviation; absent: not judged
  std::optional<double> time = {};  // s, of the frame; absent: the last one, or the whole run

  [[nodiscard]] bool within() const;
};

/// Measures every quantity and profile of the reference (as <profile>_profile_l2: its relative distance) and adds what
/// every run is judged by: momentum, energy, the share of the smoothing, the smallest pair distance. `tolerance` holds
/// the largest deviation allowed for some of them. Throws InputError when the reference or a tolerance names what
/// nobody measures, or the result ends at another time than the reference.
std::vector<ComparedQuantity> compare(const Result& result, const Reference& reference, const NamedNumbers& tolerance);

/// Sets the largest deviation allowed for all quantities of each name. Throws InputError for a name that none has.
void set_tolerances(std::vector<ComparedQuantity>& quantities, const NamedNumbers& tolerance);

}  // namespace anvil
