// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "anvil/core/error.hpp"
#include "anvil/output/hdf5_file.hpp"
#include "anvil/study/cost.hpp"
#include "anvil/study/journal.hpp"
#include "anvil/study/published.hpp"
#include "anvil/study/record.hpp"

namespace anvil {
namespace {

/// A rod of 30 to 120 particles in a folder of its own.
class CostStudy : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              (std::string("anvil_cost_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    StudyGrid grid;
    grid.title = "rod";
    grid.scene = "thin_rod";
    grid.times = {6e-6, 8e-6};
    grid.measures = {"stress_l1"};
    grid.axes = {{"shock.method", {"none", "artificial_viscosity"}}, {"discretisation.spacing", {"2e-3", "1e-3"}}};
    study_.name = "small";
    study_.title = "Small";
    study_.report = StudyReport::cost;
    study_.grids = {grid};
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::vector<StudyRun> run() const {
    auto runs = prepare_study(study_, {});
    run_study(study_, runs, 1, [](const StudyPosition&) {});
    return runs;
  }

  std::filesystem::path folder_;
  StudyDescription study_;
};

TEST(ParetoFront, HasWhatNothingBeats) {
  const std::vector<double> cost = {1.0, 2.0, 3.0, 2.0, 4.0};
  const std::vector<double> error = {0.5, 0.3, 0.3, 0.4, 0.1};
  EXPECT_EQ(pareto_front(cost, error), (std::vector<bool>{true, true, false, false, true}));
  // Of equals, both stay; what is better by rounding alone is not worth more.
  EXPECT_EQ(pareto_front(std::vector{1.0, 2.0}, std::vector{0.5, 0.4999}), (std::vector<bool>{true, false}));
  EXPECT_EQ(pareto_front(std::vector{1.0, 1.0}, std::vector{0.5, 0.5}), (std::vector<bool>{true, true}));
}

TEST_F(CostStudy, CountsWhatARunCosts) {
  const auto runs = run();
  for (const auto& one : runs) {
    EXPECT_GT(one.cpu_seconds, 0.0);
    EXPECT_LE(one.cpu_seconds, 1.5 * one.seconds + 1e-3);  // one thread
    EXPECT_GE(one.neighbours, 1.0);
  }
  const auto points = cost_points(study_, runs);
  ASSERT_EQ(points.size(), 4U);
  EXPECT_EQ(points[1].curve, "none");
  EXPECT_EQ(points[1].name, "1 mm");
  EXPECT_EQ(points[1].particle_steps, static_cast<double>(runs[1].steps) * static_cast<double>(runs[1].particles));
  EXPECT_NEAR(points[1].errors[0], 0.5 * (runs[1].rows[0].values[0] + runs[1].rows[1].values[0]), 1e-15);
  // Half the spacing: twice the particles, twice the steps.
  EXPECT_NEAR(points[1].particle_steps / points[0].particle_steps, 4.0, 0.2);
}

TEST_F(CostStudy, NamesTheCheapestForAnError) {
  auto runs = run();
  const double costs[] = {1.0, 4.0, 2.0, 8.0}, errors[] = {0.15, 0.04, 0.04, 0.015};
  for (std::size_t k = 0; k < runs.size(); ++k) {
    runs[k].cpu_seconds = costs[k];
    for (auto& row : runs[k].rows) row.values = {errors[k]};
  }
  const auto tables = cost_tables(study_, runs);
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[0].rows[1].back(), "0.15000 *");
  EXPECT_EQ(tables[0].rows[2].back(), "0.04000");  // as accurate as the third, and dearer
  const auto& cheapest = tables[1].rows;
  EXPECT_EQ(cheapest[1][1], "none");                  // 20 %
  EXPECT_EQ(cheapest[3][1], "artificial_viscosity");  // 5 %
  EXPECT_EQ(cheapest[4][2], "1 mm");                  // 2 %
  EXPECT_EQ(cheapest[5][1], "none of these");         // 1 %
}

TEST_F(CostStudy, DoesNotTakeAChangeOfSignForAccuracy) {
  auto runs = run();
  const double errors[] = {0.001, 0.04, 0.06, 0.03};
  for (std::size_t k = 0; k < runs.size(); ++k)
    for (auto& row : runs[k].rows) row.values = {errors[k]};
  const auto points = cost_points(study_, runs);
  EXPECT_EQ(points[0].errors[0], 0.001);
  EXPECT_EQ(points[0].kept_errors[0], 0.04);
  EXPECT_EQ(points[1].kept_errors[0], 0.04);
  EXPECT_EQ(points[2].kept_errors[0], 0.06);  // the last one of another curve does not matter
}

TEST_F(CostStudy, DrawsTheFrontWithItsPointsNamed) {
  const auto figures = study_figures(study_, run());
  ASSERT_EQ(figures.size(), 2U);
  const auto& panels = figures[0].figure.panels;
  ASSERT_EQ(panels.size(), 2U);
  EXPECT_EQ(panels[1].x.label, "Particles × steps");
  const auto& front = panels[0].curves.back();
  EXPECT_EQ(front.label, "Pareto front");
  EXPECT_EQ(front.point_labels.size(), front.x.size());
  EXPECT_NE(figures[1].figure.panels[0].curves[0].label.find("order"), std::string::npos);
}

TEST_F(CostStudy, GoesOnWithWhatItDoesNotHave) {
  const auto file = folder_ / "runs.jsonl";
  auto first = prepare_study(study_, {});
  StudyJournal journal(file);
  EXPECT_EQ(journal.restore(study_, first), 0U);
  run_study(
      study_, first, 1, [](const StudyPosition&) {}, [&](const StudyRun& one) { journal.append(study_, one); });
  std::ofstream(file, std::ios::app) << "\n{\"id\":\"torn";
  study_.grids[0].axes[1].values.push_back("5e-4");
  auto second = prepare_study(study_, {});
  EXPECT_EQ(StudyJournal(file).restore(study_, second), 4U);
  EXPECT_TRUE(second[0].known);
  EXPECT_FALSE(second[2].known);
  EXPECT_EQ(second[1].rows[1].values, first[1].rows[1].values);
  EXPECT_EQ(second[1].cpu_seconds, first[1].cpu_seconds);
  std::size_t ran = 0;
  run_study(study_, second, 1, [&](const StudyPosition&) { ++ran; });
  EXPECT_EQ(ran, 2U);
  // Other settings are other runs.
  auto other = prepare_study(study_, {"time.cfl=0.2"});
  EXPECT_EQ(StudyJournal(file).restore(study_, other), 0U);
}

TEST_F(CostStudy, ReadsItsRecordBack) {
  auto runs = run();
  runs[3].rows[1].values[0] = std::nan("");
  const auto file = folder_ / "study.json";
  std::ofstream(file) << study_json(study_, runs, {"2026-01-31T12:00:00Z", "2026-01-31T12:01:00Z"});
  const StudyRecord record = read_study_record(file);
  EXPECT_EQ(record.study.name, "small");
  EXPECT_EQ(record.study.report, StudyReport::cost);
  EXPECT_EQ(record.study.grids[0].axes[1].values, study_.grids[0].axes[1].values);
  ASSERT_EQ(record.runs.size(), runs.size());
  EXPECT_EQ(record.runs[2].rows[0].values, runs[2].rows[0].values);
  EXPECT_EQ(record.runs[2].cpu_seconds, runs[2].cpu_seconds);
  EXPECT_TRUE(std::isnan(record.runs[3].rows[1].values[0]));
  std::ofstream(file) << "{\"format\": \"something else\"}";
  EXPECT_THROW(read_study_record(file), InputError);
}

TEST_F(CostStudy, KeepsItsNumbersInHdf5) {
  const auto runs = run();
  write_study_h5(folder_ / "results.h5", study_, runs);
  const Hdf5File h5 = Hdf5File::open(folder_ / "results.h5", "anvil study 1");
  EXPECT_EQ(h5.read_doubles("grid_1/values").values[2], runs[1].rows[0].values[0]);
  EXPECT_EQ(h5.read_integers("grid_1/steps").values[3], runs[3].steps);
}

TEST(ComparedMeasures, AreThoseOfCompare) {
  EXPECT_TRUE(find_study_measure("deviation.length"));
  EXPECT_TRUE(find_study_measure("deviation.half_width_profile_l2"));
  EXPECT_EQ(find_study_measure("length")->unit, "m");
  EXPECT_FALSE(find_study_measure("deviation.lenght"));
  EXPECT_FALSE(find_study_measure("half_width_profile_l2"));  // a distance needs a reference
  EXPECT_TRUE(reads_history("energy_balance"));
  EXPECT_FALSE(reads_history("stress_l1"));
}

/// The shell of two layers, against its reference: the deviation is that of the quantity itself.
TEST(ComparedMeasures, GiveTheDeviationFromTheReference) {
  StudyGrid grid;
  grid.title = "shell";
  grid.scene = "be_shell_quarter";
  grid.set = {"discretisation.spacing=10e-3"};
  grid.times = {130e-6};
  grid.measures = {"shell_inner_radius", "deviation.shell_inner_radius", "energy_balance"};
  StudyDescription study;
  study.grids = {grid};
  auto runs = prepare_study(study, {});
  run_study(study, runs, 1, [](const StudyPosition&) {});
  ASSERT_EQ(runs[0].status, StudyStatus::finished) << runs[0].reason;
  const auto& values = runs[0].rows[0].values;
  constexpr double reference = 49.956e-3;  // data/reference/be_shell_quarter.toml
  EXPECT_NEAR(values[1], std::abs(values[0] - reference) / reference, 1e-12);
  // Read off the history: the published form does not keep energy to round-off.
  EXPECT_NE(values[2], 0.0);
  EXPECT_LT(std::abs(values[2]), 0.1);
}

}  // namespace
}  // namespace anvil
