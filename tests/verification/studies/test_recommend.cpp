// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "anvil/core/error.hpp"
#include "anvil/scene/reader.hpp"
#include "anvil/study/cost.hpp"
#include "anvil/study/recommend.hpp"

namespace anvil {
namespace {

std::string message_of(const std::string& scene, const Wish& wish) {
  try {
    recommend(scene, {}, wish, bundled_study_records());
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The run that is recommended, as a study measures it.
StudyRun run_of(const std::string& scene, const Recommendation& recommendation) {
  StudyGrid grid;
  grid.scene = scene;
  grid.set = recommendation.settings;
  grid.times = recommendation.times;
  grid.measures = {recommendation.measure};
  StudyDescription study;
  study.grids = {grid};
  auto runs = prepare_study(study, {});
  run_study(study, runs, 1, [](const StudyPosition&) {});
  EXPECT_EQ(runs[0].status, StudyStatus::finished) << runs[0].reason;
  return runs[0];
}

/// Steps do not depend on the machine, so they stand for the time here.
void expect_kept(const std::string& scene, const Recommendation& recommendation) {
  const StudyRun run = run_of(scene, recommendation);
  double error = 0.0;
  for (const auto& row : run.rows) error += std::abs(row.values[0]) / static_cast<double>(run.rows.size());
  EXPECT_LT(error, 1.5 * recommendation.error);
  EXPECT_GT(error, recommendation.error / 1.5);
  const double steps = static_cast<double>(run.steps) * static_cast<double>(run.particles);
  EXPECT_NEAR(steps / (recommendation.steps * recommendation.particles), 1.0, 0.3);
}

TEST(Recommend, KeepsItsPredictionsOnBundledPlates) {
  for (const char* scene : {"plate_perfect", "flyer_plate", "wilkins"})
    for (const double error : {0.05, 0.02, 0.01}) {
      SCOPED_TRACE(std::string(scene) + " at " + std::to_string(error));
      const auto recommendation =
          recommend(scene, {}, {.error = error, .seconds = {}, .measure = {}}, bundled_study_records());
      EXPECT_EQ(recommendation.rests_on, Nearness::same);
      EXPECT_LE(recommendation.error, error);
      expect_kept(scene, recommendation);
    }
}

TEST(Recommend, CarriesOverToAPlateOfTheSameKind) {
  for (const double error : {0.03, 0.01}) {
    const auto recommendation =
        recommend("plate_hardening", {}, {.error = error, .seconds = {}, .measure = {}}, bundled_study_records());
    EXPECT_EQ(recommendation.rests_on, Nearness::kind);
    EXPECT_EQ(recommendation.measured_scene, "plate_perfect");
    expect_kept("plate_hardening", recommendation);
  }
}

TEST(Recommend, TakesWhatIsMostAccurateWithinATime) {
  const auto within = [](double seconds) {
    return recommend("plate_perfect", {}, {.error = {}, .seconds = seconds, .measure = {}}, bundled_study_records());
  };
  // In times of this machine, however slow: far apart, since its measured speed varies from call to call.
  const double enough =
      recommend("plate_perfect", {}, {.error = 0.02, .seconds = {}, .measure = {}}, bundled_study_records()).seconds;
  const auto longer = within(40.0 * enough), shorter = within(3.0 * enough);
  EXPECT_LE(longer.seconds, 40.0 * enough);
  EXPECT_GT(shorter.error, longer.error);
}

TEST(Recommend, RefusesWithoutDataNear) {
  EXPECT_NE(
      message_of("soil_collapse", {.error = 0.02, .seconds = {}, .measure = {}}).find("nothing has been measured"),
      std::string::npos);
  const std::string beyond = message_of("plate_perfect", {.error = 1e-5, .seconds = {}, .measure = {}});
  EXPECT_NE(beyond.find("the most accurate one has"), std::string::npos) << beyond;
  EXPECT_NE(message_of("plate_perfect", {.error = {}, .seconds = 1e-7, .measure = {}}).find("shortest"),
            std::string::npos);
  EXPECT_NE(message_of("plate_perfect", {.error = 0.02, .seconds = {}, .measure = "colour"}).find("colour"),
            std::string::npos);
}

TEST(Nearness, AsksForTheSameProblemOrItsKind) {
  const auto scene = [](const char* name, const std::vector<std::string>& set = {}) {
    return read_scene(locate_scene(name), set);
  };
  const Scene plate = scene("plate_perfect");
  EXPECT_EQ(nearness(scene("plate_perfect", {"discretisation.spacing=1e-3", "shock.method=none"}), plate),
            Nearness::same);
  EXPECT_EQ(nearness(scene("plate_perfect", {"boundary.load.value=4e9"}), plate), Nearness::kind);
  EXPECT_EQ(nearness(scene("plate_perfect", {"boundary.load.value=5e8"}), plate), Nearness::none);
  EXPECT_EQ(nearness(scene("flyer_plate"), plate), Nearness::none);
  EXPECT_EQ(nearness(scene("rod_square"), plate), Nearness::none);
}

}  // namespace
}  // namespace anvil
