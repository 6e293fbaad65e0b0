// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>

#include "anvil/measures/curve.hpp"
#include "anvil/measures/result.hpp"

namespace anvil {

/// One number that is read off a result. Its name is that of a [[quantity]] in data/reference. NaN says that the result
/// does not show it: an event that has not come by the end.
struct Measure {
  std::string_view name;
  std::string_view unit;
  double (*of)(const Result& result);
};

/// A line that is read off a result. Its name is that of a [[profile]] in data/reference.
struct ProfileMeasure {
  std::string_view name;
  Curve (*of)(const Result& result);
};

/// The tables of measures. A new one is a row in one of them.
std::span<const Measure> measures();
std::span<const ProfileMeasure> profile_measures();

/// The row of that name, or nullptr.
const Measure* find_measure(std::string_view name);
const ProfileMeasure* find_profile_measure(std::string_view name);

}  // namespace anvil
