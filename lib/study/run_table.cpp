// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/study/run_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace anvil {

RunTable::RunTable(const StudyDescription& study, const std::vector<StudyRun>& runs, std::size_t grid)
    : grid_(study.grids.at(grid)) {
  for (const auto& run : runs)
    if (run.grid == grid) runs_.push_back(&run);
}

std::size_t RunTable::measure_number(const std::string& measure) const {
  return static_cast<std::size_t>(std::ranges::find(grid_.measures, measure) - grid_.measures.begin());
}

double RunTable::value(std::size_t run, std::size_t time, std::size_t measure) const {
  const auto& rows = runs_[run]->rows;
  if (time >= rows.size() || measure >= rows[time].values.size()) return std::nan("");
  return rows[time].values[measure];
}

double RunTable::last_axis(std::size_t run) const {
  const std::string& text = runs_[run]->axis_values.back();
  double number = 0.0;
  const char* const end = text.data() + text.size();
  return std::from_chars(text.data(), end, number).ptr == end ? number : std::nan("");
}

double RunTable::order(std::size_t run, std::size_t time) const {
  return std::log(value(run, time, 0) / value(run - 1, time, 0)) / std::log(last_axis(run) / last_axis(run - 1));
}

}  // namespace anvil
