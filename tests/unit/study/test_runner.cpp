// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "anvil/core/error.hpp"
#include "anvil/study/report.hpp"
#include "anvil/study/run_table.hpp"
#include "anvil/study/runner.hpp"

namespace anvil {
namespace {

/// A rod of 60 to 240 particles, for which the exact solution costs nothing.
StudyDescription small_study() {
  StudyGrid grid;
  grid.title = "rod";
  grid.scene = "thin_rod";
  grid.times = {8e-6, 12e-6};
  grid.measures = {"stress_l1", "elastic_speed_ratio", "plastic_speed_ratio"};
  grid.axes = {{"time.cfl", {"0.2", "0.3"}}, {"discretisation.spacing", {"2e-3", "1e-3", "5e-4"}}};
  StudyDescription study;
  study.name = "small";
  study.title = "Small";
  study.report = StudyReport::orders;
  study.grids = {grid};
  return study;
}

std::vector<StudyRun> run(const StudyDescription& study, int threads, const std::vector<std::string>& set = {}) {
  auto runs = prepare_study(study, set);
  run_study(study, runs, threads, [](const StudyPosition&) {});
  return runs;
}

TEST(StudyRunner, RunsEveryCombinationInOrder) {
  const StudyDescription study = small_study();
  const auto runs = run(study, 1);
  ASSERT_EQ(runs.size(), 6U);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    EXPECT_EQ(runs[k].status, StudyStatus::finished) << runs[k].reason;
    EXPECT_EQ(runs[k].axis_values, study.grids[0].values_of(k));
    EXPECT_EQ(runs[k].particles, std::size_t{60} << (k % 3));
    EXPECT_GT(runs[k].steps, 0);
    ASSERT_EQ(runs[k].rows.size(), 2U);
    EXPECT_EQ(runs[k].rows[1].time, 12e-6);
    EXPECT_TRUE(std::isnan(runs[k].rows[0].values[1]));  // a speed needs two times
    EXPECT_NEAR(runs[k].rows[1].values[1], 1.0, 0.02);   // 60 particles hold the pulse with some 30
    EXPECT_TRUE(std::isnan(runs[k].rows[1].values[2]));  // it does not yield
  }
  EXPECT_LT(runs[2].rows[1].values[0], runs[0].rows[1].values[0]);
}

TEST(StudyRunner, GivesTheSameNumbersOnAnyNumberOfThreads) {
  const auto one = run(small_study(), 1), three = run(small_study(), 3);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].axis_values, three[k].axis_values);
    EXPECT_EQ(one[k].rows[1].values[0], three[k].rows[1].values[0]);
    EXPECT_EQ(one[k].rows[1].values[1], three[k].rows[1].values[1]);
  }
}

TEST(StudyRunner, KeepsFailuresAsOutcomes) {
  StudyDescription study = small_study();
  // 0.7 mm does not divide the rod; a time step of twenty sound crossings blows up.
  study.grids[0].axes = {{"discretisation.spacing", {"7e-4", "1e-3"}}, {"time.cfl", {"0.3", "20"}}};
  const auto runs = run(study, 2);
  ASSERT_EQ(runs.size(), 4U);
  EXPECT_EQ(runs[0].status, StudyStatus::refused);
  EXPECT_NE(runs[0].reason.find("spacing"), std::string::npos) << runs[0].reason;
  EXPECT_EQ(runs[2].status, StudyStatus::finished);
  EXPECT_EQ(runs[3].status, StudyStatus::failed);
  EXPECT_FALSE(runs[3].reason.empty());
}

TEST(StudyRunner, RefusesAGridThatCannotRunAtAll) {
  EXPECT_THROW(run(small_study(), 1, {"discretisation.colour=red"}), InputError);
  StudyDescription study = small_study();
  study.grids[0].scene = "no_such_scene";
  EXPECT_THROW(run(study, 1), InputError);
}

TEST(StudyRunner, LetsNobodyOverrideAnAxis) {
  EXPECT_THROW(run(small_study(), 1, {"time.cfl=0.1"}), InputError);
  EXPECT_EQ(run(small_study(), 2, {"discretisation.kernel=gaussian"}).size(), 6U);
}

