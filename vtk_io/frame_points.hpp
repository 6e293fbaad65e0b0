// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <string>

#include "anvil/output/frame.hpp"

class vtkPointSet;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace anvil {

/// A frame as VTK sees it: one point and one vertex cell per particle, the arrays of the frame as point arrays with
/// component names, and as field data TimeValue (s), frame_index, step, dimension, scene, units (one text
/// "velocity: m/s" per array) and one text per entry of the provenance.
vtkSmartPointer<vtkPolyData> make_poly_data(const Frame& frame, bool double_precision);
vtkSmartPointer<vtkUnstructuredGrid> make_unstructured_grid(const Frame& frame, bool double_precision);

/// The way back. `source` names the file in errors. Throws InputError when the points are not what Anvil writes.
Frame make_frame(vtkPointSet& points, const std::string& source);

}  // namespace anvil
