// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/output/result_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "anvil/core/error.hpp"
#include "anvil/output/provenance.hpp"
#include "unit/output/temporary_folder.hpp"

namespace anvil {
namespace {

namespace fs = std::filesystem;

/// A folder as a finished run of the scene leaves it, with three frames and two checkpoints.
void fill_result(const fs::path& path, const std::string& scene_id) {
  fs::create_directories(path / "frames");
  for (const char* name : {"frames/rod_000000.vtp", "frames/rod_000001.vtp", "frames/rod_000002.vtp", "rod.pvd",
                           "history.csv", "checkpoint_100.h5", "checkpoint_20.h5"})
    write_file(path / name, "x");
  Provenance provenance;
  provenance.scene_id = scene_id;
  provenance.title = "An earlier rod";
  write_provenance(path / "run.json", provenance);
}

TEST(ResultFolder, StartsInAMissingOrEmptyFolder) {
  const TemporaryFolder folder;
  start_result(folder / "new/deep", "id", false);
  EXPECT_TRUE(fs::is_directory(folder / "new/deep"));
  EXPECT_NO_THROW(start_result(folder / "new/deep", "id", false));
}

TEST(ResultFolder, RefusesADifferentResultUnlessTold) {
  const TemporaryFolder folder;
  fill_result(folder.path(), "one");
  try {
    start_result(folder.path(), "other", false);
    FAIL() << "replaced a different result";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("--overwrite"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("An earlier rod"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(fs::exists(folder / "frames/rod_000002.vtp"));
}

TEST(ResultFolder, ClearsAResultAndOnlyThat) {
  const TemporaryFolder folder;
  fill_result(folder.path(), "one");
  write_file(folder / "notes.txt", "mine");
  write_file(folder / "frames/readme", "mine");
  start_result(folder.path(), "other", true);
  EXPECT_TRUE(fs::exists(folder / "notes.txt"));
  EXPECT_TRUE(fs::exists(folder / "frames/readme"));
  for (const char* name :
       {"frames/rod_000000.vtp", "rod.pvd", "history.csv", "run.json", "checkpoint_100.h5", "checkpoint_20.h5"})
    EXPECT_FALSE(fs::exists(folder / name)) << name;
}

TEST(ResultFolder, RunsTheSameSceneAgain) {
  const TemporaryFolder folder;
  fill_result(folder.path(), "one");
  EXPECT_NO_THROW(start_result(folder.path(), "one", false));
}

TEST(ResultFolder, NeverTouchesForeignFolders) {
  const TemporaryFolder folder;
  write_file(folder / "thesis.tex", "years of work");
  EXPECT_THROW(start_result(folder.path(), "id", false), InputError);
  EXPECT_THROW(start_result(folder.path(), "id", true), InputError);
  EXPECT_THROW(start_result(folder / "thesis.tex", "id", true), InputError);
  EXPECT_TRUE(fs::exists(folder / "thesis.tex"));
}

TEST(ResultFolder, ContinuesWithoutLaterCheckpoints) {
  const TemporaryFolder folder;
  fill_result(folder.path(), "one");
  continue_result(folder / "checkpoint_20.h5", 20);
  EXPECT_TRUE(fs::exists(folder / "checkpoint_20.h5"));
  EXPECT_FALSE(fs::exists(folder / "checkpoint_100.h5"));
}

TEST(ResultFolder, ContinuesOnlyWhereTheRunIs) {
  const TemporaryFolder folder;
  write_file(folder / "checkpoint_20.h5", "x");
  EXPECT_THROW(continue_result(folder / "checkpoint_20.h5", 20), InputError);
}

TEST(ResultFolder, FindsTheLastFrameOfAnyFormat) {
  const TemporaryFolder folder;
  EXPECT_THROW((void)ResultFolder{folder.path()}.last_frame(), InputError);
  fs::create_directories(folder / "frames");
  for (const char* name : {"a_b_000009.h5", "a_b_000010.h5", ".a_b_000011.h5.part", "a_b_x.h5"})
    write_file(folder / "frames" / name, "x");
  EXPECT_EQ(ResultFolder{folder.path()}.last_frame().filename(), "a_b_000010.h5");
}

}  // namespace
}  // namespace anvil
