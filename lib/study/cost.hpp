// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

#include "anvil/figures/figure.hpp"
#include "anvil/study/report.hpp"

namespace anvil {

/// A finished run as accuracy against cost sees it.
struct CostPoint {
  std::size_t run;             // its place among the runs of the study
  std::string curve;           // its settings but for the last axis
  std::string name;            // the value of the last axis, a spacing in millimetres
  std::vector<double> errors;  // one per measure: the mean of its absolute value over the times
  // The same, and no less than what dearer runs of the curve have: an error that changes sign passes through zero once,
  // which is luck. Fronts and choices go by it.
  std::vector<double> kept_errors;
  double seconds;  // CPU time of the steps on one thread
  double particle_steps;
};

/// The finished runs whose measures are all seen and not beyond 100 %. All grids have the same measures, as the report
/// `cost` demands.
std::vector<CostPoint> cost_points(const StudyDescription& study, const std::vector<StudyRun>& runs);

/// Which points nothing beats: no other one is at least as cheap and, within a thousandth, as accurate, and
/// better in one of the two.
std::vector<bool> pareto_front(std::span<const double> cost, std::span<const double> error);

/// A table of all points, those on a front marked, and per measure one of the cheapest point that reaches an error.
std::vector<StudyTable> cost_tables(const StudyDescription& study, const std::vector<StudyRun>& runs);

/// Per measure a panel over the CPU time and one over particle-steps, with the Pareto front and its points named.
Figure cost_figure(const StudyDescription& study, const std::vector<StudyRun>& runs);
/// Per measure a panel over the last axis, with the observed order of every curve.
Figure convergence_figure(const StudyDescription& study, const std::vector<StudyRun>& runs);

}  // namespace anvil
