// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace anvil {

/// The names in the folder that holds a result.
struct ResultFolder {
  std::filesystem::path path;

  [[nodiscard]] std::filesystem::path history() const { return path / "history.csv"; }
  [[nodiscard]] std::filesystem::path provenance() const { return path / "run.json"; }
  [[nodiscard]] std::filesystem::path frames() const { return path / "frames"; }
  [[nodiscard]] std::filesystem::path checkpoint(std::int64_t step) const;
  /// The frame with the highest number, whatever its format; throws InputError when there is none.
  [[nodiscard]] std::filesystem::path last_frame() const;
};

/// Readies `path` for a new run of the scene of that identifier. A folder that is missing, empty, or holds an earlier
/// result of the same scene is fine, and so is any other result when `overwrite` is set: what a run leaves behind is
/// removed from it. Otherwise throws InputError; a folder that is no result is never touched.
ResultFolder start_result(const std::filesystem::path& path, const std::string& scene_id, bool overwrite);

/// Readies the folder of a checkpoint for going on from it: later checkpoints are removed, for the run makes them
/// again; so does the writer of the frames with its own. Throws InputError when the folder is not that of the run.
ResultFolder continue_result(const std::filesystem::path& checkpoint, std::int64_t step);

/// The number that a frame carries in its file's name: 12 of rod_000012.vtp. Absent for other names.
std::optional<std::int64_t> frame_number(const std::filesystem::path& file);

/// The frames in a folder by their number: rod_000012.vtp is number 12. Empty when there is no such folder.
std::map<std::int64_t, std::filesystem::path> numbered_frames(const std::filesystem::path& folder);

}  // namespace anvil
