// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "anvil/materials/strength/strength_law.hpp"

namespace anvil {

/// Soil: elastic, perfectly plastic with the yield surface of Drucker and Prager, matched to Coulomb's friction in
/// plane strain (Bui et al. 2008, equations 21 to 33). With I1 = -3 p,
///   f = sqrt(J2) + alpha I1 - k <= 0,  alpha = tan(phi)/sqrt(9 + 12 tan(phi)^2),  k = 3 c/sqrt(9 + 12 tan(phi)^2),
/// and the plastic potential sqrt(J2) + 3 I1 sin(psi). The mean stress takes part: see limit.
class DruckerPrager {
 public:
  static EntryKind kind() {
    return {
        .type = "drucker_prager",
        .summary = "soil with friction and cohesion that carries no tension",
        .keys = {{.name = "shear_modulus", .unit = "Pa", .range = Range::positive, .help = "G"},
                 {.name = "friction_angle", .unit = "degrees", .range = Range::positive, .help = "phi, below 90"},
                 {.name = "cohesion", .unit = "Pa", .standard = 0.0, .range = Range::not_negative, .help = "c"},
                 {.name = "dilatancy_angle",
                  .unit = "degrees",
                  .standard = 0.0,
                  .range = Range::not_negative,
                  .help = "psi of the plastic potential, below 90"},
                 {.name = "flow",
                  .kind = ValueKind::choice,
                  .standard = "non_associated",
                  .help = "non_associated: the potential has psi; associated: it is the yield surface",
                  .choices = {"non_associated", "associated"}},
                 {.name = "opening",
                  .kind = ValueKind::choice,
                  .standard = "remembered",
                  .help = "what becomes of a volume that tension has opened: remembered, it must close before there "
                          "is pressure again; forgotten, as the tension correction is printed, pressure "
                          "returns with the first compression and the soil stays loose",
                  .choices = {"remembered", "forgotten"}}}};
  }
  static constexpr bool resists_shear = true;
  static constexpr bool has_plastic_strain = true;
  static constexpr bool limits_pressure = true;

  explicit DruckerPrager(const Parameters& parameters)
      : shear_modulus_(parameters.number("shear_modulus")), forgets_(parameters.text("opening") == "forgotten") {
    constexpr double degree = std::numbers::pi / 180.0;
    const double tangent = std::tan(parameters.number("friction_angle") * degree);
    const double root = std::sqrt(9.0 + 12.0 * tangent * tangent);
    friction_ = tangent / root;
    cohesion_ = 3.0 * parameters.number("cohesion") / root;
    dilatancy_ = parameters.text("flow") == "associated"
                     ? friction_
                     : 3.0 * std::sin(parameters.number("dilatancy_angle") * degree);
  }

  bool has_back_stress() const { return false; }
  double shear_modulus() const { return shear_modulus_; }
  /// Whether the volume of plastic flow has to be remembered beside the density.
  bool dilates() const { return forgets_ || dilatancy_ > 0.0; }
  /// sqrt(J2) on the yield surface at a pressure, Pa; negative beyond the apex.
  ANVIL_INLINE double shear_strength(double pressure) const { return cohesion_ + 3.0 * friction_ * pressure; }

  /// Yields only once the pressure is known.
  ANVIL_INLINE PlasticStep return_to_yield(Tensor& /*trial_deviator*/, StrengthHistory& /*history*/) const {
    return {};
  }

  /// Brings the trial stress, deviator and pressure (Pa), back to the yield surface: plastic flow, then tension to the
  /// apex, then what is left outside is scaled back. `dilation` is the plastic volume strain, `bulk_modulus` in Pa.
  ANVIL_INLINE PlasticStep limit(Tensor& deviator, double& pressure, double& dilation, double bulk_modulus,
                                 StrengthHistory& history) const {
    const double apex = -cohesion_ / (3.0 * friction_);
    if (!forgets_) pressure = std::max(pressure, apex);  // no work is done on soil that is open
    const double trial_root = std::sqrt(equivalent_stress_squared(deviator) / 3.0), trial_pressure = pressure;
    double root = trial_root;
    const double excess = root - shear_strength(pressure);
    if (excess <= 0.0) return {};
    const double multiplier = excess / (9.0 * friction_ * bulk_modulus * dilatancy_ + shear_modulus_);
    root -= shear_modulus_ * multiplier;
    pressure += 3.0 * bulk_modulus * dilatancy_ * multiplier;
    dilation += 3.0 * dilatancy_ * multiplier;
    if (pressure < apex) {
      dilation += (apex - pressure) / bulk_modulus;
      pressure = apex;
    }
    root = std::max(0.0, std::min(root, shear_strength(pressure)));
    if (trial_root > 0.0) deviator *= root / trial_root;
    // Equivalent plastic strain of the deviator taken back: sqrt(3) times its sqrt(J2) over 3 G.
    const double increment = (trial_root - root) / (std::numbers::sqrt3 * shear_modulus_);
    history.plastic_strain += increment;
    const double shear_work = root * (trial_root - root) / shear_modulus_;
    return {increment, shear_work + 0.5 * (pressure + trial_pressure) * (trial_pressure - pressure) / bulk_modulus};
  }

 private:
  double shear_modulus_;  // Pa
  bool forgets_;
  double friction_ = 0.0, cohesion_ = 0.0, dilatancy_ = 0.0;  // alpha, k (Pa), 3 sin(psi) or alpha
};

}  // namespace anvil
