// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/core/field_keys.hpp"
#include "anvil/pairs/pair_loops.hpp"
#include "anvil/terms/force_term.hpp"

namespace anvil {

/// Artificial viscosity (Monaghan and Gingold 1983): see sum_viscosity. Uncorrected gradients conserve momentum.
template <int D>
class Viscosity final : public ForceTerm<D> {
 public:
  explicit Viscosity(const ViscosityCoefficients& coefficients) : coefficients_(coefficients) {}

  [[nodiscard]] std::string_view name() const override { return "viscosity"; }
  [[nodiscard]] std::string_view purpose() const override { return "artificial viscosity between approaching pairs"; }
  [[nodiscard]] PairNeeds needs() const override { return {.plain_gradient = true, .medium = true}; }
  void pack(ParticleRange /*range*/, PairRecords<D>& /*records*/) const override {}
  void accumulate(const PairTile<D>& tile, const PairRecords<D>& records, double* acceleration,
                  double* loss) const override {
    pair_loops<D>().viscosity(tile, records, coefficients_, acceleration, loss);
  }

 private:
  ViscosityCoefficients coefficients_;
};

}  // namespace anvil
