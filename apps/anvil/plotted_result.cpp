// SPDX-License-Identifier: BSD-3-Clause
#include "plotted_result.hpp"

#include <memory>

#include "anvil/output/provenance.hpp"
#include "anvil/output/result_folder.hpp"
#include "anvil/scene/reader.hpp"
#include "frames.hpp"

namespace anvil {

PlottedResult open_result(const std::filesystem::path& path) {
  const ResultFolder folder{path};
  const Provenance run = read_provenance(folder.provenance());
  const std::filesystem::path bare = path.has_filename() ? path : path.parent_path();
  PlottedResult result{bare.filename().string(),
                       read_scene_text(run.scene_text, run.scene_name),
                       read_history(folder.history()),
                       {},
                       {}};
  // Only a frame knows its time; those in one dimension are small.
  const auto frames = std::make_shared<std::vector<Frame>>();
  for (const auto& [number, file] : numbered_frames(folder.frames())) {
    frames->push_back(read_any_frame(file));
    result.times.push_back(frames->back().time);
  }
  result.frame = [frames](std::size_t i) { return frames->at(i); };
  return result;
}

}  // namespace anvil
