// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace anvil {

/// Where a result comes from and how it was made: the content of run.json. It names no machine and no user.
struct Provenance {
  std::string title;
  std::string scene_name;
  std::string scene_text;  // the resolved scene, TOML
  std::string scene_id;    // identifier of scene_text
  std::string version;     // of the program
  std::string commit;
  std::string compiler;
  std::string instruction_set;  // of the loops over pairs and points: other sets round differently
  int threads = 1;
  std::string status;   // running, finished, stopped, failed
  std::string reason;   // why it failed or stopped, else ""
  std::string started;  // UTC, ISO 8601
  std::string ended;    // the same, "" while it runs
  std::int64_t particles = 0;
  std::int64_t steps = 0;       // since time 0
  double time = 0.0;            // s, reached
  std::int64_t first_step = 0;  // where this start began: 0, or the step of the checkpoint
  double wall_time = 0.0;       // s, of this start
  double step_time = 0.0;       // s, the part of it in steps: the rest is placing particles and writing
  double particle_steps_per_second = 0.0;
};

/// Provenance with what the program knows of itself filled in: version, commit, compiler, instruction set, threads.
Provenance make_provenance();

/// Name-based UUID (RFC 4122, version 5) of a resolved scene: equal scenes have equal identifiers.
std::string identify_scene(const std::string& scene_text);

/// The present moment, UTC, as 2026-01-31T12:00:00Z.
std::string utc_now();

/// run.json: written under a temporary name first; throws MissingResourceError.
void write_provenance(const std::filesystem::path& path, const Provenance& provenance);

/// Throws InputError when the file cannot be read or is no run.json of anvil.
Provenance read_provenance(const std::filesystem::path& path);

}  // namespace anvil