TEST(StudyRunner, TakesThreadsAsAnAxis) {
  StudyDescription study = small_study();
  study.grids[0].axes = {{"threads", {"1", "2", "0", "many"}}};
  const auto runs = run(study, 2);
  ASSERT_EQ(runs.size(), 4U);
  for (std::size_t k = 0; k < 2; ++k) {
    ASSERT_EQ(runs[k].status, StudyStatus::finished) << runs[k].reason;
    EXPECT_EQ(runs[k].threads, static_cast<int>(k) + 1);
    EXPECT_GT(runs[k].cpu_seconds, 0.0);
    EXPECT_EQ(runs[k].rows[1].values[0], runs[0].rows[1].values[0]);
  }
  for (std::size_t k = 2; k < 4; ++k) {
    EXPECT_EQ(runs[k].status, StudyStatus::refused);
    EXPECT_NE(runs[k].reason.find("whole number"), std::string::npos) << runs[k].reason;
  }
}

TEST(StudyRunner, TellsHowFarItIs) {
  std::vector<std::size_t> seen;
  double share = 0.0;
  const StudyDescription study = small_study();
  auto runs = prepare_study(study, {});
  run_study(study, runs, 2, [&](const StudyPosition& position) {
    EXPECT_EQ(position.all, 6U);
    EXPECT_GT(position.share, share);
    share = position.share;
    seen.push_back(position.done);
  });
  EXPECT_EQ(seen, (std::vector<std::size_t>{1, 2, 3, 4, 5, 6}));
  EXPECT_NEAR(share, 1.0, 1e-12);
}

/// Two runs at two times each, made up: an error of the second order, and a run that failed.
struct MadeUp {
  StudyDescription study = small_study();
  std::vector<StudyRun> runs;
  MadeUp() {
    study.grids[0].axes = {{"discretisation.spacing", {"2e-3", "1e-3", "5e-4"}}};
    for (const double error : {0.4, 0.1}) {
      StudyRun& run = runs.emplace_back();
      run.axis_values = study.grids[0].values_of(runs.size() - 1);
      run.status = StudyStatus::finished;
      run.rows = {{8e-6, {error, std::nan(""), std::nan("")}}, {12e-6, {2 * error, 1.01, std::nan("")}}};
    }
    StudyRun& failed = runs.emplace_back();
    failed.axis_values = study.grids[0].values_of(2);
    failed.status = StudyStatus::failed;
    failed.reason = "a \"guard\", tripped";
  }
};

TEST(StudyCsv, HasALinePerRunAndTime) {
  const MadeUp made_up;
  EXPECT_EQ(study_csv(made_up.study, made_up.runs),
            "grid,scene,discretisation.spacing,time [s],stress_l1,elastic_speed_ratio,plastic_speed_ratio,status,"
            "particles,neighbours,steps,particle_steps,wall_time [s],cpu_time [s],reason\n"
            "1,thin_rod,2e-3,8e-06,0.4,,,finished,0,0,0,0,0,0,\n"
            "1,thin_rod,2e-3,1.2e-05,0.8,1.01,,finished,0,0,0,0,0,0,\n"
            "1,thin_rod,1e-3,8e-06,0.1,,,finished,0,0,0,0,0,0,\n"
            "1,thin_rod,1e-3,1.2e-05,0.2,1.01,,finished,0,0,0,0,0,0,\n"
            "1,thin_rod,5e-4,,,,,failed,0,0,0,0,0,0,\"a \"\"guard\"\", tripped\"\n");
}

TEST(StudyReportOrders, ComputesObservedOrders) {
  const MadeUp made_up;
  const RunTable table(made_up.study, made_up.runs, 0);
  EXPECT_NEAR(table.order(1, 0), 2.0, 1e-12);
  EXPECT_TRUE(std::isnan(table.order(2, 0)));
  const auto tables = study_tables(made_up.study, made_up.runs);
  ASSERT_EQ(tables.size(), 1U);
  ASSERT_EQ(tables[0].rows.size(), 4U);
  EXPECT_EQ(tables[0].rows[2], (std::vector<std::string>{"1e-3", "0", "0.10000", "2.00", "0.20000", "2.00"}));
  EXPECT_EQ(tables[0].rows[3], (std::vector<std::string>{"5e-4", "0", "-", "-", "-", "-"}));
}

TEST(StudyReportOrders, DrawsACurvePerSetting) {
  const MadeUp made_up;
  const auto figures = study_figures(made_up.study, made_up.runs);
  ASSERT_EQ(figures.size(), 1U);
  const auto& panels = figures[0].figure.panels;
  ASSERT_EQ(panels.size(), 1U);
  EXPECT_EQ(panels[0].x.label, "Spacing [m]");
  EXPECT_TRUE(panels[0].y.logarithmic);
  EXPECT_NEAR(panels[0].curves[0].y[0], 0.6, 1e-12);  // the mean of both times
}

}  // namespace
}  // namespace anvil
