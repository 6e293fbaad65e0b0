// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace anvil {

struct Color {
  unsigned char red = 0, green = 0, blue = 0;
  bool operator==(const Color&) const = default;
};

/// One axis of a panel. Values are in the unit that the label names.
struct Axis {
  std::string label;
  bool logarithmic = false;
  std::optional<std::array<double, 2>> range = {};  // absent: from what is drawn, rounded outward
};

enum class CurveStyle { line, points, reference /* a wide grey line below the others */ };

/// Points in the units of the axes; where x or y is not finite the line is interrupted.
struct PlottedCurve {
  std::string label;  // in the legend; empty: not there
  CurveStyle style = CurveStyle::line;
  Color color;
  std::vector<double> x, y;
  double point_size = 1.0;                     // over the usual one
  std::vector<std::string> point_labels = {};  // beside the points, as far as there is room; as many as points, or none
};

/// A field over both axes, as coloured cells.
struct PlottedMap {
  std::string label;           // of the colour bar, with its unit
  std::array<double, 2> x, y;  // edges of the whole, in the units of the axes
  std::size_t columns = 0, rows = 0;
  std::vector<double> values;   // columns x rows, the lowest row first; NaN stays white
  std::array<double, 2> range;  // of the colours
};

struct Panel {
  std::string title;
  bool equal_scales = false;  // a unit of x as long as one of y: the frame takes less of its room
  Axis x, y;
  std::vector<PlottedCurve> curves;
  std::optional<PlottedMap> map;
};

/// A figure as plain numbers and texts: what every painter draws.
struct Figure {
  std::string title;
  std::array<int, 2> size{1600, 1200};  // pixels
  int columns = 1;                      // panels side by side, filled row by row
  std::vector<Panel> panels;
};

}  // namespace anvil
