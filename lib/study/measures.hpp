// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "anvil/exact/scene_reference.hpp"
#include "anvil/output/frame.hpp"
#include "anvil/output/history.hpp"
#include "anvil/scene/scene.hpp"
#include "anvil/solver/simulation.hpp"

namespace anvil {

/// A run of a study at one of its times, as measures see it.
struct StudySample {
  const Scene& scene;
  const std::vector<Frame>& frames;              // at the times of the study
  std::size_t number;                            // of the time that is measured
  std::function<const SceneReference&()> exact;  // at the same times; solved when it is asked for first
  std::vector<AuditValue> audit;                 // at the time that is measured
  const History& history;  // as `anvil run` keeps it; without rows unless a measure of the grid reads_history
  double last_time_step;   // s
  double step_cost;        // s per particle and step so far
};

/// One number that is read off a run at a time; NaN where the run does not show it.
struct StudyMeasure {
  std::string_view name;
  std::string_view unit;
  double (*of)(const StudySample& sample, std::string_view name);
};

/// The measure of that name: a row of the table of measures, which has the quantities of compare_waves as well, or one
/// of `anvil compare` (published.hpp).
std::optional<StudyMeasure> find_study_measure(std::string_view name);
std::vector<std::string_view> study_measure_names();

}  // namespace anvil
