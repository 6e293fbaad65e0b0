// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/core/field_keys.hpp"
#include "anvil/pairs/pair_loops.hpp"
#include "anvil/terms/force_term.hpp"

namespace anvil {

/// The discrete divergences of stress on offer. The first two conserve linear momentum to round-off: with h_ij
/// symmetric the force of a pair is antisymmetric. The third is exact for linear stress where the gradients are
/// corrected.
enum class MomentumForm {
  sum,              // a_i = (1/rho_i) sum_j V_j (sigma_i + sigma_j) . grad_ij  (Long 2007, equation 9)
  density_squared,  // a_i = sum_j m_j (sigma_i/rho_i^2 + sigma_j/rho_j^2) . grad_ij  (Monaghan 1992, equation 3.3)
  difference,       // a_i = (1/rho_i) sum_j V_j (sigma_j - sigma_i) . grad_ij  (Wang 2002; Sun 2017)
};

/// Acceleration by stress. One loop serves the sums: a_i = scale_i sum_j w_j (T_i + T_j) . grad_ij with T = sigma,
/// w = V, scale = 1/rho, or T = sigma/rho^2, w = m, scale = 1.
template <int D>
class Momentum final : public ForceTerm<D> {
 public:
  Momentum(FieldStore& fields, MomentumForm form)
      : form_(form),
        mass_((fields.require(field::mass), fields.scalar(field::mass))),
        density_((fields.require(field::density), fields.scalar(field::density))),
        pressure_((fields.require(field::pressure), fields.scalar(field::pressure))),
        viscous_pressure_(fields.has(field::viscous_pressure) ? fields.scalar(field::viscous_pressure).data()
                                                              : nullptr),
        deviator_(fields.has(field::deviatoric_stress)
                      ? fields.vector<symmetric_components<D>>(field::deviatoric_stress).raw()
                      : nullptr) {}

  [[nodiscard]] std::string_view name() const override { return "momentum"; }
  [[nodiscard]] std::string_view purpose() const override {
    if (form_ == MomentumForm::sum) return "acceleration by stress, V_i V_j (sigma_i + sigma_j)";
    if (form_ == MomentumForm::difference) return "acceleration by stress, V_j (sigma_j - sigma_i)";
    return "acceleration by stress, m_i m_j (sigma_i/rho_i^2 + sigma_j/rho_j^2)";
  }
  [[nodiscard]] PairNeeds needs() const override {
    return {.gradient = form_ == MomentumForm::difference, .plain_gradient = form_ != MomentumForm::difference};
  }

  void pack(ParticleRange range, PairRecords<D>& records) const override {
    constexpr int components = symmetric_components<D>;
    for (std::size_t i = range.first(); i < range.last(); ++i) {
      double* record = records.traction[i];
      const double scale = form_ != MomentumForm::density_squared ? 1.0 : 1.0 / (density_[i] * density_[i]);
      const double pressure = pressure_[i] + (viscous_pressure_ == nullptr ? 0.0 : viscous_pressure_[i]);
      for (std::size_t c = 0; c < components; ++c) {
        const double deviator = deviator_ == nullptr ? 0.0 : deviator_[i * components + c];
        record[c] = scale * (c < D ? deviator - pressure : deviator);
      }
      record[components] = form_ != MomentumForm::density_squared ? mass_[i] / density_[i] : mass_[i];
    }
  }

  void accumulate(const PairTile<D>& tile, const PairRecords<D>& records, double* acceleration,
                  double* /*loss*/) const override {
    const double* divisor = form_ != MomentumForm::density_squared ? density_.data() : nullptr;
    const PairLoops<D>& loops = pair_loops<D>();
    (form_ == MomentumForm::difference ? loops.stress_difference : loops.momentum)(tile, records, divisor,
                                                                                   acceleration);
  }

 private:
  MomentumForm form_;
  std::span<const double> mass_, density_, pressure_;
  const double* viscous_pressure_;  // or none
  const double* deviator_;          // packed, or none in a fluid
};

}  // namespace anvil
