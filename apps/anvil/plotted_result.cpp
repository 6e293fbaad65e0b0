// SPDX-License-Identifier: BSD-3-Clause
#include "plotted_result.hpp"

#include <memory>
#include <utility>

#include "anvil/output/result_folder.hpp"
#include "frames.hpp"

namespace anvil {
namespace {

/// A figure asks for the same frame once per panel.
struct LastFrame {
  std::size_t place = static_cast<std::size_t>(-1);
  Frame frame;
};

}  // namespace

PlottedResult open_result(const std::filesystem::path& path, const ArrayNames& names) {
  const auto series = list_frames(path);
  PlottedResult result{bare_name(path).filename().string(), recorded_scene(path), std::nullopt, {}, {}};
  const ResultFolder folder{std::filesystem::is_directory(path) ? path : path.parent_path()};
  if (std::error_code ignored; std::filesystem::exists(folder.history(), ignored))
    result.history = read_history(folder.history());
  for (const auto& entry : series) result.times.push_back(entry.time);
  result.frame = [series, names, last = std::make_shared<LastFrame>()](std::size_t place) {
    if (last->place != place) *last = {place, read_entry(series.at(place), names)};
    return last->frame;
  };
  return result;
}

}  // namespace anvil
