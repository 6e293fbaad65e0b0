// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "anvil/materials/strength/strength_law.hpp"

namespace anvil {

/// Von Mises plasticity with linear mixed hardening, by radial return (Long 2007; Simo and Hughes 1998, box 3.1).
/// With the relative stress xi = s - a and its equivalent stress q, the yield stress is sigma_0 + beta Ep eps_p and
///   d_eps_p = (q - sigma_y) / (3 G + Ep),  s -= 3 G d_eps_p xi / q,  a += (1 - beta) Ep d_eps_p xi / q.
class J2 {
 public:
  static EntryKind kind() {
    return {
        .type = "j2",
        .summary = "von Mises yield with linear mixed hardening",
        .keys = {{.name = "shear_modulus", .unit = "Pa", .range = Range::positive, .help = "G"},
                 {.name = "yield_stress", .unit = "Pa", .range = Range::not_negative, .help = "sigma_0, in tension"},
                 {.name = "hardening_modulus",
                  .unit = "Pa",
                  .standard = 0.0,
                  .range = Range::not_negative,
                  .help = "Ep = d sigma_y / d eps_p; from a tangent modulus Et: E Et / (E - Et)"},
                 {.name = "isotropic_fraction",
                  .standard = 1.0,
                  .range = Range::fraction,
                  .help = "beta, the part of the hardening that widens the yield surface; the rest moves it"}}};
  }
  static constexpr bool resists_shear = true;
  static constexpr bool has_plastic_strain = true;

  explicit J2(const Parameters& parameters)
      : shear_modulus_(parameters.number("shear_modulus")),
        yield_stress_(parameters.number("yield_stress")),
        hardening_modulus_(parameters.number("hardening_modulus")),
        isotropic_modulus_(parameters.number("isotropic_fraction") * hardening_modulus_),
        kinematic_modulus_(hardening_modulus_ - isotropic_modulus_),
        inverse_stiffness_(1.0 / (3.0 * shear_modulus_ + hardening_modulus_)) {}

  bool has_back_stress() const { return kinematic_modulus_ > 0.0; }
  double shear_modulus() const { return shear_modulus_; }

  /// In Pa, at this plastic strain.
  ANVIL_INLINE double yield_stress(double plastic_strain) const {
    return yield_stress_ + isotropic_modulus_ * plastic_strain;
  }

  ANVIL_INLINE PlasticStep return_to_yield(Tensor& trial_deviator, StrengthHistory& history) const {
    if (has_back_stress()) return return_to_moving_surface(trial_deviator, history);
    const double flow_stress = yield_stress(history.plastic_strain);
    const double q_squared = equivalent_stress_squared(trial_deviator);
    if (q_squared <= flow_stress * flow_stress) return {};
    const double q = std::sqrt(q_squared);
    const double increment = (q - flow_stress) * inverse_stiffness_;
    trial_deviator *= 1.0 - 3.0 * shear_modulus_ * increment / q;
    return record(increment, flow_stress, history);
  }

 private:
  ANVIL_INLINE PlasticStep return_to_moving_surface(Tensor& trial_deviator, StrengthHistory& history) const {
    const Tensor relative = trial_deviator - history.back_stress;
    const double flow_stress = yield_stress(history.plastic_strain);
    const double q_squared = equivalent_stress_squared(relative);
    if (q_squared <= flow_stress * flow_stress) return {};
    const double q = std::sqrt(q_squared);
    const double increment = (q - flow_stress) * inverse_stiffness_;
    const Tensor direction = relative * (1.0 / q);
    const double back_stress_along_flow = 1.5 * history.back_stress.cwiseProduct(direction).sum();
    trial_deviator -= 3.0 * shear_modulus_ * increment * direction;
    history.back_stress += kinematic_modulus_ * increment * direction;
    return record(increment, flow_stress + back_stress_along_flow, history);
  }

  /// `flow_stress` is the one at the start of the plastic flow; both kinds of hardening add Ep times the mean strain.
  ANVIL_INLINE PlasticStep record(double increment, double flow_stress, StrengthHistory& history) const {
    const double work = increment * (flow_stress + 0.5 * hardening_modulus_ * increment);
    history.plastic_strain += increment;
    history.plastic_work += work;
    return {increment, work};
  }

  double shear_modulus_;      // Pa
  double yield_stress_;       // Pa
  double hardening_modulus_;  // Pa
  double isotropic_modulus_;  // Pa, beta Ep
  double kinematic_modulus_;  // Pa, (1 - beta) Ep
  double inverse_stiffness_;  // 1 / (3 G + Ep), 1/Pa
};

}  // namespace anvil
