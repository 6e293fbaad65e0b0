// SPDX-License-Identifier: BSD-3-Clause
#include "option_values.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

[[noreturn]] void refuse_plane(const std::string& option, const std::string& text) {
  throw InputError(fmt::format("--{} takes a plane such as z=0.01, or point:normal such as 0,0,0.01:0,0,1, found '{}'",
                               option, text));
}

}  // namespace

std::vector<double> numbers_of(const std::string& option, const std::string& text, char separator, std::size_t count) {
  std::vector<double> numbers;
  const char* const end = text.data() + text.size();
  for (const char* place = text.data();;) {
    double number = 0.0;
    const auto [next, error] = std::from_chars(place, end, number);
    if (error != std::errc() || (next != end && *next != separator) || !std::isfinite(number)) break;
    numbers.push_back(number);
    if (next == end) {
      if (count != 0 && numbers.size() != count) break;
      return numbers;
    }
    place = next + 1;
  }
  throw InputError(fmt::format("--{} takes {} with '{}' between them, found '{}'", option,
                               count == 0 ? "numbers" : fmt::format("{} numbers", count), separator, text));
}

std::array<double, 3> point_of(const std::string& option, const std::string& text) {
  auto numbers = numbers_of(option, text, ',', 0);
  if (numbers.size() > 3)
    throw InputError(fmt::format("--{} takes up to three numbers, found {}", option, numbers.size()));
  numbers.resize(3, 0.0);
  return {numbers[0], numbers[1], numbers[2]};
}

std::array<std::array<double, 3>, 2> line_of(const std::string& option, const std::string& text) {
  const auto colon = text.find(':');
  if (colon == std::string::npos)
    throw InputError(fmt::format("--{} takes two points, as 0,0,0:0,0,0.03, found '{}'", option, text));
  return {point_of(option, text.substr(0, colon)), point_of(option, text.substr(colon + 1))};
}

Plane plane_of(const std::string& option, const std::string& text) {
  constexpr std::string_view axes = "xyz";
  Plane plane;
  if (text.size() > 2 && text[1] == '=') {
    const std::size_t axis = axes.find(text[0]);
    if (axis == std::string_view::npos) refuse_plane(option, text);
    plane.point = {0.0, 0.0, 0.0};
    plane.normal = {0.0, 0.0, 0.0};
    plane.point[axis] = numbers_of(option, text.substr(2), ',', 1).front();
    plane.normal[axis] = 1.0;
    return plane;
  }
  const auto colon = text.find(':');
  if (colon == std::string::npos) refuse_plane(option, text);
  plane = {point_of(option, text.substr(0, colon)), point_of(option, text.substr(colon + 1))};
  if (std::hypot(plane.normal[0], plane.normal[1], plane.normal[2]) == 0.0) refuse_plane(option, text);
  return plane;
}

}  // namespace anvil
