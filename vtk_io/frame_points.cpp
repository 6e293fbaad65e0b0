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
#include <optional>
#include <utility>

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
  add_arrays(frame, double_precision, target);
}

/// One vertex cell per particle: without cells many of ParaView's filters drop the points.
vtkSmartPointer<vtkCellArray> make_vertices(std::size_t count) {
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->AllocateExact(static_cast<vtkIdType>(count), static_cast<vtkIdType>(count));
  for (vtkIdType point = 0; point < static_cast<vtkIdType>(count); ++point) cells->InsertNextCell(1, &point);
  return cells;
}

/// Absent when the file is not one of Anvil's, or is damaged.
std::optional<double> number_of(vtkFieldData& fields, const char* name) {
  vtkDataArray* array = fields.GetArray(name);
  if (array == nullptr || array->GetNumberOfTuples() != 1) return std::nullopt;
  return array->GetTuple1(0);
}

/// Without a word on it: the directions in which the points differ.
int dimension_of(vtkPointSet& points) {
  double bounds[6];
  points.GetBounds(bounds);
  if (bounds[4] != bounds[5]) return 3;
  return bounds[2] != bounds[3] ? 2 : 1;
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

bool is_whole(vtkDataArray& array) { return array.GetDataType() != VTK_FLOAT && array.GetDataType() != VTK_DOUBLE; }

/// Vectors of two components get a third, full tensors become their symmetric part: what other programs write.
void adopt_components(FrameArray& array) {
  if (array.components != 2 && array.components != 9) return;
  const auto before = static_cast<std::size_t>(array.components);
  const std::size_t count = array.values.size() / before;
  array.components = before == 2 ? 3 : 6;
  std::vector<double> values;
  values.reserve(count * static_cast<std::size_t>(array.components));
  for (std::size_t i = 0; i < count; ++i) {
    const double* t = &array.values[before * i];
    if (before == 2)
      values.insert(values.end(), {t[0], t[1], 0.0});
    else
      values.insert(values.end(), {t[0], t[4], t[8], 0.5 * (t[1] + t[3]), 0.5 * (t[5] + t[7]), 0.5 * (t[2] + t[6])});
  }
  array.values = std::move(values);
}

}  // namespace

void add_arrays(const Frame& frame, bool double_precision, vtkDataSet& target) {
  for (const FrameArray& array : frame.arrays) {
    if (array.values.size() != frame.particle_count() * static_cast<std::size_t>(array.components))
      throw std::logic_error("array '" + array.name + "' does not have one tuple per particle");
    target.GetPointData()->AddArray(make_point_array(array, double_precision));
  }
  add_field_data(frame, *target.GetFieldData());
}

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
  frame.time = number_of(fields, "TimeValue").value_or(0.0);
  frame.index = static_cast<int>(number_of(fields, "frame_index").value_or(0.0));
  frame.step = static_cast<std::int64_t>(number_of(fields, "step").value_or(0.0));
  frame.dimension = static_cast<int>(number_of(fields, "dimension").value_or(dimension_of(points)));
  read_texts(fields, frame);
  frame.positions = values_of(*points.GetPoints()->GetData());
  const auto units = units_of(fields);
  for (int i = 0; i < points.GetPointData()->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = points.GetPointData()->GetArray(i);
    if (array == nullptr || array->GetName() == nullptr) continue;
    const auto unit = units.find(array->GetName());
    frame.arrays.push_back({array->GetName(), unit == units.end() ? "" : unit->second, array->GetNumberOfComponents(),
                            is_whole(*array), values_of(*array)});
    FrameArray& read = frame.arrays.back();
    adopt_components(read);
    if (read.values.size() != frame.particle_count() * static_cast<std::size_t>(read.components))
      throw InputError("array '" + read.name + "' of '" + source + "' is incomplete");
  }
  return frame;
}

}  // namespace anvil
