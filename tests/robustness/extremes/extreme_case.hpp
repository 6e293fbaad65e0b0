// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace anvil {

/// How a case has to end.
enum class Ending { answer, failure, refusal };

/// What a measure of the result has to be.
struct Expected {
  double value = 0.0;
  double within = 0.0;  // largest difference allowed
};

/// A row of cases.toml.
struct ExtremeCase {
  std::string name;
  std::string scene;             // a file of extremes/scenes
  std::vector<std::string> set;  // KEY=VALUE
  Ending ending = Ending::answer;
  std::string phrase;                     // of the message of a failure or a refusal
  std::map<std::string, Expected> holds;  // by measure, see extreme_measures.hpp
  std::vector<std::string> exact;         // KEY=VALUE that make plane.toml the one-dimensional problem with the answer
  std::vector<double> velocity_gradient;  // 1/s, row by row: times the position, added to the velocities of the start
  double scale = 0.0;                     // all lengths and times; the result is held against that at scale 1
  std::string asked;
  std::string why;
};

std::ostream& operator<<(std::ostream& stream, const ExtremeCase& extreme);

/// All rows of tests/robustness/extremes/cases.toml; throws std::runtime_error with the row that lacks something.
std::vector<ExtremeCase> extreme_cases();

/// docs/robustness.md, made from them.
std::string robustness_page(const std::vector<ExtremeCase>& cases);

}  // namespace anvil
