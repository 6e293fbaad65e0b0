// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "anvil/figures/figure.hpp"

namespace anvil {

// A figure after layout. Everything is in pixels from the lower left corner.

struct Box {
  double left = 0.0, bottom = 0.0, right = 0.0, top = 0.0;
  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return top - bottom; }
};

struct Dot {
  double x, y;
};

struct DrawnLine {
  std::vector<Dot> dots;
  Color color;
  double width = 1.0;
  std::optional<Box> clip;
};

struct DrawnPoints {
  std::vector<Dot> dots;
  Color color;
  double radius = 1.0;
  std::optional<Box> clip;
};

enum class Anchor { left, centre, right };

/// `at` is at half the height of the letters; upright texts run along y, upward.
struct DrawnText {
  std::string text;
  Dot at{};
  double size = 10.0;  // of the font
  Anchor anchor = Anchor::left;
  bool upright = false;
};

/// Colours cell by cell, the lowest row first.
struct DrawnImage {
  Box box;
  std::size_t columns = 0, rows = 0;
  std::vector<Color> cells;
};

using DrawnShape = std::variant<DrawnImage, DrawnLine, DrawnPoints, DrawnText>;

/// Shapes in the order in which they cover each other, on white.
struct Drawing {
  std::array<int, 2> size{};
  std::vector<DrawnShape> shapes;
};

/// Places panels, axes, ticks, legends and curves. Throws InputError when something cannot be drawn: no panel, a size
/// out of range, a logarithmic axis with nothing above zero, an empty range.
Drawing lay_out(const Figure& figure);

/// The drawing as an SVG document, lettered in DejaVu Sans.
std::string write_svg(const Drawing& drawing);

}  // namespace anvil
