// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/materials/strength/strength_law.hpp"

namespace anvil {

/// Linear elastic shear without yield.
class Elastic {
 public:
  static EntryKind kind() {
    return {.type = "elastic",
            .summary = "linear elastic shear, no yield",
            .keys = {{.name = "shear_modulus", .unit = "Pa", .range = Range::positive, .help = "G"}}};
  }
  static constexpr bool resists_shear = true;
  static constexpr bool has_plastic_strain = false;

  explicit Elastic(const Parameters& parameters) : shear_modulus_(parameters.number("shear_modulus")) {}

  bool has_back_stress() const { return false; }
  double shear_modulus() const { return shear_modulus_; }

  ANVIL_INLINE PlasticStep return_to_yield(Tensor& /*trial_deviator*/, StrengthHistory& /*history*/) const {
    return {};
  }

 private:
  double shear_modulus_;  // Pa
};

}  // namespace anvil
