// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "anvil/measures/mirror.hpp"

namespace anvil {

/// The numbers of an option such as --size 800x600; `count` 0 stands for any number of them. Throws InputError naming
/// the option.
std::vector<double> numbers_of(const std::string& option, const std::string& text, char separator, std::size_t count);

/// A point or a direction: x,y,z; what is left out is 0.
std::array<double, 3> point_of(const std::string& option, const std::string& text);

/// The two ends of a line: x,y,z:x,y,z.
std::array<std::array<double, 3>, 2> line_of(const std::string& option, const std::string& text);

/// A plane: "z=0.01", or a point and a normal, "0,0,0.01:0,0,1".
Plane plane_of(const std::string& option, const std::string& text);

}  // namespace anvil
