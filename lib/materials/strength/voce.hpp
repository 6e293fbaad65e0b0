// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "anvil/materials/strength/strength_law.hpp"

namespace anvil {

/// Von Mises plasticity with isotropic hardening that saturates (Voce 1948):
/// sigma_y = sigma_0 + S (1 - exp(-c eps_p)).
class Voce {
 public:
  static EntryKind kind() {
    return {
        .type = "voce",
        .summary = "von Mises yield with hardening that saturates",
        .keys = {{.name = "shear_modulus", .unit = "Pa", .range = Range::positive, .help = "G"},
                 {.name = "yield_stress", .unit = "Pa", .range = Range::not_negative, .help = "sigma_0, in tension"},
                 {.name = "saturation_stress",
                  .unit = "Pa",
                  .range = Range::not_negative,
                  .help = "S, what hardening adds in the end"},
                 {.name = "saturation_rate",
                  .range = Range::not_negative,
                  .help = "c, the inverse of the plastic strain that brings 63 % of S"}}};
  }
  static constexpr bool resists_shear = true;
  static constexpr bool has_plastic_strain = true;

  explicit Voce(const Parameters& parameters)
      : shear_modulus_(parameters.number("shear_modulus")),
        yield_stress_(parameters.number("yield_stress")),
        saturation_stress_(parameters.number("saturation_stress")),
        saturation_rate_(parameters.number("saturation_rate")) {}

  bool has_back_stress() const { return false; }
  double shear_modulus() const { return shear_modulus_; }

  /// In Pa, at this plastic strain.
  ANVIL_INLINE double yield_stress(double plastic_strain) const {
    return yield_stress_ + saturation_stress_ * (1.0 - std::exp(-saturation_rate_ * plastic_strain));
  }

  ANVIL_INLINE PlasticStep return_to_yield(Tensor& trial_deviator, StrengthHistory& history) const {
    const double flow_stress = yield_stress(history.plastic_strain);
    const double q_squared = equivalent_stress_squared(trial_deviator);
    if (q_squared <= flow_stress * flow_stress) return {};
    const double q = std::sqrt(q_squared);
    const double increment = plastic_strain_increment(q, history.plastic_strain);
    const double final_stress = yield_stress(history.plastic_strain + increment);
    trial_deviator *= final_stress / q;
    const double work = 0.5 * (flow_stress + final_stress) * increment;
    history.plastic_strain += increment;
    history.plastic_work += work;
    return {increment, work};
  }

 private:
  /// The root d of q - 3 G d - sigma_y(eps_p + d). The function falls and is convex, so Newton's iterates rise from
  /// zero to the root without passing it; at most 1 / c each while the exponential rules, hence the limit.
  double plastic_strain_increment(double q, double plastic_strain) const {
    double increment = 0.0;
    for (int iteration = 0; iteration < 60; ++iteration) {
      const double to_saturation = saturation_stress_ * std::exp(-saturation_rate_ * (plastic_strain + increment));
      const double excess = q - 3.0 * shear_modulus_ * increment - (yield_stress_ + saturation_stress_ - to_saturation);
      const double correction = excess / (3.0 * shear_modulus_ + saturation_rate_ * to_saturation);
      increment += correction;
      if (std::abs(correction) <= 1e-15 * increment) break;
    }
    return increment;
  }

  double shear_modulus_;      // Pa
  double yield_stress_;       // Pa
  double saturation_stress_;  // Pa
  double saturation_rate_;    // 1
};

}  // namespace anvil
