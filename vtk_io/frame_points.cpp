// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/frame_points.hpp"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkLongLongArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <map>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

constexpr std::array<const char*, 3> vector_components{"X", "Y", "Z"};
constexpr std::array<const char*, 6> tensor_components{"XX", "YY", "ZZ", "XY", "YZ", "XZ"};

template <class Array>
vtkSmartPointer<vtkDataArray> make_array(const std::vector<double>& values, int components) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  using Number = typename Array::ValueType;
  std::transform(values.begin(), values.end(), array->GetPointer(0),
                 [](double value) { return static_cast<Number>(value); });
  return array;
}

vtkSmartPointer<vtkDataArray> make_point_array(const FrameArray& source, bool double_precision) {
  vtkSmartPointer<vtkDataArray> array = source.integer ? make_array<vtkIntArray>(source.values, source.components)
                                        : double_precision
                                            ? make_array<vtkDoubleArray>(source.values, source.components)
                                            : make_array<vtkFloatArray>(source.values, source.components);
  array->SetName(source.name.c_str());
  for (int c = 0; c < source.components; ++c) {
    if (source.components == 3) array->SetComponentName(c, vector_components.at(static_cast<std::size_t>(c)));
    if (source.components == 6) array->SetComponentName(c, tensor_components.at(static_cast<std::size_t>(c)));
  }
  return array;
}

template <class Array, class Number>
void add_number(vtkFieldData& fields, const char* name, Number number) {
  vtkNew<Array> array;
  array->SetName(name);
  array->InsertNextValue(number);
  fields.AddArray(array);
}

void add_text(vtkFieldData& fields, const std::string& name, const std::string& text) {
  vtkNew<vtkStringArray> array;
  array->SetName(name.c_str());
  array->InsertNextValue(text);
  fields.AddArray(array);
}

void add_field_data(const Frame& frame, vtkFieldData& fields) {
  add_number<vtkDoubleArray>(fields, "TimeValue", frame.time);
  add_number<vtkIntArray>(fields, "frame_index", frame.index);
  add_number<vtkLongLongArray>(fields, "step", frame.step);
  add_number<vtkIntArray>(fields, "dimension", frame.dimension);
  add_text(fields, "scene", frame.scene);
  vtkNew<vtkStringArray> units;
  units->SetName("units");
  for (const FrameArray& array : frame.arrays) units->InsertNextValue(array.name + ": " + array.unit);
  fields.AddArray(units);
  for (const auto& [name, text] : frame.provenance) add_text(fields, name, text);
}

void fill_points(const Frame& frame, bool double_precision, vtkPointSet& target) {
  vtkNew<vtkPoints> points;
  points->SetDataType(double_precision ? VTK_DOUBLE : VTK_FLOAT);
  const FrameArray positions{"Points", "m", 3, false, frame.positions};
  points->SetData(make_point_array(positions, double_precision));
  target.SetPoints(points);
  for (const FrameArray& array : frame.arrays) {
    if (array.values.size() != frame.particle_count() * static_cast<std::size_t>(array.components))
      throw std::logic_error("array '" + array.name + "' does not have one tuple per particle");
    target.GetPointData()->AddArray(make_point_array(array, double_precision));
  }
  add_field_data(frame, *target.GetFieldData());
}

/// One vertex cell per particle: without cells many of ParaView's filters drop the points.
vtkSmartPointer<vtkCellArray> make_vertices(std::size_t count) {
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->AllocateExact(static_cast<vtkIdType>(count), static_cast<vtkIdType>(count));
  for (vtkIdType point = 0; point < static_cast<vtkIdType>(count); ++point) cells->InsertNextCell(1, &point);
  return cells;
}

double number_of(vtkFieldData& fields, const char* name, const std::string& source) {
  vtkDataArray* array = fields.GetArray(name);
  if (array == nullptr || array->GetNumberOfTuples() != 1)
    throw InputError("'" + source + "' has no field data '" + name + "': it is not a particle file written by Anvil");
  return array->GetTuple1(0);
}

std::map<std::string, std::string> units_of(vtkFieldData& fields) {
  std::map<std::string, std::string> units;
  if (auto* lines = vtkStringArray::SafeDownCast(fields.GetAbstractArray("units")); lines != nullptr) {
    for (vtkIdType i = 0; i < lines->GetNumberOfValues(); ++i) {
      const std::string& line = lines->GetValue(i);
      if (const auto colon = line.find(": "); colon != std::string::npos)
        units[line.substr(0, colon)] = line.substr(colon + 2);
    }
  }
  return units;
}

void read_texts(vtkFieldData& fields, Frame& frame) {
  for (int i = 0; i < fields.GetNumberOfArrays(); ++i) {
    auto* texts = vtkStringArray::SafeDownCast(fields.GetAbstractArray(i));
    if (texts == nullptr || texts->GetName() == nullptr || texts->GetNumberOfValues() != 1) continue;
    const std::string name = texts->GetName();
    if (name == "scene")
      frame.scene = texts->GetValue(0);
    else if (name != "units")
      frame.provenance.emplace_back(name, texts->GetValue(0));
  }
}

std::vector<double> values_of(vtkDataArray& array) {
  const int components = array.GetNumberOfComponents();
  std::vector<double> values(static_cast<std::size_t>(array.GetNumberOfValues()));
  for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i) array.GetTuple(i, values.data() + i * components);
  return values;
}

}  // namespace

vtkSmartPointer<vtkPolyData> make_poly_data(const Frame& frame, bool double_precision) {
  auto poly_data = vtkSmartPointer<vtkPolyData>::New();
  fill_points(frame, double_precision, *poly_data);
  poly_data->SetVerts(make_vertices(frame.particle_count()));
  return poly_data;
}

vtkSmartPointer<vtkUnstructuredGrid> make_unstructured_grid(const Frame& frame, bool double_precision) {
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  fill_points(frame, double_precision, *grid);
  grid->SetCells(VTK_VERTEX, make_vertices(frame.particle_count()));
  return grid;
}

Frame make_frame(vtkPointSet& points, const std::string& source) {
  if (points.GetNumberOfPoints() == 0) throw InputError("'" + source + "' holds no particles");
  vtkFieldData& fields = *points.GetFieldData();
  Frame frame;
  frame.time = number_of(fields, "TimeValue", source);
  frame.index = static_cast<int>(number_of(fields, "frame_index", source));
  frame.step = static_cast<std::int64_t>(number_of(fields, "step", source));
  frame.dimension = static_cast<int>(number_of(fields, "dimension", source));
  read_texts(fields, frame);
  frame.positions = values_of(*points.GetPoints()->GetData());
  const auto units = units_of(fields);
  for (int i = 0; i < points.GetPointData()->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = points.GetPointData()->GetArray(i);
    if (array == nullptr || array->GetName() == nullptr) continue;
    const auto unit = units.find(array->GetName());
    frame.arrays.push_back({array->GetName(), unit == units.end() ? "" : unit->second, array->GetNumberOfComponents(),
                            array->GetDataType() == VTK_INT, values_of(*array)});
    if (frame.arrays.back().values.size() !=
        frame.particle_count() * static_cast<std::size_t>(frame.arrays.back().components))
      throw InputError("array '" + frame.arrays.back().name + "' of '" + source + "' is incomplete");
  }
  return frame;
}

}  // namespace anvil
