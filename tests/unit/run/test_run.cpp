// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/solver/run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "anvil/checkpoint/checkpoint.hpp"
#include "anvil/core/error.hpp"
#include "anvil/output/atomic_file.hpp"
#include "anvil/output/hdf5_series.hpp"
#include "anvil/output/history.hpp"
#include "unit/output/temporary_folder.hpp"
#include "unit/run/fake_simulation.hpp"

namespace anvil {
namespace {

namespace fs = std::filesystem;

class ShownPositions : public Progress {
 public:
  void show(const RunPosition& position) override { fractions.push_back(position.fraction); }
  std::vector<double> fractions;
};

Scene make_scene() {
  Scene scene{};
  scene.name = "spring";
  scene.title = "A spring";
  scene.discretisation.spacing = 1.0;
  scene.time.end = 2.5;
  scene.output.interval = 0.1;
  scene.output.checkpoint_interval = 0.37;
  return scene;
}

struct Run : public ::testing::Test {
  RunOptions options() const { return {ResultFolder{folder.path()}, "title = \"A spring\"\n", std::nullopt}; }
  Provenance start(const RunOptions& chosen) {
    Hdf5Series series(folder.path(), scene.name);
    return run(simulation, scene, chosen, series, progress);
  }
  /// Goes on from a checkpoint as `anvil run --restart` does.
  Provenance restart(std::int64_t step) {
    const fs::path path = ResultFolder{folder.path()}.checkpoint(step);
    const Checkpoint checkpoint = read_checkpoint(path);
    FakeSimulation restored;
    restored.restore(checkpoint.state);
    RunOptions chosen = options();
    chosen.folder = continue_result(path, step);
    chosen.restart = RestartPoint{checkpoint.next_frame, checkpoint.history_rows};
    Hdf5Series series(folder.path(), scene.name, checkpoint.next_frame);
    return run(restored, scene, chosen, series, progress);
  }
  /// Content of all files whose bytes must not depend on interruptions.
  std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> files;
    for (const auto& item : fs::recursive_directory_iterator(folder.path()))
      if (item.is_regular_file() && item.path().filename() != "run.json")
        files[fs::relative(item.path(), folder.path()).string()] = read_text(item.path());
    return files;
  }

  TemporaryFolder folder;
  Scene scene = make_scene();
  FakeSimulation simulation;
  ShownPositions progress;
};

TEST_F(Run, WritesFramesAtMultiplesOfTheIntervalAndAtTheEnd) {
  scene.time.end = 0.55;
  start(options());
  const auto frames = numbered_frames(folder / "frames");
  ASSERT_EQ(frames.size(), 7U);
  for (const auto& [number, file] : frames) {
    const Frame frame = read_hdf5_frame(file);
    EXPECT_EQ(frame.index, number);
    EXPECT_EQ(frame.time, number == 6 ? 0.55 : static_cast<double>(number) * 0.1);
    EXPECT_EQ(frame.scene, "spring");
  }
}

TEST_F(Run, WritesFramesAtTheTimesOfTheComparisonToo) {
  scene.time.end = 0.55;
  scene.compare.times = {0.47, 0.3, 0.123, 0.55, 0.9};  // in any order, and some that have frames or none
  start(options());
  const auto frames = numbered_frames(folder / "frames");
  ASSERT_EQ(frames.size(), 9U);
  EXPECT_EQ(read_hdf5_frame(frames.at(2)).time, 0.123);
  EXPECT_EQ(read_hdf5_frame(frames.at(6)).time, 0.47);
}

TEST_F(Run, WritesTheEndOnceWhenItIsAMultipleOfTheIntervalButForRounding) {
  scene.time.end = 0.3;  // 3 * 0.1 is the next double above
  start(options());
  const auto frames = numbered_frames(folder / "frames");
  ASSERT_EQ(frames.size(), 4U);
  EXPECT_EQ(read_hdf5_frame(frames.at(3)).time, 0.3);
}

TEST_F(Run, KeepsAHistoryRowOfEveryFrameAndOfEveryStepOfAShortRun) {
  const Provenance result = start(options());
  const History history = read_history(folder / "history.csv");
  ASSERT_EQ(history.rows(), static_cast<std::size_t>(result.steps) + 1);
  EXPECT_EQ(history.find("time")->values.front(), 0.0);
  EXPECT_EQ(history.find("time")->values.back(), 2.5);
  EXPECT_EQ(history.find("time_step")->unit, "s");
  EXPECT_EQ(history.find("momentum_x")->unit, "N s");
}

TEST_F(Run, KeepsTheHistoryOfALongRunShort) {
  scene.time.end = 200.0;
  scene.output.interval = 50.0;
  scene.output.checkpoint_interval = 0.0;
  const Provenance result = start(options());
  EXPECT_GT(result.steps, 8000);
  const std::size_t rows = read_history(folder / "history.csv").rows();
  EXPECT_GT(rows, 1990U);
  EXPECT_LT(rows, 2010U);  // 2000 parts, and the frames
}

TEST_F(Run, WritesACheckpointInEachIntervalAndAtTheEnd) {
  const Provenance result = start(options());
  std::vector<double> times;
  for (const auto& [name, text] : contents())
    if (name.starts_with("checkpoint_")) times.push_back(read_checkpoint(folder / name).time);
  std::sort(times.begin(), times.end());
  ASSERT_EQ(times.size(), 7U);  // 6 whole intervals of 0.37 in 2.5, and the end
  constexpr double longest_step = 0.0123 * 2.5;
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_GE(times[i], 0.37 * static_cast<double>(i + 1) * (1.0 - 1e-9));
    EXPECT_LE(times[i], 0.37 * static_cast<double>(i + 1) + longest_step);
  }
  EXPECT_EQ(times.back(), 2.5);
  EXPECT_TRUE(fs::exists(ResultFolder{folder.path()}.checkpoint(result.steps)));
}

