// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/exact/plate_reference.hpp"

#include <algorithm>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

// Of the stress scale. Beyond it little would be left of the solution.
constexpr double coarsest_step = 0.25;

/// Both together: see reference_accuracy.
void coarsen(TrackingAccuracy& accuracy) {
  accuracy.step *= 2.0;
  accuracy.smallest *= 2.0;
}

std::vector<WaveProfile> track(const PlateProblem& problem, const std::vector<double>& times,
                               const TrackingAccuracy& accuracy) {
  FrontTracking fronts(problem, times.back(), accuracy);
  std::vector<WaveProfile> profiles;
  for (const double time : times) {
    fronts.advance_to(time);
    profiles.push_back(fronts.profile());
  }
  return profiles;
}

/// Coarsens the accuracy until the waves are few enough.
std::vector<WaveProfile> track_what_fits(const PlateProblem& problem, const std::vector<double>& times,
                                         TrackingAccuracy& accuracy) {
  for (;; coarsen(accuracy)) {
    try {
      return track(problem, times, accuracy);
    } catch (const TooManyFronts&) {
      if (2.0 * accuracy.step > coarsest_step) throw;
    }
  }
}

/// Steps are stairs of what changes smoothly where the coarser run differs; where it does not, both are exact and every
/// jump is a front. Returns the difference of the two over the mean stress.
double finish(WaveProfile& profile, const TrackingAccuracy& accuracy, WaveProfile& coarser,
              const TrackingAccuracy& coarse, double scale) {
  constexpr double slack = 1.6;  // a step of a spreading wave may be half a step longer than asked for
  constexpr double round_off = 1e-12;
  const double mean = mean_stress(profile);
  if (!(mean > 0.0)) return 0.0;
  const double stairs = mean_stress_difference(profile, coarser) / mean;
  if (stairs < round_off) return stairs;
  profile.smooth_jump = slack * accuracy.step * scale;
  coarser.smooth_jump = slack * coarse.step * scale;
  return sampled_stress_difference(profile, coarser) / mean;
}

}  // namespace

PlateReference solve_plate(const PlateProblem& problem, const std::vector<double>& times,
                           const TrackingAccuracy& accuracy) {
  if (times.empty() || !std::is_sorted(times.begin(), times.end()) || times.front() < 0.0)
    throw InputError("the times of an exact solution begin at 0 or later and ascend");
  PlateReference reference;
  reference.accuracy = accuracy;
  reference.profiles = track_what_fits(problem, times, reference.accuracy);

  TrackingAccuracy coarse = reference.accuracy;
  coarsen(coarse);
  std::vector<WaveProfile> coarser = track_what_fits(problem, times, coarse);
  const double scale = problem.stress_scale();
  for (std::size_t i = 0; i < times.size(); ++i)
    reference.relative_errors.push_back(finish(reference.profiles[i], reference.accuracy, coarser[i], coarse, scale));
  return reference;
}

}  // namespace anvil
