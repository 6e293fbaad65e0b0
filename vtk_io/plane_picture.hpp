// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "anvil/measures/sample_places.hpp"
#include "anvil/output/frame.hpp"

namespace anvil {

/// The part of a plane that is at least half full, coloured by `values` (one per point of the plane), as flat polygons
/// whose x and y run along u and v, in millimetres from the origin of space.
vtkSmartPointer<vtkPolyData> make_filled_part(const SampleGrid& plane, const std::vector<double>& filling,
                                              const std::vector<double>& values);

/// Lines where the plane is half full: the edges of the bodies. Coordinates as above.
vtkSmartPointer<vtkPolyData> make_edges(const SampleGrid& plane, const std::vector<double>& filling);

/// The edges of the bodies before the deformation, cut by `plane` as far as it goes through them; nullptr when the
/// frame does not say where they were.
vtkSmartPointer<vtkPolyData> make_undeformed_edges(const Frame& frame, const Plane& plane);

}  // namespace anvil
