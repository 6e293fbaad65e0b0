// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace anvil {

/// A unit that figures can be in.
struct Unit {
  std::string name;  // as it is printed: "GPa", "µs"
  std::string si;    // the SI unit it is a multiple of: "Pa"
  double factor = 1.0;
};

/// The unit of that name; "us" stands for µs and "um" for µm. Any name of an SI unit of a field or a history column is
/// its own. Throws InputError with the nearest one.
Unit find_unit(const std::string& name);

/// The unit in which values of that SI unit up to `largest` read best.
Unit readable_unit(const std::string& si, double largest);

/// "Axial stress [GPa]".
std::string with_unit(const std::string& label, const Unit& unit);

}  // namespace anvil
