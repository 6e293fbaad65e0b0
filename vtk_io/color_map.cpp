// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/color_map.hpp"

#include <fmt/format.h>
#include <vtkColorTransferFunction.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>

#include "anvil/core/error.hpp"
#include "anvil/figures/color_scale.hpp"
#include "anvil/scene/nearest_name.hpp"

namespace anvil {
namespace {

constexpr int color_count = 512;

struct ColorStop {
  double place, red, green, blue;
};

/// Places run from -1 over zero to 1, or from 0 at the low end to 1 at the high one. Every map is light where nothing
/// happens, so that shading still shows the shape there.
struct ColorMapRow {
  ColorMapName about;
  bool around_zero;
  std::vector<ColorStop> stops;
};

const std::vector<ColorMapRow>& color_maps() {
  static const std::vector<ColorMapRow> maps = {
      {{"strain", "light grey at zero, yellow to dark red above, light to dark blue below"},
       true,
       {{-1.0, 0.05, 0.07, 0.35},
        {-0.65, 0.13, 0.33, 0.75},
        {-0.30, 0.50, 0.75, 0.93},
        {0.0, 0.87, 0.87, 0.87},
        {0.30, 0.98, 0.84, 0.36},
        {0.65, 0.87, 0.25, 0.12},
        {1.0, 0.38, 0.02, 0.06}}},
      {{"cool_warm", "light grey at zero, blue below, red above"},
       true,
       {{-1.0, 0.12, 0.22, 0.62},
        {-0.5, 0.48, 0.62, 0.90},
        {0.0, 0.88, 0.88, 0.88},
        {0.5, 0.93, 0.55, 0.43},
        {1.0, 0.64, 0.03, 0.13}}},
      {{"water", "pale to deep blue from the low to the high end"},
       false,
       {{0.0, 0.83, 0.91, 0.96}, {0.35, 0.52, 0.75, 0.88}, {0.7, 0.16, 0.47, 0.74}, {1.0, 0.03, 0.17, 0.40}}},
      {{"earth", "sand to dark brown from the low to the high end"},
       false,
       {{0.0, 0.92, 0.87, 0.74}, {0.35, 0.84, 0.66, 0.40}, {0.7, 0.62, 0.33, 0.13}, {1.0, 0.26, 0.11, 0.05}}},
      {{"viridis", "yellow-green at the low end over green to dark violet at the high one"},
       false,
       {{0.0, 0.99, 0.91, 0.55},
        {0.25, 0.48, 0.82, 0.32},
        {0.5, 0.13, 0.57, 0.55},
        {0.75, 0.23, 0.32, 0.55},
        {1.0, 0.27, 0.00, 0.33}}},
      {{"grey", "light to dark grey from the low to the high end"},
       false,
       {{0.0, 0.92, 0.92, 0.92}, {1.0, 0.15, 0.15, 0.15}}},
  };
  return maps;
}

const ColorMapRow& find_map(const std::string& name) {
  if (name.empty()) return color_maps().front();
  std::vector<std::string_view> names;
  for (const auto& map : color_maps()) {
    if (map.about.name == name) return map;
    names.push_back(map.about.name);
  }
  throw InputError(fmt::format("there is no colour map '{}'{}", name, suggestion(name, names)));
}

}  // namespace

std::vector<ColorMapName> color_map_names() {
  std::vector<ColorMapName> names;
  for (const auto& map : color_maps()) names.push_back(map.about);
  return names;
}

vtkSmartPointer<vtkLookupTable> make_color_map(const std::string& name, const FieldRange& range) {
  const ColorMapRow& map = find_map(name);
  vtkNew<vtkColorTransferFunction> scale;
  scale->SetColorSpaceToLab();
  for (const ColorStop& stop : map.stops) scale->AddRGBPoint(stop.place, stop.red, stop.green, stop.blue);
  const bool has_zero = map.around_zero && range.low <= 0.0 && range.high >= 0.0;
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

vtkSmartPointer<vtkLookupTable> make_categories(int count) {
  auto colors = vtkSmartPointer<vtkLookupTable>::New();
  colors->SetNumberOfTableValues(count);
  colors->SetTableRange(-0.5, count - 0.5);
  for (int i = 0; i < count; ++i) {
    const Color color = curve_color(static_cast<std::size_t>(i));
    colors->SetTableValue(i, color.red / 255.0, color.green / 255.0, color.blue / 255.0, 1.0);
  }
  return colors;
}

}  // namespace anvil
