// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "anvil/measures/sample_places.hpp"
#include "anvil/output/frame.hpp"
#include "anvil/study/report.hpp"

namespace anvil {

/// How a run ended, the best first.
enum class Outcome {
  stable,
  inaccurate,     // the first measure beyond the bound of its grid
  energy_growth,  // energy_balance beyond 25 %
  clumping,       // minimum_pair_distance below a fiftieth of the spacing
  penetration,    // a particle beyond a wall
  step_collapse,  // time.minimum_step_fraction
  not_a_number,   // position, density, pressure without meaning
  inversion,      // an edge between total Lagrangian particles turned inside out
  refused         // not run, or not to be measured
};
constexpr int outcome_count = 9;

std::string_view outcome_name(Outcome outcome);
/// By the reason of a run that a guard stopped, else by its measures at the last time, as far as the grid has them.
Outcome outcome_of(const StudyGrid& grid, const StudyRun& run);

/// The largest time.cfl that von Neumann's analysis of the discrete operator allows in a scene, without viscosity; NaN
/// for total_lagrangian, whose operator is another one.
double analytic_cfl(const Scene& scene);

/// Per grid the outcomes, the first axis down and the second across.
std::vector<StudyTable> stability_tables(const StudyDescription& study, const std::vector<StudyRun>& runs);
/// A panel per grid with two numeric axes: a dot per run, coloured by its outcome, and the analytic limit where one
/// axis is time.cfl. Nothing when there is none.
std::vector<StudyFigure> stability_figures(const StudyDescription& study, const std::vector<StudyRun>& runs);
/// A line per run: grid, both axes, outcome, measures of the last time, reason.
std::string stability_csv(const StudyDescription& study, const std::vector<StudyRun>& runs);

/// A grid of outcomes for ParaView: points (second axis, first axis), in the units of the axes where their values are
/// evenly spaced, else by number. Arrays: outcome as the number of its kind, the first measure, both axes.
struct StabilityMap {
  SampleGrid grid;
  Frame frame;
};
/// Nothing where an axis is not numeric.
std::optional<StabilityMap> stability_map(const StudyDescription& study, const std::vector<StudyRun>& runs,
                                          std::size_t grid);

/// The largest value of the last axis at which a run is stable, for one value of the first.
struct StabilityLimit {
  std::size_t grid = 0;
  std::string first;      // value of the first axis
  double largest = 0.0;   // NaN: unstable from the first value on
  bool beyond = false;    // no value of the axis is unstable: the limit lies beyond `largest`
  double analytic = 0.0;  // NaN where there is none
};
/// Bisects, for grids that ask for it (`refine`), between the last stable value and the first unstable one.
std::vector<StabilityLimit> find_stability_limits(const StudyDescription& study, const std::vector<StudyRun>& runs,
                                                  const std::vector<std::string>& set);
StudyTable limit_table(const StudyDescription& study, const std::vector<StabilityLimit>& limits);

}  // namespace anvil
