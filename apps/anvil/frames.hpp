// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>

#include "anvil/output/frame.hpp"
#include "anvil/scene/scene.hpp"

namespace anvil {

/// The writer that output.format asks for. A series that is continued keeps its frames before `first_index`.
std::unique_ptr<FrameWriter> make_frame_writer(const Scene& scene, const std::filesystem::path& folder,
                                               int first_index);

/// A frame of any format this build reads; throws InputError.
Frame read_any_frame(const std::filesystem::path& file);

}  // namespace anvil
