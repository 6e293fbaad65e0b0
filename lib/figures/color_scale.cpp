// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/figures/color_scale.hpp"

#include <algorithm>
#include <cmath>

namespace anvil {
namespace {

constexpr std::array<Color, 5> below{{{255, 255, 255}, {171, 210, 232}, {86, 154, 204}, {33, 92, 160}, {8, 38, 91}}};
constexpr std::array<Color, 5> above{{{255, 255, 255}, {252, 205, 143}, {240, 120, 74}, {196, 38, 34}, {98, 0, 20}}};

unsigned char between(unsigned char a, unsigned char b, double share) {
  return static_cast<unsigned char>(std::lround((1.0 - share) * a + share * b));
}

}  // namespace

Color color_of(double value, const std::array<double, 2>& range) {
  const double largest = std::max(std::abs(range[0]), std::abs(range[1]));
  if (!std::isfinite(value) || largest == 0.0) return below.front();
  const auto& colors = value < 0.0 ? below : above;
  const double place =
      std::abs(std::clamp(value, range[0], range[1])) / largest * static_cast<double>(colors.size() - 1);
  const auto lower = std::min(static_cast<std::size_t>(place), colors.size() - 2);
  const double share = place - static_cast<double>(lower);
  const Color& a = colors[lower];
  const Color& b = colors[lower + 1];
  return {between(a.red, b.red, share), between(a.green, b.green, share), between(a.blue, b.blue, share)};
}

Color curve_color(std::size_t number) {
  constexpr std::array<Color, 7> colors{
      {{0, 114, 178}, {213, 94, 0}, {0, 158, 115}, {204, 121, 167}, {230, 159, 0}, {86, 180, 233}, {0, 0, 0}}};
  return colors[number % colors.size()];
}

}  // namespace anvil
