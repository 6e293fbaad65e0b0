// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkLookupTable.h>
#include <vtkSmartPointer.h>

#include "vtk_io/render.hpp"

namespace anvil {

/// Light grey at zero, over yellow and red to dark red upward and over light blue to dark blue downward: where nothing
/// happens, shading shows the shape. The ends of `range` get the darkest colour only on the side that reaches further.
vtkSmartPointer<vtkLookupTable> make_color_map(const FieldRange& range);

}  // namespace anvil
