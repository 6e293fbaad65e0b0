// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/lettering.hpp"

#include <fmt/format.h>
#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkTextActor.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "anvil/figures/text_width.hpp"
#include "anvil/figures/ticks.hpp"
#include "vtk_io/font.hpp"

namespace anvil {
namespace {

constexpr double ink = 0.1;

vtkSmartPointer<vtkActor2D> make_drawing(vtkPolyData* shapes, vtkLookupTable* colors) {
  vtkNew<vtkCoordinate> relative;
  relative->SetCoordinateSystemToNormalizedViewport();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(shapes);
  mapper->SetTransformCoordinate(relative);
  if (colors != nullptr) {
    mapper->SetLookupTable(colors);
    mapper->UseLookupTableScalarRangeOn();
  }
  auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(ink, ink, ink);
  actor->GetProperty()->SetLineWidth(2.0F);
  return actor;
}

/// A stack of quads from one colour to the next. The points carry the colours: not every OpenGL colours cells.
vtkSmartPointer<vtkPolyData> make_color_stack(vtkLookupTable* colors, const std::array<double, 4>& part) {
  const vtkIdType quad_count = colors->GetNumberOfTableValues();
  const double* range = colors->GetTableRange();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  vtkNew<vtkDoubleArray> values;
  for (vtkIdType i = 0; i <= quad_count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(quad_count);
    for (const double x : {part[0], part[2]}) {
      points->InsertNextPoint(x, part[1] + share * (part[3] - part[1]), 0.0);
      values->InsertNextValue(range[0] + share * (range[1] - range[0]));
    }
    if (i < quad_count) quads->InsertNextCell({2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2});
  }
  auto stack = vtkSmartPointer<vtkPolyData>::New();
  stack->SetPoints(points);
  stack->SetPolys(quads);
  stack->GetPointData()->SetScalars(values);
  return stack;
}

/// With line breaks instead of spaces where a line would be wider than `room` pixels.
std::string wrapped(const std::string& text, double room, int height) {
  std::string lines;
  std::string line;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (!line.empty() && text_width(line + " " + word, height) > room) {
      lines += line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
    if (end < text.size() && text[end] == '\n') {
      lines += line + "\n";
      line.clear();
    }
    begin = end + 1;
  }
  return lines + line;
}

void add_line(vtkPolyData& lines, double x0, double y0, double x1, double y1) {
  const vtkIdType a = lines.GetPoints()->InsertNextPoint(x0, y0, 0.0);
  const vtkIdType b = lines.GetPoints()->InsertNextPoint(x1, y1, 0.0);
  lines.GetLines()->InsertNextCell({a, b});
}

void add_bar_label(vtkRenderer* renderer, const std::string& label, const std::array<double, 2>& at, int height) {
  constexpr double share = 0.14;  // of the width of the picture: views leave that free
  const int* size = renderer->GetRenderWindow()->GetSize();
  const std::string lines = wrapped(label, share * size[0], height);
  double widest = 0.0;
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) widest = std::max(widest, text_width(line, height));
  const double fitting = std::min(1.0, share * size[0] / widest);  // a word, or an expression, may be longer
  const auto count = static_cast<double>(1 + std::count(lines.begin(), lines.end(), '\n'));
  const double middle = at[1] + 0.6 * count * height / size[1];
  add_text(renderer, lines, {at[0], middle}, std::max(6, static_cast<int>(fitting * height)), VTK_TEXT_RIGHT);
}

}  // namespace

void set_font(vtkTextProperty* property, int height) {
  property->SetFontFamily(VTK_FONT_FILE);
  property->SetFontFile(font_file().c_str());
  property->SetFontSize(height);
  property->SetColor(ink, ink, ink);
}

void add_text(vtkRenderer* renderer, const std::string& text, const std::array<double, 2>& at, int height,
              int alignment) {
  vtkNew<vtkTextActor> actor;
  actor->SetInput(text.c_str());
  set_font(actor->GetTextProperty(), height);
  actor->GetTextProperty()->SetJustification(alignment);
  actor->GetTextProperty()->SetVerticalJustificationToCentered();
  actor->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  actor->SetPosition(at[0], at[1]);
  renderer->AddActor2D(actor);
}

void add_color_bar(vtkRenderer* renderer, vtkLookupTable* colors, const std::string& label,
                   const std::array<double, 4>& part, int height) {
  const auto [left, bottom, right, top] = part;
  renderer->AddActor2D(make_drawing(make_color_stack(colors, part), colors));

  vtkNew<vtkPolyData> lines;
  lines->SetPoints(vtkSmartPointer<vtkPoints>::New());
  lines->SetLines(vtkSmartPointer<vtkCellArray>::New());
  add_line(*lines, left, bottom, right, bottom);
  add_line(*lines, right, bottom, right, top);
  add_line(*lines, right, top, left, top);
  add_line(*lines, left, top, left, bottom);
  const double low = colors->GetTableRange()[0];
  const double high = colors->GetTableRange()[1];
  const double step = nice_step(high - low, 6);
  const std::string format = tick_format(step, std::max(std::abs(low), std::abs(high)));
  const double tick = 0.25 * (right - left);
  for (const double value : multiples_between(low, high, step)) {
    const double y = bottom + (top - bottom) * (value - low) / (high - low);
    add_line(*lines, right, y, right + tick, y);
    std::array<char, 32> number{};
    std::snprintf(number.data(), number.size(), format.c_str(), value);
    add_text(renderer, number.data(), {right + 2 * tick, y}, height, VTK_TEXT_LEFT);
  }
  renderer->AddActor2D(make_drawing(lines, nullptr));
  add_bar_label(renderer, label, {0.985, top + 0.03}, height);
}

void add_title(vtkRenderer* renderer, const std::string& text, const std::array<double, 2>& at, double width,
               int height) {
  const double room = width * renderer->GetRenderWindow()->GetSize()[0];
  const double needed = text_width(text, height);
  const int fitting = needed > room ? static_cast<int>(height * room / needed) : height;
  add_text(renderer, text, at, std::max(6, fitting), VTK_TEXT_LEFT);
}

void add_legend(vtkRenderer* renderer, vtkLookupTable* colors, const std::vector<std::string>& names,
                const std::array<double, 4>& part, int height) {
  const int* size = renderer->GetRenderWindow()->GetSize();
  const double square = static_cast<double>(height) / size[1];
  const double width = static_cast<double>(height) / size[0];
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double top = part[3] - 1.6 * square * static_cast<double>(i);
    if (top - square < part[1]) break;
    vtkNew<vtkLookupTable> one;
    one->SetNumberOfTableValues(1);
    one->SetTableValue(0, colors->GetTableValue(static_cast<vtkIdType>(i)));
    const double left = part[0] - 0.04;
    renderer->AddActor2D(make_drawing(make_color_stack(one, {left, top - square, left + width, top}), one));
    add_text(renderer, names[i], {left + 1.5 * width, top - 0.5 * square}, height, VTK_TEXT_LEFT);
  }
}

std::string time_text(double seconds) {
  if (std::abs(seconds) < 1e-3) return fmt::format("{:.4g} µs", seconds * 1e6);
  return std::abs(seconds) < 1.0 ? fmt::format("{:.4g} ms", seconds * 1e3) : fmt::format("{:.4g} s", seconds);
}

}  // namespace anvil
