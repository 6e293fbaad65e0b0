// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "anvil/study/runner.hpp"

namespace anvil {

/// The runs of one grid, in the order of its axes. Keeps references to study and runs.
class RunTable {
 public:
  RunTable(const StudyDescription& study, const std::vector<StudyRun>& runs, std::size_t grid);

  [[nodiscard]] const StudyGrid& grid() const { return grid_; }
  [[nodiscard]] const std::vector<const StudyRun*>& runs() const { return runs_; }
  [[nodiscard]] const StudyRun& run(std::size_t number) const { return *runs_[number]; }
  [[nodiscard]] std::size_t measure_number(const std::string& measure) const;

  /// What a run gave for a measure at a time; NaN where it did not come so far.
  [[nodiscard]] double value(std::size_t run, std::size_t time, std::size_t measure) const;
  /// The value of the last axis in a run as a number, NaN when it is none.
  [[nodiscard]] double last_axis(std::size_t run) const;
  /// Observed order of the first measure between the run before and this one.
  [[nodiscard]] double order(std::size_t run, std::size_t time) const;

 private:
  const StudyGrid& grid_;
  std::vector<const StudyRun*> runs_;
};

}  // namespace anvil
