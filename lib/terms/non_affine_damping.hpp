// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "anvil/core/field_keys.hpp"
#include "anvil/terms/force_term.hpp"

namespace anvil {

/// Viscosity on what the velocity gradients L of a pair's ends do not explain: a_i -= sum_j m_j Pi_ij grad_ij with
/// Pi = -alpha c mu / rho, means of the pair, and mu = h (v_ij . x_ij - x_ij . (L_i + L_j)/2 x_ij) / (x_ij^2 + 0.01
/// h^2) of either sign: the linear part of the artificial viscosity (Monaghan and Gingold 1983) for particles that move
/// against their neighbours. An even flow, compression as well as shear, feels nothing of it. Plain gradients keep both
/// momenta.
template <int D>
class NonAffineDamping final : public ForceTerm<D> {
 public:
  /// Requires the velocity gradients of the last step.
  NonAffineDamping(FieldStore& fields, double coefficient)
      : velocity_gradient_(
            (fields.require(field::velocity_gradient, D * D), fields.vector<D * D>(field::velocity_gradient).raw())),
        coefficient_(coefficient) {}

  [[nodiscard]] std::string_view name() const override { return "non_affine_damping"; }
  [[nodiscard]] std::string_view purpose() const override {
    return "viscosity on the part of pair velocities beside the velocity gradient";
  }
  [[nodiscard]] PairNeeds needs() const override { return {.plain_gradient = true, .medium = true, .slope = true}; }
  void pack(ParticleRange range, PairRecords<D>& records) const override {
    for (std::size_t i = range.first(); i < range.last(); ++i)
      std::copy_n(velocity_gradient_ + i * D * D, D * D, records.slope[i] + SlopeField<D>::velocity);
  }
  void accumulate(const PairTile<D>& tile, const PairRecords<D>& records, double* acceleration,
                  double* loss) const override;
  void refine_gradients(ParticleRange range, double* velocity_gradient) const override {
    std::copy_n(velocity_gradient, static_cast<std::size_t>(range.count()) * D * D,
                velocity_gradient_ + range.first() * D * D);
  }

 private:
  double* velocity_gradient_;
  double coefficient_;
};

}  // namespace anvil
