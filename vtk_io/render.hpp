// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace anvil {

/// A rigid wall to draw: it fills the half space against `normal`.
struct WallPlane {
  std::array<double, 3> point{0.0, 0.0, 0.0};   // m
  std::array<double, 3> normal{0.0, 0.0, 1.0};  // any length but 0
};

/// Values at the two ends of the colour bar, in SI units as in the particle files, whatever unit the picture shows.
struct FieldRange {
  double low = 0.0;
  double high = 1.0;
};

/// What a view shows and how. Every member has a default that makes a good picture of a deformed body.
struct RenderOptions {
  /// What colours the particles: the name of an array ("pressure"; of a vector its length), one component of one
  /// ("velocity.z", "stress.xy"), or "von_mises" (from the stress). Empty: plastic_strain, else pressure, else
  /// velocity.
  std::string field;
  /// Index of the frame as it stands in the file's name; absent: the last one.
  std::optional<int> frame;
  /// Absent: from the frame, rounded outward; a field without negative values starts at 0.
  std::optional<FieldRange> range;
  /// Smooth surface instead of spheres (3D only).
  bool surface = false;
  /// A second view beside the first, with the quarter nearest to the viewer cut away (3D only).
  bool cut = true;
  /// Undeformed outline, from initial_position.
  bool outline = true;
  /// Rigid walls, as the scene has them; none by default.
  std::vector<WallPlane> walls;
  /// First line of the picture; empty: the provenance text "title", else the name of the scene.
  std::string title;
  /// From the bodies to the viewer (3D only); z points up in the picture. Must not be along z.
  std::array<double, 3> view_direction{0.5, -1.0, 0.4};
  std::array<int, 2> size{1600, 1200};              // pixels
  std::array<double, 3> background{1.0, 1.0, 1.0};  // red, green, blue, 0 to 1
};

/// Draws one frame of `result` (a result folder, a .pvd, a .vtp or a .vtu) off-screen into a PNG file, which appears
/// under its name only when complete. Throws InputError when the result, the frame or the field does not exist or an
/// option makes no sense, MissingResourceError without a way to draw (X server, font) or to write.
void render_result(const std::filesystem::path& result, const RenderOptions& options, const std::filesystem::path& png);

}  // namespace anvil
