// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/materials/strength/strength_law.hpp"

namespace anvil {

/// A fluid: no deviatoric stress at all.
class NoStrength {
 public:
  static EntryKind kind() { return {.type = "none", .summary = "fluid without deviatoric stress", .keys = {}}; }
  static constexpr bool resists_shear = false;
  static constexpr bool has_plastic_strain = false;

  NoStrength() = default;
  explicit NoStrength(const Parameters& /*parameters*/) {}

  bool has_back_stress() const { return false; }
  double shear_modulus() const { return 0.0; }

  ANVIL_INLINE PlasticStep return_to_yield(Tensor& trial_deviator, StrengthHistory& /*history*/) const {
    trial_deviator.setZero();
    return {};
  }
};

}  // namespace anvil
