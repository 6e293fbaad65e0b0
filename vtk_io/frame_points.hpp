// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <string>

#include "anvil/output/frame.hpp"

class vtkDataSet;
class vtkPointSet;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace anvil {

/// A frame as VTK sees it: one point and one vertex cell per particle, the arrays of the frame as point arrays with
/// component names, and as field data TimeValue (s), frame_index, step, dimension, scene, units (one text
/// "velocity: m/s" per array) and one text per entry of the provenance.
vtkSmartPointer<vtkPolyData> make_poly_data(const Frame& frame, bool double_precision);
vtkSmartPointer<vtkUnstructuredGrid> make_unstructured_grid(const Frame& frame, bool double_precision);

/// The arrays of a frame as point arrays, and its field data, for points or nodes that lie elsewhere.
void add_arrays(const Frame& frame, bool double_precision, vtkDataSet& target);

/// The way back, also from what other programs write: without TimeValue the time is 0, without dimension it follows
/// from the extent of the points, vectors of two components and full tensors become Anvil's. `source` names the file in
/// errors. Throws InputError when there are no points or an array is incomplete.
Frame make_frame(vtkPointSet& points, const std::string& source);

}  // namespace anvil
