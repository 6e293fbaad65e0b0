// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/output/result_folder.hpp"

#include <fmt/core.h>

#include <charconv>
#include <system_error>
#include <vector>

#include "anvil/core/error.hpp"
#include "anvil/output/atomic_file.hpp"
#include "anvil/output/provenance.hpp"

namespace anvil {
namespace {

namespace fs = std::filesystem;

/// The number that follows the first `prefix` letters of a stem: 12 in rod_000012 and checkpoint_12.
std::optional<std::int64_t> number_after(const std::string& stem, std::size_t prefix) {
  std::int64_t number = 0;
  const char* const end = stem.data() + stem.size();
  const auto [stop, error] = std::from_chars(stem.data() + prefix, end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

std::optional<std::int64_t> checkpoint_number(const fs::path& file) {
  const std::string prefix = "checkpoint_";
  const std::string stem = file.stem().string();
  if (file.extension() != ".h5" || stem.rfind(prefix, 0) != 0) return std::nullopt;
  return number_after(stem, prefix.size());
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& item : fs::directory_iterator(folder, error)) files.push_back(item.path());
  if (error && error != std::errc::no_such_file_or_directory) throw_system_error("read", folder, error.value());
  return files;
}

/// Removes what a run leaves behind, and nothing else. The series goes before its frames, and run.json, which tells
/// that this is a result, goes last.
void remove_result(const ResultFolder& folder) {
  for (const auto& file : files_in(folder.path))
    if (checkpoint_number(file) || file.extension() == ".pvd") remove_file(file);
  for (const auto& [number, file] : numbered_frames(folder.frames())) remove_file(file);
  remove_file(folder.history());
  remove_file(folder.provenance());
}

/// Refuses a folder that a run of the scene must not write into; changes nothing.
void check_result_folder(const fs::path& path, const std::string& scene_id, bool overwrite) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return;
  if (!fs::is_directory(path, ignored))
    throw InputError(fmt::format("'{}' is a file; name a folder for the result", path.string()));
  const ResultFolder folder{path};
  if (files_in(path).empty()) return;
  if (!fs::exists(folder.provenance(), ignored))
    throw InputError(fmt::format("the folder '{}' holds files that are no result of anvil; name another with -o DIR",
                                 path.string()));
  if (overwrite) return;
  const Provenance earlier = read_provenance(folder.provenance());
  if (earlier.scene_id != scene_id)
    throw InputError(
        fmt::format("'{}' holds a result of a different scene or setting ({}); name another folder with "
                    "-o DIR, or replace it with --overwrite",
                    path.string(), earlier.title));
}

}  // namespace

fs::path ResultFolder::checkpoint(std::int64_t step) const { return path / fmt::format("checkpoint_{}.h5", step); }

fs::path ResultFolder::last_frame() const {
  const auto found = numbered_frames(frames());
  if (found.empty()) throw InputError(fmt::format("'{}' holds no frames: is it the result of a run?", path.string()));
  return found.rbegin()->second;
}

std::optional<std::int64_t> frame_number(const fs::path& file) {
  const std::string stem = file.stem().string();
  const std::size_t underscore = stem.rfind('_');
  if (stem.empty() || stem.front() == '.' || underscore == std::string::npos) return std::nullopt;
  return number_after(stem, underscore + 1);
}

std::map<std::int64_t, fs::path> numbered_frames(const fs::path& folder) {
  std::map<std::int64_t, fs::path> frames;
  for (const auto& file : files_in(folder))
    if (const auto number = frame_number(file)) frames[*number] = file;
  return frames;
}

ResultFolder start_result(const fs::path& path, const std::string& scene_id, bool overwrite) {
  check_result_folder(path, scene_id, overwrite);
  const ResultFolder folder{path};
  ensure_folder(path);
  remove_result(folder);
  return folder;
}

ResultFolder continue_result(const fs::path& checkpoint, std::int64_t step) {
  const ResultFolder folder{checkpoint.has_parent_path() ? checkpoint.parent_path() : fs::path(".")};
  std::error_code ignored;
  if (!fs::exists(folder.provenance(), ignored) || !fs::exists(folder.history(), ignored))
    throw InputError(
        fmt::format("'{}' does not lie in the folder of its run (run.json and history.csv are missing); "
                    "a restart goes on where the checkpoint lies",
                    checkpoint.string()));
  for (const auto& file : files_in(folder.path))
    if (const auto number = checkpoint_number(file); number && *number > step) remove_file(file);
  return folder;
}

}  // namespace anvil
