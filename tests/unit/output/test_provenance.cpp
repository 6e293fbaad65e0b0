// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/output/provenance.hpp"

#include <gtest/gtest.h>

#include <regex>

#include "anvil/core/error.hpp"
#include "anvil/core/simd_level.hpp"
#include "unit/output/temporary_folder.hpp"

namespace anvil {
namespace {

TEST(Provenance, ReadsBackWhatWasWritten) {
  const TemporaryFolder folder;
  Provenance written = make_provenance();
  written.title = "A \"quoted\" title, 2 µm";
  written.scene_name = "rod";
  written.scene_text = "title = \"x\"\n[domain]\n";
  written.scene_id = identify_scene(written.scene_text);
  written.instruction_set = "baseline";
  written.status = "failed";
  written.reason = "density below zero";
  written.started = utc_now();
  written.particles = 2560;
  written.steps = 12345678901;
  written.time = 0.1 + 0.2;
  written.wall_time = 1.0 / 3.0;
  written.step_time = 0.25;
  write_provenance(folder / "run.json", written);
  const Provenance read = read_provenance(folder / "run.json");
  EXPECT_EQ(read.title, written.title);
  EXPECT_EQ(read.scene_name, written.scene_name);
  EXPECT_EQ(read.scene_text, written.scene_text);
  EXPECT_EQ(read.scene_id, written.scene_id);
  EXPECT_EQ(read.version, written.version);
  EXPECT_EQ(read.commit, written.commit);
  EXPECT_EQ(read.compiler, written.compiler);
  EXPECT_EQ(read.instruction_set, written.instruction_set);
  EXPECT_EQ(read.threads, written.threads);
  EXPECT_EQ(read.status, written.status);
  EXPECT_EQ(read.reason, written.reason);
  EXPECT_EQ(read.started, written.started);
  EXPECT_EQ(read.particles, written.particles);
  EXPECT_EQ(read.steps, written.steps);
  EXPECT_EQ(read.time, written.time);
  EXPECT_EQ(read.wall_time, written.wall_time);
  EXPECT_EQ(read.step_time, written.step_time);
}

TEST(Provenance, KnowsItsProgram) {
  const Provenance provenance = make_provenance();
  EXPECT_TRUE(std::regex_match(provenance.version, std::regex(R"(\d+\.\d+\.\d+)"))) << provenance.version;
  EXPECT_FALSE(provenance.commit.empty());
  EXPECT_FALSE(provenance.compiler.empty());
  EXPECT_EQ(provenance.instruction_set, simd_level());
  EXPECT_GE(provenance.threads, 1);
}

TEST(Provenance, RefusesOtherFiles) {
  const TemporaryFolder folder;
  for (const char* text : {"", "{", "[1, 2]", "{\"title\": 3}"}) {
    write_file(folder / "run.json", text);
    EXPECT_THROW(read_provenance(folder / "run.json"), InputError) << text;
  }
}

TEST(SceneIdentifier, IsANameBasedUuidThatFollowsTheText) {
  const std::string id = identify_scene("a = 1\n");
  EXPECT_TRUE(std::regex_match(id, std::regex("[0-9a-f]{8}-[0-9a-f]{4}-5[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}")))
      << id;
  EXPECT_EQ(id, identify_scene("a = 1\n"));
  EXPECT_NE(id, identify_scene("a = 2\n"));
}

TEST(UtcNow, IsWrittenAsIso8601) {
  EXPECT_TRUE(std::regex_match(utc_now(), std::regex(R"(20\d\d-\d\d-\d\dT\d\d:\d\d:\d\dZ)"))) << utc_now();
}

}  // namespace
}  // namespace anvil
