// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "anvil/output/frame.hpp"
#include "vtk_io/render.hpp"

namespace anvil {

/// One number per particle to colour by, in a unit fit for reading.
struct SelectedField {
  std::string label;  // "Von Mises stress", and "[MPa]" on a second line
  std::vector<double> values;
  double per_si_unit = 1.0;  // 1e-6 for MPa
};

/// The field that RenderOptions::field names. Throws InputError, with the names there are, when the frame has no such
/// field. The unit suits the range that is `shown` (SI), or the values of the frame.
SelectedField select_field(const Frame& frame, const std::string& name,
                           const std::optional<FieldRange>& shown = std::nullopt);

/// Least and greatest finite value, SI; absent when there is none.
std::optional<FieldRange> extremes_of(const SelectedField& field);

/// Ends of the colour bar in the unit of the field: `wanted` or, without it, `extremes` rounded outward to a nice step
/// (both SI). Throws InputError when `wanted` is empty.
FieldRange range_of(const SelectedField& field, const std::optional<FieldRange>& wanted,
                    const std::optional<FieldRange>& extremes);

}  // namespace anvil
