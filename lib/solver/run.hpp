// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "anvil/output/provenance.hpp"
#include "anvil/output/result_folder.hpp"
#include "anvil/solver/simulation.hpp"

namespace anvil {

/// How far a run has come.
struct RunPosition {
  double time = 0.0;       // s
  double end = 0.0;        // s
  double time_step = 0.0;  // s, the last one
  std::int64_t step = 0;
  double fraction = 0.0;      // of what this start has to do, 0 to 1
  double wall_seconds = 0.0;  // since this start
};

/// Told about every step; shows what it likes.
class Progress {
 public:
  Progress() = default;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  virtual ~Progress() = default;
  virtual void show(const RunPosition& position) = 0;
};

/// Where a run goes on that was restored from a checkpoint.
struct RestartPoint {
  int next_frame = 0;
  std::int64_t history_rows = 0;
};

struct RunOptions {
  ResultFolder folder;
  std::string scene_text;               // the resolved scene, TOML
  std::optional<RestartPoint> restart;  // the simulation then stands restored
  /// Asked before every step; true ends the run with a checkpoint.
  std::function<bool()> stop_requested = [] { return false; };
};

/// Runs a simulation to the end of its scene.
///
/// Frames are written at time 0, at every multiple of output.interval, and at time.end: steps are shortened to meet
/// these times. History rows are written with each frame and at the first step in each of 2000 equal parts of the run,
/// checkpoints at the first step in each checkpoint_interval and at the end; neither changes a step, and all of them
/// follow from the time alone. So a run that is restored from a checkpoint writes the same bits as one that was never
/// interrupted.
///
/// run.json says "running" at the start, and "finished", "stopped" or "failed" with the reason at the end; it is
/// returned. A NumericalError is thrown on with the last good frame added to its message; everything written before it
/// stays readable.
Provenance run(Simulation& simulation, const Scene& scene, const RunOptions& options, FrameWriter& frames,
               Progress& progress);

}  // namespace anvil
