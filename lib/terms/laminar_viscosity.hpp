// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/pairs/pair_loops.hpp"
#include "anvil/terms/force_term.hpp"

namespace anvil {

/// Viscosity of a fluid (Morris, Fox and Zhu 1997): see sum_laminar_viscosity.
template <int D>
class LaminarViscosity final : public ForceTerm<D> {
 public:
  LaminarViscosity() = default;

  [[nodiscard]] std::string_view name() const override { return "laminar_viscosity"; }
  [[nodiscard]] std::string_view purpose() const override { return "viscous forces of the fluid between pairs"; }
  [[nodiscard]] PairNeeds needs() const override { return {.plain_gradient = true, .medium = true}; }
  void pack(ParticleRange /*range*/, PairRecords<D>& /*records*/) const override {}
  void accumulate(const PairTile<D>& tile, const PairRecords<D>& records, double* acceleration,
                  double* loss) const override {
    pair_loops<D>().laminar_viscosity(tile, records, acceleration, loss);
  }
};

}  // namespace anvil
