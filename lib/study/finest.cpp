// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/study/finest.hpp"

#include <algorithm>
#include <cmath>

namespace anvil {
namespace {

bool same_but_for_last_axis(const StudyRun& a, const StudyRun& b) {
  return a.grid == b.grid && std::equal(a.axis_values.begin(), a.axis_values.end() - 1, b.axis_values.begin());
}

double particle_steps(const StudyRun& run) {
  return static_cast<double>(run.steps) * static_cast<double>(run.particles);
}

const StudyRun* finest_of(const std::vector<StudyRun>& runs, const StudyRun& run) {
  const StudyRun* finest = nullptr;
  for (const auto& other : runs)
    if (other.status == StudyStatus::finished && same_but_for_last_axis(run, other) &&
        (finest == nullptr || particle_steps(other) > particle_steps(*finest)))
      finest = &other;
  return finest;
}

}  // namespace

void compare_with_finest(const StudyDescription& study, std::vector<StudyRun>& runs) {
  const std::vector<StudyRun> measured = runs;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (!study.grids[runs[k].grid].against_finest) continue;
    const StudyRun* const finest = finest_of(measured, measured[k]);
    for (std::size_t row = 0; row < runs[k].rows.size(); ++row)
      for (std::size_t m = 0; m < runs[k].rows[row].values.size(); ++m) {
        double& value = runs[k].rows[row].values[m];
        const bool has_partner = finest != nullptr && finest != &measured[k] && row < finest->rows.size();
        value = has_partner ? std::abs(value / finest->rows[row].values[m] - 1.0) : std::nan("");
      }
  }
}

}  // namespace anvil
