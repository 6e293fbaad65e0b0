// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/color_map.hpp"

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>

namespace anvil {
namespace {

constexpr int color_count = 512;

/// Colours by the distance from zero, in shares of the largest one.
vtkSmartPointer<vtkColorTransferFunction> make_scale() {
  auto scale = vtkSmartPointer<vtkColorTransferFunction>::New();
  scale->SetColorSpaceToLab();
  scale->AddRGBPoint(-1.0, 0.05, 0.07, 0.35);
  scale->AddRGBPoint(-0.65, 0.13, 0.33, 0.75);
  scale->AddRGBPoint(-0.30, 0.50, 0.75, 0.93);
  scale->AddRGBPoint(0.0, 0.87, 0.87, 0.87);
  scale->AddRGBPoint(0.30, 0.98, 0.84, 0.36);
  scale->AddRGBPoint(0.65, 0.87, 0.25, 0.12);
  scale->AddRGBPoint(1.0, 0.38, 0.02, 0.06);
  return scale;
}

}  // namespace

vtkSmartPointer<vtkLookupTable> make_color_map(const FieldRange& range) {
  const auto scale = make_scale();
  const bool has_zero = range.low <= 0.0 && range.high >= 0.0;
  const double zero = has_zero ? 0.0 : range.low;
  const double largest = std::max(std::abs(range.low - zero), std::abs(range.high - zero));
  auto colors = vtkSmartPointer<vtkLookupTable>::New();
  colors->SetNumberOfTableValues(color_count);
  colors->SetTableRange(range.low, range.high);
  for (int i = 0; i < color_count; ++i) {
    const double value = range.low + (range.high - range.low) * i / (color_count - 1);
    double color[3];
    scale->GetColor((value - zero) / largest, color);
    colors->SetTableValue(i, color[0], color[1], color[2], 1.0);
  }
  return colors;
}

}  // namespace anvil
