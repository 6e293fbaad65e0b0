// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "anvil/exact/front_tracking.hpp"

namespace anvil {

/// Profiles of a plate by front tracking, each with its error as measured by a coarser run.
struct PlateReference {
  std::vector<WaveProfile> profiles;    // in the order of the times asked for
  std::vector<double> relative_errors;  // mean |stress difference to the coarser run| / mean |stress|
  TrackingAccuracy accuracy;            // of the profiles
};

/// Accuracy and effort of solve_plate when nothing else is asked for. Waves a hundredth of a step are followed because
/// a plastic front reflects about a tenth of an elastic wave: fewer, and what it reflects of a smooth load is lost at
/// every step, an error that does not shrink with the step.
inline constexpr TrackingAccuracy reference_accuracy{
    .step = 1.0 / 512.0, .smallest = 1.0 / 51200.0, .most_events = 300'000};

/// `times` in s, ascending. When waves grow too many for `accuracy.most_events`, which some problems do without limit
/// once reflected waves cross plastic fronts, step and smallest wave are doubled until they fit; the error says what
/// that costs. The coarser run has twice the step and twice the smallest wave. Throws InputError and NumericalError.
PlateReference solve_plate(const PlateProblem& problem, const std::vector<double>& times,
                           const TrackingAccuracy& accuracy = reference_accuracy);

}  // namespace anvil