TEST_F(Run, CheckpointsAndHistoryDoNotChangeTheNumbers) {
  start(options());
  const std::string with = read_text(folder / "frames/spring_000025.h5");
  scene.output.checkpoint_interval = 0.0;
  simulation.restore(FakeSimulation().state());
  start(options());
  EXPECT_EQ(read_text(folder / "frames/spring_000025.h5"), with);
}

TEST_F(Run, RestartedAnywhereGivesTheSameBytes) {
  start(options());
  const auto undisturbed = contents();
  std::vector<std::int64_t> steps;
  for (const auto& [name, text] : undisturbed)
    if (name.starts_with("checkpoint_")) steps.push_back(read_checkpoint(folder / name).step);
  std::sort(steps.rbegin(), steps.rend());
  for (const std::int64_t step : steps) {
    const Provenance result = restart(step);
    EXPECT_EQ(result.status, "finished");
    EXPECT_EQ(result.first_step, step);
    EXPECT_EQ(contents(), undisturbed) << "restarted at step " << step;
  }
}

TEST_F(Run, StoppedAndRestartedGivesTheSameBytes) {
  start(options());
  auto undisturbed = contents();
  simulation.restore(FakeSimulation().state());
  RunOptions stopping = options();
  stopping.folder = start_result(folder.path(), identify_scene(stopping.scene_text), false);
  stopping.stop_requested = [this] { return simulation.step() == 70; };
  const Provenance stopped = start(stopping);
  EXPECT_EQ(stopped.status, "stopped");
  EXPECT_EQ(read_provenance(folder / "run.json").status, "stopped");
  restart(70);
  undisturbed["checkpoint_70.h5"] = read_text(folder / "checkpoint_70.h5");  // the one more it has
  EXPECT_EQ(contents(), undisturbed);
}

TEST_F(Run, SaysThatItRunsWhileItRuns) {
  std::string status;
  simulation.after_step = [&](std::int64_t) { status = read_provenance(folder / "run.json").status; };
  const Provenance result = start(options());
  EXPECT_EQ(status, "running");
  const Provenance written = read_provenance(folder / "run.json");
  EXPECT_EQ(written.status, "finished");
  EXPECT_EQ(written.steps, result.steps);
  EXPECT_EQ(written.time, 2.5);
  EXPECT_EQ(written.scene_id, identify_scene("title = \"A spring\"\n"));
  EXPECT_FALSE(written.ended.empty());
}

TEST_F(Run, AFailureNamesTheLastGoodFrameAndLeavesAllReadable) {
  simulation.fails_at = 1.05;
  try {
    start(options());
    FAIL() << "the failure was swallowed";
  } catch (const NumericalError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("density of particle 0 is negative"), std::string::npos) << message;
    EXPECT_NE(message.find("last good frame: 10 at 1 s"), std::string::npos) << message;
    EXPECT_EQ(read_provenance(folder / "run.json").reason, message);
  }
  EXPECT_EQ(read_provenance(folder / "run.json").status, "failed");
  EXPECT_EQ(numbered_frames(folder / "frames").size(), 11U);
  EXPECT_GE(read_history(folder / "history.csv").find("time")->values.back(), 1.05 - 0.0123 * 2.5);
}

TEST_F(Run, AnErrorOfTheDiskIsWrittenDownAndThrownOn) {
  struct FullDisk : FrameWriter {
    void write(const Frame& frame) override {
      if (frame.index == 2) throw MissingResourceError("no space left");
    }
  } frames;
  EXPECT_THROW(run(simulation, scene, options(), frames, progress), MissingResourceError);
  EXPECT_EQ(read_provenance(folder / "run.json").status, "failed");
  EXPECT_EQ(read_provenance(folder / "run.json").reason, "no space left");
}

TEST_F(Run, ProgressGrowsToTheEnd) {
  start(options());
  EXPECT_TRUE(std::is_sorted(progress.fractions.begin(), progress.fractions.end()));
  EXPECT_EQ(progress.fractions.back(), 1.0);
}

TEST_F(Run, GoesFurtherThanTheRunItContinues) {
  start(options());
  const std::string last_of_short_run = read_text(folder / "frames/spring_000025.h5");
  scene.time.end = 3.0;
  restart(read_provenance(folder / "run.json").steps);
  EXPECT_EQ(read_text(folder / "frames/spring_000025.h5"), last_of_short_run);
  EXPECT_EQ(numbered_frames(folder / "frames").size(), 31U);
  EXPECT_EQ(read_history(folder / "history.csv").find("time")->values.back(), 3.0);
}

}  // namespace
}  // namespace anvil
