// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "anvil/core/field_keys.hpp"
#include "anvil/materials/material_update.hpp"
#include "anvil/pairs/pair_loops.hpp"
#include "anvil/terms/momentum.hpp"

namespace anvil {

/// Stress and velocity of every approaching pair from a Riemann problem (see sum_hllc and hllc_star): takes the place
/// of momentum, viscosity and the work of stress, and strains the material by the velocities of the star states, so
/// that what compresses a particle is what works on it.
template <int D>
class Hllc final : public ForceTerm<D> {
 public:
  /// The strength of each range of particles; it must outlive the term.
  using Strengths = std::vector<std::pair<ParticleRange, const StrengthUpdate<D>*>>;

  Hllc(FieldStore& fields, Strengths strengths, const HllcChoices& choices)
      : choices_(choices), strengths_(std::move(strengths)), stress_(fields, MomentumForm::sum) {
    fields.require(field::kick_energy);
    pressure_ = fields.scalar(field::pressure);
    fields.require(field::star_gradient, D * D);
    star_gradient_ = fields.vector<D * D>(field::star_gradient).raw();
    if (choices_.gradient == PairGradient::symmetrised) {
      fields.require(field::gradient_correction, symmetric_components<D>);
      correction_ = fields.vector<symmetric_components<D>>(field::gradient_correction).raw();
    }
    if (!choices_.reconstructs) return;
    fields.require(field::velocity_gradient, D * D);
    velocity_gradient_ = fields.vector<D * D>(field::velocity_gradient).raw();
    fields.require(field::pair_acceleration, D);
    acceleration_ = fields.vector<D>(field::pair_acceleration).raw();
  }

  [[nodiscard]] std::string_view name() const override { return "hllc"; }
  [[nodiscard]] std::string_view purpose() const override {
    return choices_.gradient == PairGradient::corrected
               ? "stress and energy from a Riemann problem per pair, with corrected gradients"
               : "stress and energy from a Riemann problem per pair, momentum and energy kept";
  }
  [[nodiscard]] PairNeeds needs() const override {
    return {.gradient = choices_.gradient == PairGradient::corrected,
            .plain_gradient = choices_.gradient != PairGradient::corrected,
            .medium = true,
            .response = true,
            .slope = choices_.reconstructs,
            .correction = choices_.gradient == PairGradient::symmetrised};
  }

  void pack(ParticleRange range, PairRecords<D>& records) const override {
    stress_.pack(range, records);
    const std::size_t body = body_of(range);
    const StrengthUpdate<D>& strength = *strengths_[body].second;
    const double shear = 4.0 / 3.0 * strength.shear_modulus();
    for (std::size_t i = range.first(); i < range.last(); ++i) {
      const double* medium = records.medium[i];
      double* response = records.response[i];
      response[response_pressure] = pressure_[i];
      response[response_density] = medium[1];
      response[response_elastic_speed] = std::sqrt(medium[0] * medium[0] + shear / medium[1]);
      response[response_plastic_speed] = medium[0];
      response[response_inverse_elastic_speed] = 1.0 / response[response_elastic_speed];
      response[response_inverse_shear] = shear > 0.0 ? 1.0 / shear : 0.0;
      response[response_limit] = 2.0 / 3.0 * strength.yield_stress(i);
      if (correction_ != nullptr)
        std::copy_n(correction_ + i * symmetric_components<D>, symmetric_components<D>, records.correction[i]);
      if (!choices_.reconstructs) continue;
      double* slope = records.slope[i];
      std::copy_n(velocity_gradient_ + i * D * D, D * D, slope);
      for (std::size_t a = 0; a < D; ++a) slope[D * D + a] = medium[1] * acceleration_[i * D + a];
      slope[SlopeField<D>::body] = static_cast<double>(body);
    }
  }

  /// `power` is what the pairs bring in at their common velocities, W/kg: see energy.cpp.
  void accumulate(const PairTile<D>& tile, const PairRecords<D>& records, double* acceleration,
                  double* power) const override {
    const auto first = static_cast<std::size_t>(tile.begin), count = static_cast<std::size_t>(tile.end - tile.begin);
    double* star_gradient = star_gradient_ + first * D * D;
    std::fill_n(star_gradient, count * D * D, 0.0);
    pair_loops<D>().hllc(tile, records, choices_, {acceleration, power, star_gradient});
    if (choices_.reconstructs) std::copy_n(acceleration, count * D, acceleration_ + first * D);
  }

  void refine_gradients(ParticleRange range, double* velocity_gradient) const override {
    const std::size_t first = range.first() * D * D, count = static_cast<std::size_t>(range.count()) * D * D;
    if (choices_.reconstructs) std::copy_n(velocity_gradient, count, velocity_gradient_ + first);
    for (std::size_t c = 0; c < count; ++c) velocity_gradient[c] += star_gradient_[first + c];
  }

 private:
  [[nodiscard]] std::size_t body_of(ParticleRange range) const {
    std::size_t body = 0;
    while (body + 1 < strengths_.size() && range.begin >= strengths_[body].first.end) ++body;
    return body;
  }

  HllcChoices choices_;
  Strengths strengths_;
  Momentum<D> stress_;  // for its records
  std::span<const double> pressure_;
  double* star_gradient_ = nullptr;
  double* velocity_gradient_ = nullptr;
  double* acceleration_ = nullptr;
  const double* correction_ = nullptr;
};

}  // namespace anvil
