// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/sample_file.hpp"

#include <vtkCellArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include "anvil/core/error.hpp"
#include "vtk_io/frame_points.hpp"
#include "vtk_io/xml_file.hpp"

namespace anvil {
namespace {

vtkSmartPointer<vtkPolyData> make_cells(const Frame& sampled, const SampleGrid& grid) {
  auto poly_data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t i = 0; i < sampled.positions.size(); i += 3) points->InsertNextPoint(&sampled.positions[i]);
  poly_data->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  const vtkIdType row = grid.nodes[0];
  if (grid.is_line()) {
    cells->InsertNextCell(grid.nodes[0]);
    for (vtkIdType i = 0; i < row; ++i) cells->InsertCellPoint(i);
    poly_data->SetLines(cells);
  } else {
    for (vtkIdType j = 0; j + 1 < grid.nodes[1]; ++j)
      for (vtkIdType i = 0; i + 1 < row; ++i) {
        const vtkIdType first = j * row + i;
        cells->InsertNextCell({first, first + 1, first + row + 1, first + row});
      }
    poly_data->SetPolys(cells);
  }
  return poly_data;
}

vtkSmartPointer<vtkImageData> make_image(const SampleGrid& grid) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(grid.nodes[0], grid.nodes[1], 1);
  image->SetOrigin(grid.origin.data());
  image->SetSpacing(grid.step[0], grid.step[1], 1.0);
  Point w{};
  vtkMath::Cross(grid.u.data(), grid.v.data(), w.data());
  // Its columns are the directions of the image in space.
  image->SetDirectionMatrix(grid.u[0], grid.v[0], w[0], grid.u[1], grid.v[1], w[1], grid.u[2], grid.v[2], w[2]);
  return image;
}

}  // namespace

void write_sample_file(const Frame& sampled, const SampleGrid& grid, const std::filesystem::path& file) {
  constexpr bool double_precision = true;
  constexpr const char* compression = "lz4";
  if (file.extension() == ".vtp") {
    const auto cells = make_cells(sampled, grid);
    add_arrays(sampled, double_precision, *cells);
    write_xml<vtkXMLPolyDataWriter>(*cells, compression, file);
  } else if (file.extension() == ".vti") {
    const auto image = make_image(grid);
    add_arrays(sampled, double_precision, *image);
    write_xml<vtkXMLImageDataWriter>(*image, compression, file);
  } else {
    throw InputError("'" + file.string() + "' is none of .csv, .vtp and .vti");
  }
}

}  // namespace anvil
