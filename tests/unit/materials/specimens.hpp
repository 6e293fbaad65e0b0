// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "anvil/core/tensor.hpp"
#include "anvil/scene/key.hpp"

namespace anvil::testing_support {

/// Parameters that make sense for any law, from the table of its keys: moduli and sound speed of a metal, other
/// stresses of 200 MPa, pure numbers of 3, fractions of 0.4; the defaults where there are some, unless
/// `replace_defaults`.
inline Parameters specimen(const EntryKind& kind, bool replace_defaults) {
  Parameters parameters;
  for (const Key& key : kind.keys) {
    if (key.standard && !replace_defaults) {
      parameters.set(std::string(key.name), *key.standard);
    } else if (key.kind == ValueKind::choice) {
      parameters.set(std::string(key.name), std::string(key.choices.back()));
    } else if (key.unit == "Pa") {
      const bool elastic_modulus = key.name == "shear_modulus" || key.name == "bulk_modulus";
      parameters.set(std::string(key.name), elastic_modulus ? 50e9 : 200e6);
    } else if (key.unit == "m/s") {
      parameters.set(std::string(key.name), 4000.0);
    } else {
      parameters.set(std::string(key.name), key.range == Range::fraction ? 0.4 : 3.0);
    }
  }
  return parameters;
}

/// A law with its defaults, and one with every key set.
template <class Law>
std::vector<Law> specimens() {
  return {Law(specimen(Law::kind(), false)), Law(specimen(Law::kind(), true))};
}

/// Reproducible random tensors.
class RandomTensors {
 public:
  Tensor tensor(double size) {
    return Tensor::NullaryExpr([&] { return size * uniform_(engine_); });
  }
  Tensor deviator(double size) {
    const Tensor any = tensor(size);
    const Tensor symmetric = 0.5 * (any + any.transpose());
    return symmetric - symmetric.trace() / 3.0 * Tensor::Identity();
  }
  Tensor rotation() {
    return Eigen::Quaterniond(uniform_(engine_), uniform_(engine_), uniform_(engine_), uniform_(engine_))
        .normalized()
        .toRotationMatrix();
  }

 private:
  std::mt19937 engine_{20240229};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

}  // namespace anvil::testing_support
