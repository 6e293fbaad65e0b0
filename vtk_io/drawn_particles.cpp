// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/drawn_particles.hpp"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "anvil/core/error.hpp"
#include "anvil/measures/particle_interpolation.hpp"

namespace anvil {
namespace {

constexpr double millimetres = 1e3;
constexpr const char* initial_position = "initial_position";

vtkSmartPointer<vtkDoubleArray> make_lengths(const std::vector<double>& metres) {
  auto lengths = vtkSmartPointer<vtkDoubleArray>::New();
  lengths->SetNumberOfComponents(3);
  lengths->SetNumberOfTuples(static_cast<vtkIdType>(metres.size() / 3));
  std::transform(metres.begin(), metres.end(), lengths->GetPointer(0), [](double x) { return x * millimetres; });
  return lengths;
}

void add_vertices(vtkPolyData& points) {
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < points.GetNumberOfPoints(); ++i) vertices->InsertNextCell(1, &i);
  points.SetVerts(vertices);
}

/// Boxes around the initial positions of each body, whose faces are `beyond` the outermost of them.
std::vector<vtkBoundingBox> undeformed_boxes(const Frame& frame, vtkDataArray* initial, double beyond) {
  const FrameArray* bodies = frame.find("body");
  std::map<int, vtkBoundingBox> boxes;
  for (vtkIdType i = 0; i < initial->GetNumberOfTuples(); ++i) {
    const int body = bodies == nullptr ? 0 : static_cast<int>(bodies->values[static_cast<std::size_t>(i)]);
    boxes[body].AddPoint(initial->GetTuple3(i));
  }
  std::vector<vtkBoundingBox> inflated;
  for (auto& [body, box] : boxes) {
    box.Inflate(beyond);
    inflated.push_back(box);
  }
  return inflated;
}

/// In mm3; none where the frame has no masses.
std::vector<double> volumes_of(const Frame& frame) {
  const FrameArray* mass = frame.find("mass");
  const FrameArray* density = frame.find("density");
  if (mass == nullptr || density == nullptr) return {};
  std::vector<double> volumes;
  for (std::size_t i = 0; i < frame.particle_count(); ++i)
    volumes.push_back(std::pow(millimetres, 3.0) * mass->values[i] / density->values[i]);
  return volumes;
}

}  // namespace

vtkBoundingBox drawn_box(const std::array<double, 6>& box) {
  std::array<double, 6> drawn{};
  std::transform(box.begin(), box.end(), drawn.begin(), [](double x) { return x * millimetres; });
  return vtkBoundingBox(drawn.data());
}

vtkSmartPointer<vtkPolyData> make_points(const std::vector<double>& positions) {
  auto drawn = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetData(make_lengths(positions));
  drawn->SetPoints(points);
  add_vertices(*drawn);
  return drawn;
}

DrawnParticles make_drawn_particles(const Frame& frame, const std::vector<double>& colored_by, bool on_faces) {
  if (!std::all_of(frame.positions.begin(), frame.positions.end(), [](double x) { return std::isfinite(x); }))
    throw InputError("the frame holds positions that are not numbers: the run went wrong before it");
  DrawnParticles particles;
  particles.points = make_points(frame.positions);

  vtkNew<vtkDoubleArray> colors;
  colors->SetName("colored_by");
  colors->SetNumberOfTuples(static_cast<vtkIdType>(colored_by.size()));
  std::copy(colored_by.begin(), colored_by.end(), colors->GetPointer(0));
  particles.points->GetPointData()->SetScalars(colors);

  const FrameArray* initial = frame.find(initial_position);
  const auto reference = make_lengths(initial == nullptr ? frame.positions : initial->values);
  reference->SetName(initial_position);
  particles.points->GetPointData()->AddArray(reference);
  const double spacing = usual_spacing(initial == nullptr ? frame.positions : initial->values, frame.dimension);
  particles.spacing = spacing > 0.0 ? millimetres * spacing : 1.0;
  if (initial != nullptr)
    particles.undeformed = undeformed_boxes(frame, reference, on_faces ? 0.0 : particles.spacing / 2);
  particles.volumes = volumes_of(frame);
  return particles;
}

DrawnParticles without_quarter(const DrawnParticles& particles, const Quarter& quarter) {
  vtkPointData& arrays = *particles.points->GetPointData();
  vtkDataArray* reference = arrays.GetArray(initial_position);
  DrawnParticles rest = particles;
  rest.points = vtkSmartPointer<vtkPolyData>::New();
  rest.points->GetPointData()->CopyAllocate(&arrays);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < particles.points->GetNumberOfPoints(); ++i) {
    if (quarter.contains(reference->GetTuple3(i))) continue;
    rest.points->GetPointData()->CopyData(&arrays, i, points->InsertNextPoint(particles.points->GetPoint(i)));
  }
  rest.points->SetPoints(points);
  add_vertices(*rest.points);
  return rest;
}

}  // namespace anvil
