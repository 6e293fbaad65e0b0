// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "anvil/core/inline.hpp"
#include "anvil/scene/key.hpp"

namespace anvil {

/// p = B ((rho / rho0)^gamma - 1) (Tait 1888 in the form of Monaghan 1994): a liquid, made softer than it is so that
/// flows are ten times slower than its sound. gamma B is the bulk modulus at rho0.
class TaitEos {
 public:
  static EntryKind kind() {
    return {.type = "tait",
            .summary = "p = B ((rho / rho0)^gamma - 1), a liquid",
            .keys = {{.name = "stiffness",
                      .unit = "Pa",
                      .range = Range::positive,
                      .help = "B; 100 rho0 v^2 / gamma gives sound ten times as fast as the largest speed v"},
                     {.name = "exponent", .standard = 7.0, .range = Range::positive, .help = "gamma"},
                     {.name = "tension_limit",
                      .unit = "Pa",
                      .range = Range::not_negative,
                      .help = "the largest tension; where it is reached the liquid opens without further stress, and "
                              "must close again before there is pressure. 0 for water that splashes, whose drops "
                              "would pull each other together",
                      .optional = true,
                      .derived = "B"}}};
  }
  static constexpr bool uses_energy = false;

  TaitEos(const Parameters& parameters, double reference_density)
      : reference_density_(reference_density),
        stiffness_(parameters.number("stiffness")),
        exponent_(parameters.number("exponent")) {
    const double limit = parameters.has("tension_limit") ? parameters.number("tension_limit") : stiffness_;
    if (limit >= stiffness_) return;
    least_pressure_ = -limit;
    opening_density_ = reference_density_ * std::exp(std::log1p(-limit / stiffness_) / exponent_);
  }

  ANVIL_INLINE double pressure(double density, double /*energy*/) const {
    return std::max(least_pressure_, stiffness_ * std::expm1(exponent_ * log_compression(density)));
  }
  /// That of the closed liquid also where it is open: it may close at any time.
  ANVIL_INLINE double bulk_sound_speed_squared(double density, double /*energy*/) const {
    return exponent_ * stiffness_ * std::exp(exponent_ * log_compression(density)) / density;
  }

  /// B / rho0 ((x^(gamma - 1) - 1) / (gamma - 1) + 1 / x - 1) with x = rho / rho0; what opens takes up no more than
  /// the work of the tension.
  ANVIL_INLINE double cold_energy(double density) const {
    const double closed = std::max(density, opening_density_);
    const double opening = closed > density ? least_pressure_ * (1.0 / closed - 1.0 / density) : 0.0;
    const double log_x = log_compression(closed), power = exponent_ - 1.0;
    const double stored = power == 0.0 ? log_x : std::expm1(power * log_x) / power;
    return stiffness_ / reference_density_ * (stored + std::expm1(-log_x)) + opening;
  }

 private:
  /// ln(rho / rho0); written so that small compressions keep their digits.
  ANVIL_INLINE double log_compression(double density) const {
    return std::log1p((density - reference_density_) / reference_density_);
  }

  double reference_density_;  // kg/m3
  double stiffness_;          // Pa
  double exponent_;
  double least_pressure_ = -std::numeric_limits<double>::max();  // Pa
  double opening_density_ = 0.0;                                 // kg/m3, where the tension reaches its limit
};

}  // namespace anvil
