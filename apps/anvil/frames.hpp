// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "anvil/output/array_names.hpp"
#include "anvil/output/frame.hpp"
#include "anvil/output/provenance.hpp"
#include "anvil/scene/scene.hpp"
#include "command_line.hpp"

namespace anvil {

/// The writer that output.format asks for. A series that is continued keeps its frames before `first_index`.
std::unique_ptr<FrameWriter> make_frame_writer(const Scene& scene, const std::filesystem::path& folder,
                                               int first_index);

/// A frame of any format this build reads; throws InputError.
Frame read_any_frame(const std::filesystem::path& file, const ArrayNames& names = {});

/// The frames of a result, first to last: RESULT is the folder of a result, a .pvd, or a single frame of any format
/// this build reads, of Anvil or of another program. Throws InputError when there are none.
std::vector<SeriesEntry> list_frames(const std::filesystem::path& result);

/// The frame of an entry with the time of the series, which files of other programs may lack.
Frame read_entry(const SeriesEntry& entry, const ArrayNames& names);

/// The scene recorded in the folder that RESULT is or lies in; absent for what no run of Anvil left behind.
std::optional<Scene> recorded_scene(const std::filesystem::path& result);

/// "results/plate" of "results/plate/", "rod.pvd" and "frames/rod_000012.vtp": what pictures of it are named after.
std::filesystem::path bare_name(const std::filesystem::path& result);

/// Adds --array, --frame and --time, for the subcommands that read frames.
void add_frame_options(Usage& usage);
ArrayNames array_names_from(const boost::program_options::variables_map& values);

/// The frame that --frame or --time asks for, else the last one. Throws InputError with what there is.
SeriesEntry chosen_frame(const std::vector<SeriesEntry>& series, const boost::program_options::variables_map& values);

}  // namespace anvil
