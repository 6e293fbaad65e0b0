// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "anvil/study/finest.hpp"

namespace anvil {
namespace {

StudyRun finished(const std::string& method, const std::string& spacing, std::size_t particles, double length) {
  StudyRun run;
  run.status = StudyStatus::finished;
  run.axis_values = {method, spacing};
  run.particles = particles;
  run.steps = 10;
  run.rows = {{1e-6, {length}}};
  return run;
}

StudyDescription study_of(bool against_finest) {
  StudyDescription study;
  study.grids.resize(1);
  study.grids[0].measures = {"length"};
  study.grids[0].times = {1e-6};
  study.grids[0].against_finest = against_finest;
  return study;
}

TEST(Finest, IsTheReferenceOfRunsWithTheSameOtherSettings) {
  std::vector<StudyRun> runs = {finished("sph", "0.1", 100, 4.0), finished("sph", "0.2", 50, 5.0),
                                finished("cspm", "0.1", 100, 10.0), finished("cspm", "0.2", 50, 9.0),
                                finished("cspm", "0.05", 200, 7.0)};
  runs[4].status = StudyStatus::failed;
  compare_with_finest(study_of(true), runs);
  EXPECT_TRUE(std::isnan(runs[0].rows[0].values[0]));
  EXPECT_DOUBLE_EQ(runs[1].rows[0].values[0], 0.25);
  EXPECT_TRUE(std::isnan(runs[2].rows[0].values[0]));  // the finer one failed
  EXPECT_NEAR(runs[3].rows[0].values[0], 0.1, 1e-15);
}

TEST(Finest, IsNoReferenceWhereNobodyAsksForIt) {
  std::vector<StudyRun> runs = {finished("sph", "0.1", 100, 4.0), finished("sph", "0.2", 50, 5.0)};
  compare_with_finest(study_of(false), runs);
  EXPECT_EQ(runs[1].rows[0].values[0], 5.0);
}

}  // namespace
}  // namespace anvil
