// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/core/fields.hpp"

#include <stdexcept>
#include <string>

namespace anvil {

void FieldStore::require(const FieldKey& key, int components) {
  if (has(key)) {
    (void)at(key, components);
    return;
  }
  fields_.push_back({&key, components, std::vector<double>(particles_ * static_cast<std::size_t>(components), 0.0)});
}

const FieldStore::Field* FieldStore::find(const FieldKey& key) const {
  for (const auto& field : fields_)
    if (field.key->name == key.name) return &field;
  return nullptr;
}

const FieldStore::Field& FieldStore::at(const FieldKey& key, int components) const {
  const Field* field = find(key);
  if (field == nullptr) throw std::logic_error("field '" + std::string(key.name) + "' was never required");
  if (field->components != components)
    throw std::logic_error("field '" + std::string(key.name) + "' has " + std::to_string(field->components) +
                           " components, not " + std::to_string(components));
  return *field;
}

}  // namespace anvil
