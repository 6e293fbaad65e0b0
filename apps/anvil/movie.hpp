// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace anvil {

/// The pictures of a series: <folder>/<name>_NNNNNN.png, numbered from 0.
struct PictureSeries {
  std::filesystem::path folder;
  std::string name;

  [[nodiscard]] std::filesystem::path picture(std::size_t number) const;
};

/// Whether ffmpeg can be started.
bool has_ffmpeg();

/// Joins the pictures of a series to a film that every player shows (H.264, 4:2:0); `film` appears under its name only
/// when complete. Throws MissingResourceError when ffmpeg fails.
void make_film(const PictureSeries& pictures, double frames_per_second, const std::filesystem::path& film);

}  // namespace anvil
