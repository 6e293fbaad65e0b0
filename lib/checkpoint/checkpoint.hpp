// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "anvil/solver/simulation.hpp"

namespace anvil {

/// Everything that is needed to go on with a run as if it had never stopped.
struct Checkpoint {
  std::string scene_name;
  std::string scene_text;  // the resolved scene, TOML
  std::string version;     // of the program that wrote it
  std::string commit;
  double time = 0.0;  // s
  std::int64_t step = 0;
  int next_frame = 0;             // index of the next frame of the series
  std::int64_t history_rows = 0;  // rows of history.csv up to this step
  State state;
};

/// Writes an HDF5 file that holds every number with its bits, under a temporary name first. Throws
/// MissingResourceError.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// Throws InputError when the file is cut off, damaged or no checkpoint.
Checkpoint read_checkpoint(const std::filesystem::path& path);

/// Whether a file is a checkpoint; false when it is missing.
bool is_checkpoint(const std::filesystem::path& path);

}  // namespace anvil
