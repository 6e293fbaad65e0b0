// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/plane_picture.hpp"

#include <vtkClipPolyData.h>
#include <vtkContourFilter.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <cmath>

#include "anvil/core/error.hpp"
#include "anvil/measures/particle_interpolation.hpp"

namespace anvil {
namespace {

constexpr double half_full = 0.5;
constexpr double millimetres = 1e3;
constexpr const char* filling_name = "filling";

double along(const Point& point, const Point& direction) {
  return point[0] * direction[0] + point[1] * direction[1] + point[2] * direction[2];
}

void add_array(vtkImageData& grid, const char* name, const std::vector<double>& values) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  // A value that is none would spoil the polygons at the edge.
  for (std::size_t i = 0; i < values.size(); ++i)
    array->SetValue(static_cast<vtkIdType>(i), std::isfinite(values[i]) ? values[i] : 0.0);
  grid.GetPointData()->AddArray(array);
}

vtkSmartPointer<vtkImageData> make_grid(const SampleGrid& plane, const std::vector<double>& filling) {
  auto grid = vtkSmartPointer<vtkImageData>::New();
  grid->SetDimensions(plane.nodes[0], plane.nodes[1], 1);
  grid->SetSpacing(millimetres * plane.step[0], millimetres * plane.step[1], 1.0);
  grid->SetOrigin(millimetres * along(plane.origin, plane.u), millimetres * along(plane.origin, plane.v), 0.0);
  add_array(*grid, filling_name, filling);
  grid->GetPointData()->SetActiveScalars(filling_name);
  return grid;
}

}  // namespace

vtkSmartPointer<vtkPolyData> make_filled_part(const SampleGrid& plane, const std::vector<double>& filling,
                                              const std::vector<double>& values) {
  const auto grid = make_grid(plane, filling);
  add_array(*grid, "colored_by", values);
  vtkNew<vtkDataSetSurfaceFilter> cells;
  cells->SetInputData(grid);
  vtkNew<vtkClipPolyData> filled;
  filled->SetInputConnection(cells->GetOutputPort());
  filled->SetValue(half_full);
  filled->Update();
  filled->GetOutput()->GetPointData()->SetActiveScalars("colored_by");
  return filled->GetOutput();
}

vtkSmartPointer<vtkPolyData> make_edges(const SampleGrid& plane, const std::vector<double>& filling) {
  vtkNew<vtkContourFilter> contour;
  contour->SetInputData(make_grid(plane, filling));
  contour->SetValue(0, half_full);
  contour->Update();
  return contour->GetOutput();
}

vtkSmartPointer<vtkPolyData> make_undeformed_edges(const Frame& frame, const Plane& plane) {
  const FrameArray* initial = frame.find("initial_position");
  if (initial == nullptr || frame.dimension < 2) return nullptr;
  const double spacing = usual_spacing(initial->values, frame.dimension);
  InterpolationOptions options;
  options.smoothing_length = spacing;
  const ParticleInterpolation before(frame, initial->values, options);
  SampleGrid sample;
  try {
    sample = make_sample_plane(plane, box_around(initial->values, frame.dimension, 2.0 * spacing), 0.5 * spacing);
  } catch (const InputError&) {
    return nullptr;  // the bodies were elsewhere
  }
  return make_edges(sample, before.at(points_of(sample), {}).filling);
}

}  // namespace anvil
