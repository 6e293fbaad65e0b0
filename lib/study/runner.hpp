// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "anvil/study/description.hpp"

namespace anvil {

enum class StudyStatus {
  finished,
  failed,  // a guard stopped the run
  refused  // the scene makes no sense with these values
};

/// The word for it in tables.
std::string_view status_name(StudyStatus status);

/// What a run of a study gave at one time.
struct StudyRow {
  double time = 0.0;           // s
  std::vector<double> values;  // one per measure of the grid; NaN: not to be seen
};

struct StudyRun {
  std::size_t grid = 0;
  std::vector<std::string> axis_values;
  StudyStatus status = StudyStatus::refused;
  std::string reason;          // of a run that is not finished
  std::vector<StudyRow> rows;  // up to where the run came
  std::size_t particles = 0;
  std::int64_t steps = 0;
  double seconds = 0.0;  // wall time of the steps
};

/// Told after each run how many are done, out of how many; never by two threads at once.
using StudyProgress = std::function<void(std::size_t done, std::size_t all)>;

/// Runs all grids, side by side on `threads` threads, each run on one. `set` is put on top of every run. A run that
/// fails is an outcome and keeps the others going. Returns the runs in the order of the description. Throws InputError
/// when no run of a grid can start (its scene is missing, a key does not exist), before anything runs.
std::vector<StudyRun> run_study(const StudyDescription& study, const std::vector<std::string>& set, int threads,
                                const StudyProgress& progress);

/// All runs as CSV, a line per run and time: grid, scene, axes, time, measures with their units, references, status and
/// cost.
std::string study_csv(const StudyDescription& study, const std::vector<StudyRun>& runs);

}  // namespace anvil
