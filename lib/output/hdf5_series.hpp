// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "anvil/output/frame.hpp"

namespace anvil {

/// Writes each frame into an HDF5 file of its own, FOLDER/frames/<scene>_NNNNNN.h5: all numbers in double, one table
/// per array (particles x components) with its unit as an attribute. What a build without VTK writes.
class Hdf5Series : public FrameWriter {
 public:
  /// Starts a series or, with `first_index` above 0, continues the one in `folder`: its frames from `first_index` on
  /// are deleted because the run writes them again. Throws MissingResourceError when the folder cannot be written.
  Hdf5Series(const std::filesystem::path& folder, std::string scene, int first_index = 0);
  void write(const Frame& frame) override;

 private:
  std::filesystem::path frames_;
  std::string scene_;
};

/// One file of such a series; throws InputError when it is damaged or something else.
Frame read_hdf5_frame(const std::filesystem::path& path);

/// The time of such a file (s), without reading its arrays; throws as read_hdf5_frame does.
double read_hdf5_time(const std::filesystem::path& path);

}  // namespace anvil
