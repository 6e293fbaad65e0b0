// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkLookupTable.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

#include "vtk_io/render.hpp"

namespace anvil {

/// The colours of the map of that name over `range`; an empty name stands for "strain". Maps around zero get the
/// darkest colour only on the side of the range that reaches further. Throws InputError with the names there are.
vtkSmartPointer<vtkLookupTable> make_color_map(const std::string& name, const FieldRange& range);

/// A colour of its own for each whole number from 0 to `count` - 1.
vtkSmartPointer<vtkLookupTable> make_categories(int count);

}  // namespace anvil
