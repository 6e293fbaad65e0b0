// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/core.h>

#include <filesystem>

#include "anvil/checkpoint/checkpoint.hpp"
#include "anvil/core/error.hpp"
#include "anvil/output/hdf5_file.hpp"
#include "anvil/output/provenance.hpp"
#include "anvil/output/result_folder.hpp"
#include "command_line.hpp"
#include "frames.hpp"
#include "table.hpp"

namespace anvil {
namespace {

namespace fs = std::filesystem;

void print_run(const Provenance& run) {
  std::vector<TableRow> rows = {{"title", run.title},       {"scene", run.scene_name}, {"scene id", run.scene_id},
                                {"status", run.status},     {"version", run.version},  {"commit", run.commit},
                                {"compiler", run.compiler}, {"started", run.started},  {"ended", run.ended}};
  if (!run.reason.empty()) rows.insert(rows.begin() + 4, {"reason", run.reason});
  rows.push_back({"instruction set", run.instruction_set});
  rows.push_back({"threads", std::to_string(run.threads)});
  rows.push_back({"particles", std::to_string(run.particles)});
  rows.push_back({"steps", std::to_string(run.steps)});
  rows.push_back({"time", fmt::format("{} s", run.time)});
  if (run.first_step > 0) rows.push_back({"restarted at step", std::to_string(run.first_step)});
  rows.push_back({"wall time", fmt::format("{:.3f} s, {:.3f} s of it in steps", run.wall_time, run.step_time)});
  rows.push_back({"particle-steps per second", fmt::format("{:.4g}", run.particle_steps_per_second)});
  print_table(rows, "ll");
  fmt::print("\n{}", run.scene_text);
}

void print_frame(const Frame& frame) {
  std::vector<TableRow> rows = {{"scene", frame.scene},
                                {"frame", std::to_string(frame.index)},
                                {"time", fmt::format("{} s", frame.time)},
                                {"step", std::to_string(frame.step)},
                                {"particles", std::to_string(frame.particle_count())}};
  for (const auto& [name, text] : frame.provenance) rows.push_back({name, text});
  for (const auto& array : frame.arrays)
    rows.push_back({"array", fmt::format("{} ({}){}", array.name, array.components,
                                         array.unit.empty() ? "" : " [" + array.unit + "]")});
  print_table(rows, "ll");
}

void print_checkpoint(const Checkpoint& checkpoint) {
  print_table({{"checkpoint of", checkpoint.scene_name},
               {"scene id", identify_scene(checkpoint.scene_text)},
               {"version", checkpoint.version},
               {"commit", checkpoint.commit},
               {"time", fmt::format("{} s", checkpoint.time)},
               {"step", std::to_string(checkpoint.step)},
               {"next frame", std::to_string(checkpoint.next_frame)},
               {"rows of the history", std::to_string(checkpoint.history_rows)}},
              "ll");
  fmt::print("\n{}", checkpoint.scene_text);
}

}  // namespace

int execute_info(const Arguments& arguments) {
  Usage usage{"anvil info FILE",
              "Shows where a result comes from. FILE is the folder of a result, its run.json, one of its frames or a "
              "checkpoint.",
              "FILE"};
  const auto values = parse(usage, arguments);
  if (!values) return 0;
  const fs::path file = required(*values, usage, "FILE");
  if (std::error_code ignored; !fs::exists(file, ignored))
    throw InputError(fmt::format("there is no file '{}'", file.string()));
  if (fs::is_directory(file)) {
    print_run(read_provenance(ResultFolder{file}.provenance()));
  } else if (file.extension() == ".json") {
    print_run(read_provenance(file));
  } else if (is_checkpoint(file)) {
    print_checkpoint(read_checkpoint(file));
  } else {
    print_frame(read_any_frame(file));
  }
  return 0;
}

}  // namespace anvil
