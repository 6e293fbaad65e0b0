// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/output/array_names.hpp"

#include <fmt/core.h>

#include "anvil/core/error.hpp"
#include "anvil/core/field_keys.hpp"
#include "anvil/scene/nearest_name.hpp"

namespace anvil {
namespace {

std::string unit_in_anvil(const std::string& name) {
  for (const FieldKey* key :
       {&field::initial_position, &field::velocity, &field::mass, &field::density, &field::smoothing_length,
        &field::pressure, &field::deviatoric_stress, &field::plastic_strain})
    if (name == key->name) return std::string(key->unit);
  if (name == "stress") return "Pa";
  if (name == "specific_energy") return "J/kg";
  return name == "temperature" ? "K" : "";
}

}  // namespace

ArrayNames parse_array_names(const std::vector<std::string>& texts) {
  ArrayNames names;
  for (const auto& text : texts) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
      throw InputError(
          fmt::format("'{}' does not say which array is meant: expected ANVIL=FILE, such as velocity=Vel", text));
    names[text.substr(0, equals)] = text.substr(equals + 1);
  }
  return names;
}

void rename_arrays(Frame& frame, const ArrayNames& names) {
  for (const auto& [ours, theirs] : names) {
    std::vector<std::string_view> known;
    bool found = false;
    for (FrameArray& array : frame.arrays) {
      known.push_back(array.name);
      if (array.name != theirs) continue;
      array.name = ours;
      found = true;
      break;
    }
    if (!found) throw InputError(fmt::format("the file has no array '{}'{}", theirs, suggestion(theirs, known)));
  }
  for (FrameArray& array : frame.arrays)
    if (array.unit.empty()) array.unit = unit_in_anvil(array.name);
}

}  // namespace anvil
