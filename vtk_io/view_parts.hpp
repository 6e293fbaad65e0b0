// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkBoundingBox.h>
#include <vtkLookupTable.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <array>

#include "vtk_io/drawn_particles.hpp"
#include "vtk_io/render.hpp"

namespace anvil {

using Direction = std::array<double, 3>;

/// Spheres around the points, coloured by their scalars.
void add_spheres(vtkRenderer* view, vtkPolyData* points, double radius, vtkLookupTable* colors);

/// The same as flat discs, for views straight from above.
void add_discs(vtkRenderer* view, vtkPolyData* points, double radius, vtkLookupTable* colors);

/// Grey discs, nothing for nullptr. In space they are to be small: what lies behind them has to be seen.
void add_wall_particles(vtkRenderer* view, vtkPolyData* points, double radius);

void add_surface(vtkRenderer* view, vtkPolyData* surface, vtkLookupTable* colors);

/// The twelve edges of a box.
void add_outline(vtkRenderer* view, const vtkBoundingBox& box);

/// Lines as they are, in a shade from black (0) to white (1). Nothing for nullptr.
void add_edges(vtkRenderer* view, vtkPolyData* lines, float width, double shade);

/// Flat polygons in the colours of their points, without shading.
void add_flat_surface(vtkRenderer* view, vtkPolyData* surface, vtkLookupTable* colors);

/// A square piece of the wall under the middle of `body` (mm), as wide as it needs to be.
void add_wall(vtkRenderer* view, const Plane& wall, const vtkBoundingBox& body);

/// The same in a flat scene: a line below or beside `body` and a strip of the wall behind it.
void add_wall_line(vtkRenderer* view, const Plane& wall, const vtkBoundingBox& body);

/// What stands around bodies in space: outline, walls and an upright scale; then turns the camera to all of it.
void add_surroundings(vtkRenderer* view, const DrawnParticles& particles, const RenderOptions& options,
                      const vtkBoundingBox& shown, int font_height);

/// Scales in millimetres below and to the left of a flat `box`.
void add_axes(vtkRenderer* view, const vtkBoundingBox& box, int font_height);

/// Coordinates from `begin` to `begin` + `length` along `axis` (unit vectors), ticks and numbers towards `side`. `room`
/// is the longest side of what the picture shows, mm; a picture of metres has its numbers in metres.
void add_ruler(vtkRenderer* view, const Direction& begin, const Direction& axis, const Direction& side, double length,
               double room, int font_height);

/// Looks at `box` along -`direction` with `up` upward, from close enough that it just fits.
void aim_camera(vtkRenderer* view, const vtkBoundingBox& box, const Direction& direction, const Direction& up);

}  // namespace anvil
