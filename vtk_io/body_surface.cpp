// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/body_surface.hpp"

#include <vtkAppendPolyData.h>
#include <vtkClipPolyData.h>
#include <vtkCutter.h>
#include <vtkDoubleArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkImplicitBoolean.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>
#include <vtkSPHCubicKernel.h>
#include <vtkSPHInterpolator.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <cmath>
#include <vector>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

constexpr const char* fullness = "fullness";  // 1 inside, 0 outside
constexpr double half_full = 0.5;
constexpr double largest_grid = 1e8;  // nodes: about 2 GB
constexpr const char* volume = "volume";
constexpr const char* one = "one";
constexpr const char* colors = "colored_by";
constexpr double smoothing_ratio = 1.1;  // h / spacing: bridges the gaps between stretched rows of particles

void add_array(vtkPolyData& points, const char* name, const std::vector<double>& values) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(points.GetNumberOfPoints());
  for (vtkIdType i = 0; i < points.GetNumberOfPoints(); ++i)
    array->SetValue(i, values[values.size() == 1 ? 0 : static_cast<std::size_t>(i)]);
  points.GetPointData()->AddArray(array);
}

/// VTK takes volumes as masses over densities; without them it takes cubes of the smoothing length, too much.
vtkSmartPointer<vtkPolyData> with_volumes(const DrawnParticles& particles) {
  auto points = vtkSmartPointer<vtkPolyData>::New();
  points->ShallowCopy(particles.points);
  add_array(*points, volume,
            particles.volumes.empty() ? std::vector<double>{std::pow(particles.spacing, 3.0)} : particles.volumes);
  add_array(*points, one, {1.0});
  return points;
}

vtkSmartPointer<vtkPolyData> make_closed_surface(vtkDataSet* filling) {
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(filling);
  contour->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, fullness);
  contour->SetValue(0, half_full);
  contour->ComputeNormalsOff();
  contour->InterpolateAttributesOn();
  vtkNew<vtkWindowedSincPolyDataFilter> smooth;
  smooth->SetInputConnection(contour->GetOutputPort());
  smooth->SetNumberOfIterations(20);
  smooth->SetPassBand(0.2);
  smooth->NormalizeCoordinatesOn();
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(smooth->GetOutputPort());
  normals->SplittingOff();
  normals->Update();
  return normals->GetOutput();
}

/// The plane through the edge of the quarter across `axis` (0: x, 1: y); its normal points into the quarter.
vtkSmartPointer<vtkPlane> make_side(const Quarter& quarter, int axis) {
  auto plane = vtkSmartPointer<vtkPlane>::New();
  plane->SetOrigin(quarter.x, quarter.y, 0.0);
  plane->SetNormal(axis == 0 ? quarter.sign_x : 0.0, axis == 1 ? quarter.sign_y : 0.0, 0.0);
  return plane;
}

vtkSmartPointer<vtkPolyData> clip_quarter_away(vtkPolyData* surface, const Quarter& quarter) {
  vtkNew<vtkImplicitBoolean> inside;
  inside->SetOperationTypeToUnion();  // negative only where both sides are: in the rest of the body
  const auto side_x = make_side(quarter, 0);
  const auto side_y = make_side(quarter, 1);
  inside->AddFunction(side_x);
  inside->AddFunction(side_y);
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputData(surface);
  clip->SetClipFunction(inside);
  clip->InsideOutOn();
  clip->Update();
  return clip->GetOutput();
}

/// The face that the cut opens on one side of the quarter.
vtkSmartPointer<vtkPolyData> make_cut_face(vtkDataSet* filling, const Quarter& quarter, int axis) {
  const auto plane = make_side(quarter, axis);
  const auto other_side = make_side(quarter, 1 - axis);
  vtkNew<vtkCutter> section;
  section->SetInputData(filling);
  section->SetCutFunction(plane);
  vtkNew<vtkClipPolyData> half;
  half->SetInputConnection(section->GetOutputPort());
  half->SetClipFunction(other_side);
  half->Update();
  half->GetOutput()->GetPointData()->SetActiveScalars(fullness);
  vtkNew<vtkClipPolyData> filled;
  filled->SetInputData(half->GetOutput());
  filled->SetValue(half_full);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(filled->GetOutputPort());
  normals->Update();
  return normals->GetOutput();
}

}  // namespace

vtkSmartPointer<vtkDataSet> make_filling(const DrawnParticles& particles) {
  const double cell = particles.spacing / 2;
  double bounds[6];
  particles.points->GetBounds(bounds);
  vtkNew<vtkImageData> grid;
  int nodes[3];
  double origin[3];
  for (int i = 0; i < 3; ++i) {
    constexpr int margin = 6;  // cells: beyond the reach of the kernel
    origin[i] = bounds[2 * i] - margin * cell;
    nodes[i] = static_cast<int>(std::ceil((bounds[2 * i + 1] - bounds[2 * i]) / cell)) + 2 * margin + 1;
  }
  if (static_cast<double>(nodes[0]) * nodes[1] * nodes[2] > largest_grid)
    throw InputError("the particles are too far apart for a surface, some may have flown off: draw them as spheres");
  grid->SetOrigin(origin);
  grid->SetDimensions(nodes);
  grid->SetSpacing(cell, cell, cell);

  vtkNew<vtkSPHCubicKernel> kernel;
  kernel->SetSpatialStep(smoothing_ratio * particles.spacing);
  vtkNew<vtkSPHInterpolator> interpolator;
  interpolator->SetInputData(grid);
  interpolator->SetSourceData(with_volumes(particles));
  interpolator->SetMassArrayName(volume);
  interpolator->SetDensityArrayName(one);
  interpolator->SetKernel(kernel);
  interpolator->SetComputeShepardSum(true);
  interpolator->SetShepardSumArrayName(fullness);
  interpolator->SetShepardNormalization(true);
  interpolator->Update();
  return interpolator->GetOutput();
}

vtkSmartPointer<vtkPolyData> make_body_surface(vtkDataSet* filling, const std::optional<Quarter>& cut_away) {
  auto surface = make_closed_surface(filling);
  if (cut_away) {
    vtkNew<vtkAppendPolyData> parts;
    parts->AddInputData(clip_quarter_away(surface, *cut_away));
    parts->AddInputData(make_cut_face(filling, *cut_away, 0));
    parts->AddInputData(make_cut_face(filling, *cut_away, 1));
    parts->Update();
    surface = parts->GetOutput();
  }
  surface->GetPointData()->SetActiveScalars(colors);
  return surface;
}

}  // namespace anvil
