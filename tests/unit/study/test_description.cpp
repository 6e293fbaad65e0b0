// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "anvil/core/error.hpp"
#include "anvil/study/description.hpp"

namespace anvil {
namespace {

/// A study in a folder of its own, beside a table of published values.
class StudyFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              (std::string("anvil_study_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "published.csv") << "# made up\nspacing,error\n0.002,0.3\n0.001,0.2\n";
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  StudyDescription read(const std::string& text) const {
    std::ofstream(folder_ / "made_up.toml") << text;
    return read_study(folder_ / "made_up.toml");
  }
  std::string message_of(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

 private:
  std::filesystem::path folder_;
};

constexpr const char* complete = R"(
title = "Two axes"
report = "orders"
[[grid]]
scene = "bar_elastic_1d"
set = ["time.cfl=0.2"]
times = [1e-6, 2e-6]
measures = ["stress_l1"]
[[grid.axis]]
key = "shock.method"
values = ["none", "artificial_viscosity"]
[[grid.axis]]
key = "discretisation.spacing"
values = [2e-3, 1e-3, 5e-4]
[[grid.reference]]
measure = "stress_l1"
file = "published.csv"
column = "error"
)";

TEST_F(StudyFile, SaysWhatIsRun) {
  const StudyDescription study = read(complete);
  EXPECT_EQ(study.name, "made_up");
  EXPECT_EQ(study.title, "Two axes");
  EXPECT_EQ(study.report, StudyReport::orders);
  ASSERT_EQ(study.grids.size(), 1U);
  const StudyGrid& grid = study.grids[0];
  EXPECT_EQ(grid.title, "bar_elastic_1d");
  EXPECT_EQ(grid.times, (std::vector<double>{1e-6, 2e-6}));
  EXPECT_EQ(grid.set, (std::vector<std::string>{"time.cfl=0.2"}));
  EXPECT_EQ(grid.run_count(), 6U);
  EXPECT_FALSE(grid.against_finest);
}

TEST_F(StudyFile, ChangesTheLastAxisFastest) {
  const StudyGrid grid = read(complete).grids[0];
  EXPECT_EQ(grid.values_of(0), (std::vector<std::string>{"none", "0.002"}));
  EXPECT_EQ(grid.values_of(2), (std::vector<std::string>{"none", "0.0005"}));
  EXPECT_EQ(grid.values_of(3), (std::vector<std::string>{"artificial_viscosity", "0.002"}));
}

TEST_F(StudyFile, FindsPublishedValuesByTheLastAxis) {
  const StudyReference reference = read(complete).grids[0].references[0];
  EXPECT_EQ(reference.at("0.001"), 0.2);
  EXPECT_EQ(reference.at("1e-3"), 0.2);
  EXPECT_FALSE(reference.at("0.0005"));
  EXPECT_FALSE(reference.at("none"));
}

TEST_F(StudyFile, KeepsListsAndFlagsAsTheyStandInAScene) {
  const StudyGrid grid = read(R"(
[[grid]]
scene = "bar_elastic_1d"
times = [1e-6]
measures = ["stress_l1"]
[[grid.axis]]
key = "body.bar.velocity"
values = [[-10.0], [-20.0]]
[[grid.axis]]
key = "discretisation.variable_smoothing_length"
values = [true, false]
)")
                             .grids[0];
  EXPECT_EQ(grid.values_of(0)[1], "true");
  EXPECT_NE(grid.values_of(0)[0].find("-10"), std::string::npos);
}

TEST_F(StudyFile, ListsAllThatIsWrong) {
  const std::string message = message_of(R"(
report = "orders"
[[grid]]
times = [2e-6, 1e-6]
measures = ["stress_l3"]
colour = "red"
[[grid.axis]]
key = "time.cfl"
values = []
)");
  for (const char* part :
       {"made_up.toml:3", "scene", "ascend", "stress_l3", "did you mean", "colour", "grid.1.axis.1.values"})
    EXPECT_NE(message.find(part), std::string::npos) << part << " in\n" << message;
}

TEST_F(StudyFile, NeedsAGridAndWhatItsReportShows) {
  EXPECT_NE(message_of("title = \"empty\"").find("[[grid]]"), std::string::npos);
  const std::string bare = "[[grid]]\nscene = \"bar_elastic_1d\"\ntimes = [1e-6]\nmeasures = [\"stress_l1\"]\n";
  EXPECT_EQ(message_of(bare), "");
  EXPECT_NE(message_of("report = \"orders\"\n" + bare).find("needs an axis"), std::string::npos);
  EXPECT_NE(message_of("report = \"speeds\"\n" + bare).find("lattice_factor"), std::string::npos);
  EXPECT_NE(message_of(bare + "against = \"finest\"\n").find("needs an axis"), std::string::npos);
  EXPECT_NE(message_of(bare + "against = \"worst\"\n").find("finest"), std::string::npos);
  EXPECT_NE(message_of("report = \"poem\"\n" + bare).find("orders"), std::string::npos);
}

TEST(Studies, BundledOnesAreFoundByName) {
  for (const char* name : {"kernel_tables", "kernel_tables_paper_load", "plate_convergence", "plate_table"})
    EXPECT_FALSE(read_study(locate_study(name)).grids.empty()) << name;
  try {
    locate_study("kernel_table");
    ADD_FAILURE() << "found a study that does not exist";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'kernel_tables'"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace anvil
