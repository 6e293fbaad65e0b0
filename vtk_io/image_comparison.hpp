// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>

namespace anvil {

/// How alike two pictures are. Each number sees what the others miss.
struct ImageComparison {
  double similarity = 1.0;       // SSIM over the whole picture, 1 for the same
  double worst_region = 1.0;     // SSIM of the least similar square of 64 x 64 pixels
  double mean_difference = 0.0;  // mean absolute difference of the colours, of 255
  double worst_color = 0.0;      // largest difference of the mean colours of a square of 32 x 32 pixels, of 255

  /// Whether both pictures show the same, drawn perhaps by another version of the software.
  [[nodiscard]] bool same() const;
};

/// Compares two PNG files by the structural similarity index of Wang, Bovik, Sheikh and Simoncelli (2004), equation 13,
/// on the brightness in windows of 8 x 8 pixels. Throws InputError when a file cannot be read or the sizes differ.
ImageComparison compare_images(const std::filesystem::path& first, const std::filesystem::path& second);

/// What of a picture is not background (the colour of its first pixel).
struct ImageContent {
  double share = 0.0;                    // of all pixels
  std::array<int, 4> box{0, 0, -1, -1};  // left, bottom, right, top pixel of what is drawn
  int width = 0, height = 0;             // of the picture
};

/// Throws InputError when the file cannot be read.
ImageContent measure_content(const std::filesystem::path& png);

}  // namespace anvil
