// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "anvil/measures/mirror.hpp"
#include "anvil/output/frame.hpp"

namespace anvil {

/// Values at the two ends of the colour bar, in SI units as in the particle files, whatever unit the picture shows.
struct FieldRange {
  double low = 0.0;
  double high = 1.0;
};

/// What the pictures of a series share, so that nothing in them jumps: found with include_frame.
struct SeriesExtent {
  std::optional<FieldRange> values;             // of the field, SI
  std::optional<std::array<double, 6>> bounds;  // of all positions: x low, x high, y low, ..., m
};

enum class View {
  rod,        // a body in three dimensions, beside it the same with a quarter cut away
  particles,  // all particles as discs (2D) or spheres (3D)
  section     // the field on a plane through the bodies (3D) or in the plane of the scene (2D), smoothed by the kernel
};

/// What a view shows and how. Every member has a default that makes a good picture of a deformed body.
struct RenderOptions {
  /// Absent: rod in three dimensions, particles in fewer.
  std::optional<View> view;
  /// What gives the colours: a name or an expression as field_of knows them ("pressure", "velocity.z", "von_mises"), or
  /// "body" for a colour per body. Empty: plastic_strain, else pressure, else velocity.
  std::string field;
  /// One of color_map_names(); empty: the first.
  std::string color_map;
  /// Absent: from the series or the frame, rounded outward; a field without negative values starts at 0.
  std::optional<FieldRange> range;
  /// Of all frames of a series; absent: from this frame alone.
  std::optional<SeriesExtent> series;
  /// Smooth surface instead of spheres (view rod).
  bool surface = false;
  /// A second view beside the first, with the quarter nearest to the viewer cut away (view rod).
  bool cut = true;
  /// Undeformed outline, from initial_position.
  bool outline = true;
  /// Radius of a particle in shares of their spacing; 0: what closes the gaps between them.
  double glyph_radius = 0.0;
  /// Particles of the body of this number and of later ones are those of walls: grey, and without part in the range of
  /// colours. Absent: there are none.
  std::optional<int> first_wall;
  /// The particles of the bodies began on their faces (face_lattice), not half a spacing inside.
  bool on_faces = false;
  /// Where a section is; absent: through the middle of the bodies, across y. Only in three dimensions.
  std::optional<Plane> section;
  /// Rigid walls, as the scene has them; none by default. Each fills the half space against its normal.
  std::vector<Plane> walls;
  /// What bodies are called, in the order of their numbers; else "body 0" and so on.
  std::vector<std::string> body_names;
  /// First line of the picture; empty: the provenance text "title", else the name of the scene.
  std::string title;
  /// From the bodies to the viewer (3D only); z points up in the picture. Must not be along z.
  std::array<double, 3> view_direction{0.5, -1.0, 0.4};
  std::array<int, 2> size{1600, 1200};              // pixels
  std::array<double, 3> background{1.0, 1.0, 1.0};  // red, green, blue, 0 to 1
};

struct ColorMapName {
  std::string_view name;
  std::string_view summary;
};

/// The maps that RenderOptions::color_map can name, the standard one first.
std::vector<ColorMapName> color_map_names();

/// Makes the extent of a series cover one more frame. Throws InputError when the field does not exist.
void include_frame(SeriesExtent& series, Frame frame, const RenderOptions& options);

/// Draws a frame off-screen into a PNG file, which appears under its name only when complete. Throws InputError when
/// the field does not exist, the frame does not suit the view or an option makes no sense, MissingResourceError without
/// a way to draw (X server, font) or to write.
void render_frame(Frame frame, const RenderOptions& options, const std::filesystem::path& png);

}  // namespace anvil
