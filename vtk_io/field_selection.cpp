// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/field_selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "anvil/core/error.hpp"
#include "anvil/figures/ticks.hpp"

namespace anvil {
namespace {

constexpr std::array<const char*, 3> vector_components{"x", "y", "z"};
constexpr std::array<const char*, 6> tensor_components{"xx", "yy", "zz", "xy", "yz", "xz"};

[[noreturn]] void throw_unknown(const Frame& frame, const std::string& name) {
  std::string names;
  for (const FrameArray& array : frame.arrays) {
    names += names.empty() ? array.name : ", " + array.name;
    if (array.components == 3) names += fmt::format(" (also {0}.x, {0}.y, {0}.z)", array.name);
    if (array.components == 6) names += fmt::format(" (by component: {0}.xx to {0}.xz; or von_mises)", array.name);
  }
  throw InputError(fmt::format("the frame has no field '{}'; it has {}", name, names));
}

std::string standard_field(const Frame& frame) {
  for (const std::string name : {"plastic_strain", "pressure", "velocity"})
    if (frame.find(name) != nullptr) return name;
  throw_unknown(frame, "plastic_strain");
}

/// One number per particle from the components of an array.
template <class Reduce>
std::vector<double> reduce(const FrameArray& array, Reduce reduce_one) {
  const auto components = static_cast<std::size_t>(array.components);
  std::vector<double> values(array.values.size() / components);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = reduce_one(&array.values[i * components]);
  return values;
}

/// Von Mises (1913): sqrt(3/2 s:s) of the deviator s, from the components XX YY ZZ XY YZ XZ of the stress.
double von_mises(const double* stress) {
  const double xy = stress[0] - stress[1];
  const double yz = stress[1] - stress[2];
  const double zx = stress[2] - stress[0];
  const double shear = stress[3] * stress[3] + stress[4] * stress[4] + stress[5] * stress[5];
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * shear);
}

int component_index(const FrameArray& array, const std::string& component) {
  for (int c = 0; c < array.components; ++c) {
    const auto i = static_cast<std::size_t>(c);
    if (array.components == 3 && component == vector_components.at(i)) return c;
    if (array.components == 6 && component == tensor_components.at(i)) return c;
  }
  return -1;
}

std::vector<double> values_of(const Frame& frame, const FrameArray& array, const std::string& name) {
  const auto dot = name.find('.');
  if (dot != std::string::npos) {
    const int component = component_index(array, name.substr(dot + 1));
    if (component < 0) throw_unknown(frame, name);
    return reduce(array, [&](const double* tuple) { return tuple[component]; });
  }
  if (array.components == 1) return array.values;
  if (array.components == 3)
    return reduce(array, [](const double* v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); });
  throw_unknown(frame, name);  // a tensor has no single natural size: its component, or von_mises
}

std::string label_of(const std::string& name, const std::string& unit) {
  std::string label = name == "von_mises" ? "von Mises stress" : name;
  std::replace_if(
      label.begin(), label.end(), [](char c) { return c == '_' || c == '.'; }, ' ');
  return unit.empty() ? label : label + "\n[" + unit + "]";
}

}  // namespace

SelectedField select_field(const Frame& frame, const std::string& name) {
  const std::string wanted = name.empty() ? standard_field(frame) : name;
  const bool is_von_mises = wanted == "von_mises" && frame.find("von_mises") == nullptr;
  const FrameArray* array = frame.find(is_von_mises ? "stress" : wanted.substr(0, wanted.find('.')));
  if (array == nullptr) throw_unknown(frame, wanted);

  SelectedField field;
  std::string unit = array->unit;
  if (unit == "Pa" || unit == "m") {
    field.per_si_unit = unit == "Pa" ? 1e-6 : 1e3;
    unit = unit == "Pa" ? "MPa" : "mm";
  }
  field.label = label_of(wanted, unit);
  field.values = is_von_mises ? reduce(*array, von_mises) : values_of(frame, *array, wanted);
  for (double& value : field.values) value *= field.per_si_unit;
  return field;
}

FieldRange range_of(const SelectedField& field, const std::optional<FieldRange>& wanted) {
  if (wanted) {
    if (!(wanted->low < wanted->high))
      throw InputError(fmt::format("the range of colours {} to {} is empty", wanted->low, wanted->high));
    return {wanted->low * field.per_si_unit, wanted->high * field.per_si_unit};
  }
  double least = std::numeric_limits<double>::max();
  double greatest = std::numeric_limits<double>::lowest();
  for (const double value : field.values) {
    if (!std::isfinite(value)) continue;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  const double low = least >= 0.0 ? 0.0 : least;
  const double span = greatest - low;
  if (least > greatest) return {0.0, 1.0};  // not one number
  if (span == 0.0) return low < 0.0 ? FieldRange{low, 0.0} : FieldRange{0.0, 1.0};
  const double step = nice_step(span, 5);
  return {std::floor(low / step) * step, std::ceil(greatest / step - 1e-9) * step};
}

}  // namespace anvil
