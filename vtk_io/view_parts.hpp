// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkBoundingBox.h>
#include <vtkLookupTable.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <array>

#include "vtk_io/render.hpp"

namespace anvil {

using Direction = std::array<double, 3>;

/// Spheres around the points, coloured by their scalars.
void add_spheres(vtkRenderer* view, vtkPolyData* points, double radius, vtkLookupTable* colors);

/// The same as flat discs, for views straight from above.
void add_discs(vtkRenderer* view, vtkPolyData* points, double radius, vtkLookupTable* colors);

void add_surface(vtkRenderer* view, vtkPolyData* surface, vtkLookupTable* colors);

/// The twelve edges of a box.
void add_outline(vtkRenderer* view, const vtkBoundingBox& box);

/// A square piece of the wall under the middle of `body` (mm), as wide as it needs to be.
void add_wall(vtkRenderer* view, const WallPlane& wall, const vtkBoundingBox& body);

/// A scale in millimetres from `begin` to `begin` + `length` along `axis` (unit vectors), its ticks and numbers towards
/// `side`.
void add_ruler(vtkRenderer* view, const Direction& begin, const Direction& axis, const Direction& side, double length,
               int font_height);

/// Looks at `box` along -`direction` with `up` upward, from close enough that it just fits.
void aim_camera(vtkRenderer* view, const vtkBoundingBox& box, const Direction& direction, const Direction& up);

}  // namespace anvil
