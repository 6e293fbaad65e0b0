// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "anvil/scene/scene.hpp"
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
  std::optional<Scene> scene;  // absent when it is refused
  std::vector<std::string> axis_values;
  StudyStatus status = StudyStatus::refused;
  std::string reason;          // of a run that is not finished
  std::vector<StudyRow> rows;  // up to where the run came
  std::size_t particles = 0;
  std::int64_t steps = 0;
  double neighbours = 0.0;  // of a particle, at the start
  int threads = 1;          // by the axis `threads`
  double seconds = 0.0;     // wall time of the steps
  // CPU time of the steps, on several threads their wall time; the least of three where it is short.
  double cpu_seconds = 0.0;
  bool known = false;  // from an earlier start of the study: not to be run again
};

/// The axis that is no key of a scene: on how many threads a run takes its steps.
inline constexpr std::string_view threads_axis = "threads";
[[nodiscard]] bool has_threads_axis(const StudyGrid& grid);

/// How far a study is.
struct StudyPosition {
  std::size_t done = 0, all = 0;  // runs
  double share = 0.0;             // of the work to be done now, by what the runs are expected to cost
};
/// Told after each run; never by two threads at once.
using StudyProgress = std::function<void(const StudyPosition& position)>;
/// Receives every run that has ended; never two at once.
using StudyKeeper = std::function<void(const StudyRun& run)>;

/// The runs of all grids in the order of the description, with `set` (KEY=VALUE) on top of every scene, ready to start.
/// Scenes that make no sense with their values are refused and keep their place. Throws InputError when this holds for
/// a whole grid (its scene is missing, a key does not exist), and when `set` names an axis.
std::vector<StudyRun> prepare_study(const StudyDescription& study, const std::vector<std::string>& set);

/// Runs what is prepared and not known, side by side on `threads` threads, each run on one, the longest first. Grids
/// with an axis `threads` come after that, one run at a time. A run that fails is an outcome and keeps the others
/// going.
void run_study(const StudyDescription& study, std::vector<StudyRun>& runs, int threads, const StudyProgress& progress,
               const StudyKeeper& keep = {});

/// All runs as CSV, a line per run and time: grid, scene, axes, time, measures with their units, references, status and
/// cost.
std::string study_csv(const StudyDescription& study, const std::vector<StudyRun>& runs);

}  // namespace anvil
