// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace anvil {

/// Empty texts and lists stand for what follows from the data.
struct AxisDescription {
  std::string quantity;  // of x: a field or an expression of fields along which profiles are drawn
  std::string label;     // without the unit
  std::string unit;      // such as GPa or mm
  bool logarithmic = false;
  std::vector<double> range;  // two numbers in `unit`
};

/// Out of `field`, `history` and `file` exactly one is given.
struct CurveDescription {
  std::string field;          // of particles: a name, a component, or an expression
  std::vector<double> times;  // s, of the frames; empty: the last one
  std::string where;          // an expression: only particles for which it is not 0
  std::vector<double> line;   // x, y, z of both ends, m: the field on that line, between the particles
  bool exact = false;         // with the exact solution of the scene below it
  std::string history;        // a column of history.csv, or an expression of columns
  std::string file;           // a CSV file, beside the description
  std::string x_column, y_column;
  std::string label;
  std::string style;  // line, points, reference, wall; empty: points for scattered particles, else a line
};

/// A field over position and time, from all frames.
struct MapDescription {
  std::string field;
  std::string label;
  std::string unit;
  std::vector<double> range;  // two numbers in `unit`
};

struct PanelDescription {
  std::string title;
  bool equal_scales = false;  // a length is as long along x as along y
  AxisDescription x, y;
  std::vector<CurveDescription> curves;
  std::optional<MapDescription> map;
};

/// What a figure shows, without the results it is drawn from.
struct FigureDescription {
  std::string title;
  int width = 0, height = 0;  // pixels; 0: from the number of panels
  int columns = 1;
  std::vector<PanelDescription> panels;
  std::filesystem::path folder;  // where its CSV files lie
};

/// Reads a description (TOML; docs/figures.md has the keys). Throws one InputError with all that is wrong, a line each:
/// `file:line:column: key '...' must be ..., found ...`.
FigureDescription read_figure_description(const std::filesystem::path& file);
FigureDescription read_figure_description_text(const std::string& text, const std::string& file);

/// The file a user means: a path, or the name of a bundled description. Throws InputError with the nearest name.
std::filesystem::path locate_figure(const std::string& argument);

}  // namespace anvil
