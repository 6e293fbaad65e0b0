// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/field_selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "anvil/core/error.hpp"
#include "anvil/figures/ticks.hpp"
#include "anvil/figures/unit.hpp"
#include "anvil/measures/frame_fields.hpp"

namespace anvil {
namespace {

/// What a result of a solid has, else of a fluid; the first array of anything else.
std::string standard_field(const Frame& frame) {
  for (const std::string name : {"plastic_strain", "pressure", "velocity"})
    if (frame.find(name) != nullptr) return name;
  for (const FrameArray& array : frame.arrays)
    if (array.components == 1 || array.components == 3) return array.name;
  return "position";
}

/// "Velocity z", "Von Mises stress"; an expression stays as it is.
std::string label_of(const std::string& name, const Unit& unit) {
  std::string label = name == "von_mises" || name == "stress.von_mises" ? "Von Mises stress" : name;
  if (name.find_first_of("+-*/(^ ") == std::string::npos) {
    std::replace_if(
        label.begin(), label.end(), [](char c) { return c == '_' || c == '.'; }, ' ');
    label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
  }
  const std::string bracket = with_unit("", unit);
  return bracket.empty() ? label : label + "\n" + bracket;
}

double largest_of(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace

SelectedField select_field(const Frame& frame, const std::string& name, const std::optional<FieldRange>& shown) {
  const std::string wanted = name.empty() ? standard_field(frame) : name;
  Evaluated found = field_of(frame, wanted);
  const double largest = shown ? std::max(std::abs(shown->low), std::abs(shown->high)) : largest_of(found.values);
  const Unit unit = readable_unit(found.unit, largest);
  SelectedField field;
  field.per_si_unit = 1.0 / unit.factor;
  field.label = label_of(wanted, unit);
  field.values = std::move(found.values);
  for (double& value : field.values) value *= field.per_si_unit;
  return field;
}

std::optional<FieldRange> extremes_of(const SelectedField& field) {
  double least = std::numeric_limits<double>::max();
  double greatest = std::numeric_limits<double>::lowest();
  for (const double value : field.values) {
    if (!std::isfinite(value)) continue;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  if (least > greatest) return std::nullopt;
  return FieldRange{least / field.per_si_unit, greatest / field.per_si_unit};
}

FieldRange range_of(const SelectedField& field, const std::optional<FieldRange>& wanted,
                    const std::optional<FieldRange>& extremes) {
  if (wanted) {
    if (!(wanted->low < wanted->high))
      throw InputError(fmt::format("the range of colours {} to {} is empty", wanted->low, wanted->high));
    return {wanted->low * field.per_si_unit, wanted->high * field.per_si_unit};
  }
  if (!extremes) return {0.0, 1.0};  // not one number
  const double least = extremes->low * field.per_si_unit;
  const double greatest = extremes->high * field.per_si_unit;
  // A field far from zero, such as a density, would be one colour on a bar from zero on.
  constexpr double far_from_zero = 0.5;
  const bool near_zero = least < far_from_zero * greatest;
  const double low = least >= 0.0 && near_zero ? 0.0 : least;
  const double span = greatest - low;
  if (!(span > 1e-9 * std::abs(greatest)))
    return low < 0.0 ? FieldRange{low, 0.0} : FieldRange{0.0, low > 0.0 ? low : 1.0};
  const double step = nice_step(span, 5);
  return {std::floor(low / step + 1e-9) * step, std::ceil(greatest / step - 1e-9) * step};
}

}  // namespace anvil
