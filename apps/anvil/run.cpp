// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/solver/run.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <memory>
#include <string>
#include <utility>

#include "anvil/checkpoint/checkpoint.hpp"
#include "anvil/core/error.hpp"
#include "anvil/core/threads.hpp"
#include "anvil/scene/reader.hpp"
#include "anvil/scene/writer.hpp"
#include "anvil/version.hpp"
#include "command_line.hpp"
#include "frames.hpp"
#include "progress.hpp"
#include "recommend.hpp"

namespace anvil {
namespace {

namespace po = boost::program_options;

volatile std::sig_atomic_t received_signal = 0;

/// The first signal lets the run finish its step and write a checkpoint, a second one ends it at once.
void catch_signals() {
  struct sigaction action {};
  action.sa_handler = [](int signal) { received_signal = signal; };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

/// A run that is ready to start: everything that can be wrong with the input has been found by then.
struct PreparedRun {
  Scene scene;
  std::unique_ptr<Simulation> simulation;
  RunOptions options;
};

PreparedRun prepare_start(const po::variables_map& values, const std::string& argument) {
  PreparedRun prepared;
  auto overrides = repeated(values, "set");
  if (const auto recommended = recommendation_of(values, argument, overrides)) {
    overrides.insert(overrides.end(), recommended->settings.begin(), recommended->settings.end());
    if (!values["quiet"].as<bool>())
      fmt::print("settings    {}\n{}", fmt::join(recommended->settings, "  "), describe(*recommended));
  }
  prepared.scene = read_scene(locate_scene(argument), overrides);
  prepared.options.scene_text = write_scene(prepared.scene);
  const auto folder = values.count("output") != 0 ? std::filesystem::path(values["output"].as<std::string>())
                                                  : std::filesystem::path("results") / prepared.scene.name;
  prepared.simulation = make_simulation(prepared.scene);
  prepared.options.folder =
      start_result(folder, identify_scene(prepared.options.scene_text), values["overwrite"].as<bool>());
  return prepared;
}

/// A series, its history and its checkpoints belong to one scene: a restart may only ask for more or less of them.
void check_restart_overrides(const std::vector<std::string>& overrides) {
  constexpr std::array allowed = {"time.end=", "output.interval=", "output.checkpoint_interval="};
  for (const auto& text : overrides) {
    const auto matches = [&](const char* key) { return text.rfind(key, 0) == 0; };
    if (std::none_of(allowed.begin(), allowed.end(), matches))
      throw InputError(
          fmt::format("--set {} cannot go with --restart, where only time.end, output.interval and "
                      "output.checkpoint_interval can change; start a new run for it",
                      text));
  }
}

PreparedRun prepare_restart(const po::variables_map& values) {
  if (values.count("output") != 0 || values.count("SCENE") != 0 || values["overwrite"].as<bool>())
    throw InputError(
        "--restart goes on with the scene and in the folder of its checkpoint: give it alone, or with "
        "--set; to keep the old result, copy its folder first");
  const std::filesystem::path path = values["restart"].as<std::string>();
  const auto overrides = repeated(values, "set");
  check_restart_overrides(overrides);
  const Checkpoint checkpoint = read_checkpoint(path);
  if (checkpoint.version != version || checkpoint.commit != commit)
    spdlog::warn("the checkpoint was written by anvil {} ({}), this is {} ({}): the bits may differ",
                 checkpoint.version, checkpoint.commit, version, commit);
  PreparedRun prepared;
  prepared.scene = read_scene_text(checkpoint.scene_text, checkpoint.scene_name, overrides);
  if (prepared.scene.time.end < checkpoint.time)
    throw InputError(fmt::format("the checkpoint '{}' is at {:.6g} s, after time.end = {:.6g} s", path.string(),
                                 checkpoint.time, prepared.scene.time.end));
  prepared.options.scene_text = write_scene(prepared.scene);
  prepared.options.restart = RestartPoint{checkpoint.next_frame, checkpoint.history_rows};
  prepared.simulation = make_simulation(prepared.scene);
  prepared.simulation->restore(checkpoint.state);
  prepared.options.folder = continue_result(path, checkpoint.step);
  return prepared;
}

void use_threads(const po::variables_map& values) {
  if (values.count("threads") == 0) return;
  constexpr int most = 1024;
  const int threads = values["threads"].as<int>();
  if (threads < 1 || threads > most)
    throw InputError(fmt::format("--threads must be a whole number from 1 to {}, found {}", most, threads));
  set_thread_count(threads);
}

Usage make_usage() {
  Usage usage{"anvil run SCENE [-o DIR] [options]\n       anvil run --restart CHECKPOINT [options]",
              "Runs a scene file, or the bundled scene of that name, and writes frames, history.csv, run.json and\n"
              "checkpoints into a folder. Ctrl-C finishes the step, writes a checkpoint and ends with exit code 130.",
              "SCENE"};
  auto add = usage.options.add_options();
  add("output,o", po::value<std::string>()->value_name("DIR"), "folder of the result (default: results/<scene>)");
  add("overwrite", po::bool_switch(), "replace a different result in that folder");
  add("restart", po::value<std::string>()->value_name("CHECKPOINT"),
      "go on from a checkpoint, in its folder; time.end and output intervals can be changed by --set");
  add("threads", po::value<int>()->value_name("N"), "number of threads (default: all processors)");
  add("quiet", po::bool_switch(), "no progress, no summary");
  add_wish_options(usage.options);
  add_scene_options(usage);
  return usage;
}

void print_summary(const Provenance& result, const ResultFolder& folder) {
  fmt::print("{}: {} at {:.6g} s after {} steps, {:.1f} s, {:.3g} particle-steps per second\nresult in {}\n",
             result.scene_name, result.status, result.time, result.steps, result.wall_time,
             result.particle_steps_per_second, folder.path.string());
}

}  // namespace

int execute_run(const Arguments& arguments) {
  Usage usage = make_usage();
  const auto values = parse(usage, arguments);
  if (!values) return 0;
  use_threads(*values);
  PreparedRun prepared = values->count("restart") != 0 ? prepare_restart(*values)
                                                       : prepare_start(*values, required(*values, usage, "SCENE"));
  const bool quiet = (*values)["quiet"].as<bool>();
  const ResultFolder& folder = prepared.options.folder;
  const int first_frame = prepared.options.restart ? prepared.options.restart->next_frame : 0;
  catch_signals();
  prepared.options.stop_requested = [] { return received_signal != 0; };
  const auto frames = make_frame_writer(prepared.scene, folder.path, first_frame);
  auto progress = make_progress(quiet);
  const Provenance result = run(*prepared.simulation, prepared.scene, prepared.options, *frames, *progress);
  progress.reset();  // ends its line before the summary
  if (!quiet) print_summary(result, folder);
  constexpr int stopped_by_signal = 128;
  return result.status == "stopped" ? stopped_by_signal + received_signal : 0;
}

}  // namespace anvil
