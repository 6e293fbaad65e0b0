// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "anvil/core/tensor.hpp"

namespace anvil {

/// What a field is: one key per quantity, listed in field_keys.hpp.
struct FieldKey {
  std::string_view name;
  std::string_view unit;  // SI, "" for pure numbers
  std::string_view purpose;
};

/// A field of C components per particle, particle by particle: `view[i]` is an Eigen vector on the memory.
template <int C>
class VectorView {
 public:
  explicit VectorView(double* first) : first_(first) {}
  Eigen::Map<Vec<C>> operator[](std::size_t i) const { return Eigen::Map<Vec<C>>(first_ + i * C); }
  [[nodiscard]] double* raw() const { return first_; }

 private:
  double* first_;
};

/// The particles' fields. A field exists from the moment somebody requires it: a scene carries only what its terms
/// name.
class FieldStore {
 public:
  struct Field {
    const FieldKey* key;
    int components;
    std::vector<double> values;  // components x particles, particle by particle
  };

  explicit FieldStore(std::size_t particles) : particles_(particles) {}
  [[nodiscard]] std::size_t particle_count() const { return particles_; }

  /// Allocates the field, zero everywhere, if it is not there yet. Throws std::logic_error when it is there with
  /// another number of components.
  void require(const FieldKey& key, int components = 1);
  [[nodiscard]] bool has(const FieldKey& key) const { return find(key) != nullptr; }

  /// Throw std::logic_error when nobody required the field. Views stay valid as long as the store.
  [[nodiscard]] std::span<double> scalar(const FieldKey& key) { return at(key, 1).values; }
  [[nodiscard]] std::span<const double> scalar(const FieldKey& key) const { return at(key, 1).values; }
  template <int C>
  [[nodiscard]] VectorView<C> vector(const FieldKey& key) {
    return VectorView<C>(at(key, C).values.data());
  }

  [[nodiscard]] const std::vector<Field>& fields() const { return fields_; }
  [[nodiscard]] std::vector<Field>& fields() { return fields_; }

 private:
  [[nodiscard]] const Field* find(const FieldKey& key) const;
  [[nodiscard]] const Field& at(const FieldKey& key, int components) const;
  [[nodiscard]] Field& at(const FieldKey& key, int components) {
    return const_cast<Field&>(static_cast<const FieldStore*>(this)->at(key, components));
  }

  std::size_t particles_;
  std::vector<Field> fields_;
};

}  // namespace anvil
