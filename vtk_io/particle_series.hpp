// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "anvil/output/frame.hpp"
#include "anvil/scene/scene.hpp"
#include "vtk_io/series_file.hpp"

namespace anvil {

/// How particle files are written: the values of [output] in a scene file.
struct SeriesFormat {
  std::string format = "vtp";         // vtp, vtu
  std::string precision = "float32";  // float32, float64: positions and all arrays that are not integers
  std::string compression = "lz4";    // lz4, zlib, none
};

SeriesFormat series_format(const OutputControl& output);

/// Writes the frames of a run as FOLDER/frames/<scene>_NNNNNN.vtp (or .vtu), numbered by the index of the frame, and
/// FOLDER/<scene>.pvd, which ParaView opens as one series. Both appear under their names only when they are complete,
/// and the .pvd lists complete frames only, each time once.
class ParticleSeriesWriter : public FrameWriter {
 public:
  /// Starts a series or, with `first_index` above 0, continues the one in `folder`: its frames before `first_index`
  /// stay, later ones are deleted because the run writes them again. Throws InputError for an unknown format and
  /// MissingResourceError when the folder cannot be written.
  ParticleSeriesWriter(std::filesystem::path folder, std::string scene, SeriesFormat format, int first_index = 0);

  /// Throws MissingResourceError with the path and the reason when the disk is full or not writable.
  void write(const Frame& frame) override;

 private:
  [[nodiscard]] std::filesystem::path series_path() const;
  [[nodiscard]] std::filesystem::path frame_path(int index) const;
  void write_particles(const Frame& frame, const std::filesystem::path& file) const;
  void keep_frames_before(int first_index);
  void write_series() const;

  std::filesystem::path folder_;
  std::string scene_;
  SeriesFormat format_;
  std::map<int, SeriesEntry> entries_;  // by index of the frame
};

}  // namespace anvil
