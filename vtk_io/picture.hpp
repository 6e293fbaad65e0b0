// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkBoundingBox.h>
#include <vtkLookupTable.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include "vtk_io/drawn_particles.hpp"
#include "vtk_io/field_selection.hpp"
#include "vtk_io/render.hpp"

namespace anvil {

/// A frame as it is drawn: the bodies, and where the particles of walls are, 3 numbers each, m.
struct FrameParts {
  Frame bodies;
  std::vector<double> wall_positions;
};

/// A window with all that does not belong to a single view: title, time, and what the colours mean.
struct Picture {
  vtkSmartPointer<vtkRenderWindow> window;
  vtkSmartPointer<vtkLookupTable> colors;
  DrawnParticles particles;
  vtkSmartPointer<vtkPolyData> wall_particles;  // nullptr when there are none
  vtkBoundingBox shown;  // bodies of the frame, of the series and before the deformation, and walls, mm
  int font_height = 32;  // pixels
};

/// The part of the window where views go: left, bottom, right, top (0 to 1).
inline constexpr std::array<double, 4> view_part{0.0, 0.0, 0.84, 0.92};

/// What gives the colours, in the unit of the colour bar. Throws InputError when the field does not exist.
SelectedField colored_by(const Frame& frame, const RenderOptions& options);

/// Throws InputError when the field does not exist or the range is empty.
Picture make_picture(const FrameParts& frame, const RenderOptions& options);

/// The box around particles with their radius, mm.
vtkBoundingBox box_of(const DrawnParticles& particles);

// The views, one file each. They throw as render_frame does.
void render_rod(const FrameParts& frame, const RenderOptions& options, const std::filesystem::path& png);
void render_particles(const FrameParts& frame, const RenderOptions& options, const std::filesystem::path& png);
void render_section(const FrameParts& frame, const RenderOptions& options, const std::filesystem::path& png);

}  // namespace anvil
