// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "anvil/kernels/lattice_sum.hpp"
#include "anvil/study/stability.hpp"

namespace anvil {
namespace {

/// On a line, with h = dx, the cubic spline sees its next neighbours alone: the central difference, sin(k dx)/dx.
TEST(LargestStableCfl, IsThatOfTheCentralDifference) {
  const Kernel spline = make_kernel("cubic_spline");
  EXPECT_NEAR(largest_stable_cfl(spline, 1, 1.0, true), 2.0, 1e-12);
  EXPECT_NEAR(largest_stable_cfl(spline, 1, 1.0, false), 2.0 / lattice_wave_speed_factor(spline, 1, 1.0), 1e-12);
  // A wider kernel damps the shortest waves, but the cfl is counted in smoothing lengths.
  EXPECT_LT(largest_stable_cfl(spline, 1, 1.5, true), 2.0);
  for (const int dimension : {2, 3}) EXPECT_GT(largest_stable_cfl(spline, dimension, 1.2, true), 0.5) << dimension;
}

StudyDescription plate_study() {
  StudyGrid grid;
  grid.title = "plate";
  grid.scene = "plate_perfect";
  grid.set = {"shock.method=none", "discretisation.spacing=0.8e-3"};
  grid.times = {8e-6};
  grid.measures = {"stress_l1", "energy_balance", "minimum_pair_distance"};
  grid.axes = {{"discretisation.smoothing_ratio", {"1.0", "1.4"}}, {"time.cfl", {"0.3", "0.9", "3"}}};
  grid.bound = 0.5;
  grid.refine = 0.05;
  StudyDescription study;
  study.name = "plate";
  study.title = "Plate";
  study.report = StudyReport::stability;
  study.grids = {grid};
  return study;
}

TEST(StabilityMap, FindsTheLimitOfLinearTheory) {
  const StudyDescription study = plate_study();
  auto runs = prepare_study(study, {});
  run_study(study, runs, 1, [](const StudyPosition&) {});
  EXPECT_EQ(outcome_of(study.grids[0], runs[0]), Outcome::stable) << runs[0].reason;
  EXPECT_NE(outcome_of(study.grids[0], runs[2]), Outcome::stable);
  const auto limits = find_stability_limits(study, runs, {});
  ASSERT_EQ(limits.size(), 2U);
  for (const auto& limit : limits) {
    EXPECT_FALSE(limit.beyond);
    // The ends of the bar, where the operator is one-sided, ask for less than the lattice inside.
    EXPECT_LT(limit.largest, 1.06 * limit.analytic) << limit.first;
    EXPECT_GT(limit.largest, 0.5 * limit.analytic) << limit.first;
  }
  const auto map = stability_map(study, runs, 0);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->frame.arrays[0].values.size(), 6U);
  EXPECT_EQ(map->frame.arrays[3].values[1], 0.9);
  const auto figures = stability_figures(study, runs);
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].figure.panels[0].curves.back().label, "von Neumann limit");
}

TEST(StabilityFigures, TakeALogarithmicAxisForUnevenValues) {
  StudyDescription study = plate_study();
  const auto x_axis = [&] { return stability_figures(study, prepare_study(study, {})).at(0).figure.panels.at(0).x; };
  EXPECT_TRUE(x_axis().logarithmic);
  study.grids[0].axes[1].values = {"0.3", "0.9", "1.5"};
  EXPECT_FALSE(x_axis().logarithmic);
}

TEST(StabilityOutcomes, FollowFromGuardsAndMeasures) {
  const StudyGrid grid = plate_study().grids[0];
  StudyRun run;
  run.status = StudyStatus::finished;
  const auto with = [&](double error, double energy, double distance) {
    run.rows = {{2e-5, {error, energy, distance}}};
    return outcome_of(grid, run);
  };
  EXPECT_EQ(with(0.1, 0.0, 1.0), Outcome::stable);
  EXPECT_EQ(with(0.6, 0.0, 1.0), Outcome::inaccurate);
  EXPECT_EQ(with(0.1, 0.3, 1.0), Outcome::energy_growth);
  EXPECT_EQ(with(0.1, 0.0, 0.001), Outcome::clumping);
  EXPECT_EQ(with(std::nan(""), 0.0, 1.0), Outcome::not_a_number);
  run.status = StudyStatus::failed;
  run.reason = "step 3: particle 1: it is beyond the boundary 'anvil'";
  EXPECT_EQ(outcome_of(grid, run), Outcome::penetration);
  run.reason =
      "step 9 at 1e-6 s: particle 1: it asks for a time step of 1e-15 s, less than 0.0001 of the first one "
      "(time.minimum_step_fraction)";
  EXPECT_EQ(outcome_of(grid, run), Outcome::step_collapse);
  run.reason = "step 9 at 1e-6 s: particle 1: position or velocity is not a number";
  EXPECT_EQ(outcome_of(grid, run), Outcome::not_a_number);
  run.reason =
      "step 9 at 1e-6 s: particle 1: an edge at it has turned inside out: the body is deformed further than its "
      "lattice "
      "can follow";
  EXPECT_EQ(outcome_of(grid, run), Outcome::inversion);
  run.reason = "there is no exact solution of this scene";
  EXPECT_EQ(outcome_of(grid, run), Outcome::refused);
}

}  // namespace
}  // namespace anvil
