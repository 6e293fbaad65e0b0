// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace anvil {

/// A key of a scene and the values it takes, written as in --set KEY=VALUE.
struct StudyAxis {
  std::string key;
  std::vector<std::string> values;
};

/// Published values of a measure over the values of a grid's last axis.
struct StudyReference {
  std::string measure;
  std::string file;    // CSV, in data/reference or beside the study; its first column is the axis
  std::string column;  // of the published values
  std::vector<double> axis;
  std::vector<double> values;

  /// Nothing where the table has no row for the value of the axis.
  [[nodiscard]] std::optional<double> at(const std::string& axis_value) const;
};

/// A scene run for all combinations of the values of its axes, the last axis changing fastest.
struct StudyGrid {
  std::string title;             // the scene's name when none is given
  std::string scene;             // bundled, or a file: seen from the study's folder, or as it stands
  std::vector<std::string> set;  // KEY=VALUE, for all runs
  std::vector<double> times;     // s, ascending: when the measures are taken
  std::vector<std::string> measures;
  std::vector<StudyAxis> axes;
  std::vector<StudyReference> references;
  bool against_finest = false;  // measures are deviations from the run with the finest value of the last axis
  double bound = 0.1;           // stability: the first measure beyond it is inaccurate
  double refine = 0.0;  // stability: relative width to which the limit along the last axis is bisected; 0: it is not

  [[nodiscard]] std::size_t run_count() const;
  /// The value of every axis in the run of that number.
  [[nodiscard]] std::vector<std::string> values_of(std::size_t run) const;
};

/// How the outcome of a study is printed and drawn.
enum class StudyReport { table, orders, speeds, cost, stability };

struct StudyDescription {
  std::string name;  // stem of the file
  std::string title;
  StudyReport report = StudyReport::table;
  std::vector<StudyGrid> grids;
};

/// Reads a description (TOML; docs/studies.md has the keys) and the tables it refers to. Throws one InputError with all
/// that is wrong, a line each.
StudyDescription read_study(const std::filesystem::path& file);

/// The file a user means: a path, or the name of a bundled study. Throws InputError with the nearest name.
std::filesystem::path locate_study(const std::string& argument);

}  // namespace anvil
