// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "anvil/figures/figure.hpp"
#include "anvil/study/runner.hpp"

namespace anvil {

/// Rows of cells below a title, the first row being the heading. `alignment` has one letter per column, l or r.
struct StudyTable {
  std::string title;
  std::vector<std::vector<std::string>> rows;
  std::string alignment;
};

/// The outcome as the study's `report` asks for it; `cost` is in cost.hpp.
///   table   a table per grid, a line per run and time
///   orders  the first measure over the last axis, a spacing, at every time, and the observed order
///           log(error / error before) / log(spacing / spacing before)
///   speeds  measures with a reference beside the reference and the factor alpha of the lattice (lattice_factor, which
///           has to be among the measures), at the last time
std::vector<StudyTable> study_tables(const StudyDescription& study, const std::vector<StudyRun>& runs);

/// A figure and what is put behind the name of the study for the name of its file.
struct StudyFigure {
  std::string suffix;
  Figure figure;
};

/// A panel per grid over the last axis: `orders` draws the mean over all times, both axes logarithmic, a curve for
/// every combination of the other axes; `speeds` draws alpha and the measures with a reference at the last time. `cost`
/// draws accuracy against cost and, apart from it, convergence. Nothing for `table`.
std::vector<StudyFigure> study_figures(const StudyDescription& study, const std::vector<StudyRun>& runs);

}  // namespace anvil
