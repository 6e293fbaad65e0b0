// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace anvil {

/// The unit of a mass, momentum, force or energy of all particles: per metre of depth in plane strain, per square metre
/// of a plate. Every other unit stays as it is.
inline std::string summed_unit(std::string_view unit, int dimension) {
  const bool summed = unit == "kg" || unit == "N s" || unit == "N" || unit == "J";
  if (!summed || dimension == 3) return std::string(unit);
  return std::string(unit) + (dimension == 2 ? "/m" : "/m2");
}

}  // namespace anvil
