// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "anvil/core/field_keys.hpp"
#include "anvil/materials/strain_state.hpp"
#include "anvil/pairs/pair_loops.hpp"
#include "anvil/pairs/transform.hpp"
#include "anvil/terms/force_term.hpp"

namespace anvil {

/// Acceleration by stress with corrected gradients on both sides: a_i = (1/rho_i) sum_j V_j (sigma_i B_i + sigma_j B_j)
/// grad_ij with the corrections B of the velocity gradient (Bonet and Lok 1999). The adjoint of that gradient: pair
/// forces are antisymmetric, and what the stress takes from the motion is what strains the particles.
template <int D>
class AdjointMomentum final : public ForceTerm<D> {
 public:
  explicit AdjointMomentum(FieldStore& fields)
      : density_(fields.scalar(field::density)),
        mass_(fields.scalar(field::mass)),
        pressure_((fields.require(field::pressure), fields.scalar(field::pressure))),
        correction_((fields.require(field::gradient_correction, symmetric_components<D>),
                     fields.vector<symmetric_components<D>>(field::gradient_correction).raw())),
        viscous_pressure_(fields.has(field::viscous_pressure) ? fields.scalar(field::viscous_pressure).data()
                                                              : nullptr),
        deviator_(fields.has(field::deviatoric_stress)
                      ? fields.vector<StrainState::components>(field::deviatoric_stress).raw()
                      : nullptr) {}

  [[nodiscard]] std::string_view name() const override { return "momentum"; }
  [[nodiscard]] std::string_view purpose() const override {
    return "acceleration by stress, the adjoint of the corrected velocity gradient";
  }
  [[nodiscard]] PairNeeds needs() const override { return {.plain_gradient = true, .nominal = true}; }

  void pack(ParticleRange range, PairRecords<D>& records) const override {
    for (std::size_t i = range.first(); i < range.last(); ++i) {
      const double pressure = pressure_[i] + (viscous_pressure_ == nullptr ? 0.0 : viscous_pressure_[i]);
      Mat<D> stress = Mat<D>::Identity() * -pressure;
      if (deviator_ != nullptr)
        stress += StrainState::deviator(deviator_ + i * StrainState::components).template topLeftCorner<D, D>();
      const Mat<D> corrected = stress * unpack_symmetric<D>(correction_ + i * symmetric_components<D>);
      double* record = records.nominal[i];
      for (int a = 0; a < D; ++a)
        for (int b = 0; b < D; ++b) record[a * D + b] = corrected(a, b);
      record[D * D] = mass_[i] / density_[i];
    }
  }

  void accumulate(const PairTile<D>& tile, const PairRecords<D>& records, double* acceleration,
                  double* /*loss*/) const override {
    static thread_local std::vector<double> sums;  // a step allocates nothing
    sums.assign(static_cast<std::size_t>(tile.end - tile.begin) * D, 0.0);
    pair_loops<D>().nominal_momentum(tile, records, sums.data());
    const double* sum = sums.data();
    for (auto i = static_cast<std::size_t>(tile.begin); i < static_cast<std::size_t>(tile.end); ++i)
      for (int a = 0; a < D; ++a) *acceleration++ += *sum++ / density_[i];
  }

 private:
  using StrainState = typename StrainStateOf<D>::Type;

  std::span<const double> density_, mass_, pressure_;
  const double* correction_;
  const double* viscous_pressure_;
  const double* deviator_;  // packed, or none
};

}  // namespace anvil
