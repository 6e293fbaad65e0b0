// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/core/field_keys.hpp"
#include "anvil/materials/strain_state.hpp"
#include "anvil/pairs/pair_loops.hpp"
#include "anvil/terms/force_term.hpp"
#include "anvil/total_lagrangian/deformation.hpp"
#include "anvil/total_lagrangian/edge_points.hpp"

namespace anvil {

/// Acceleration by stress in the reference configuration: a_i = (1/rho0) sum_j V_j (P_i B_i + P_j B_j) grad_ij with the
/// nominal (first Piola-Kirchhoff) stress P = sigma cof F and the corrections B (Bonet and Lok 1999; Ganzenmueller
/// 2015). It is the adjoint of the deformation gradient's sum: pair forces are antisymmetric, and what the stress
/// takes from the motion is what deforms the particles. Sums do not join bodies, so 1/rho0 stands in the records.
template <int D>
class NominalMomentum final : public ForceTerm<D> {
 public:
  /// With edges they give the deviatoric part.
  NominalMomentum(FieldStore& fields, const Deformation<D>& deformation, EdgePoints<D>* edges)
      : deformation_(deformation),
        edges_(edges),
        pressure_((fields.require(field::pressure), fields.scalar(field::pressure))),
        viscous_pressure_(fields.has(field::viscous_pressure) ? fields.scalar(field::viscous_pressure).data()
                                                              : nullptr),
        deviator_(edges == nullptr && fields.has(field::deviatoric_stress)
                      ? fields.vector<StrainState::components>(field::deviatoric_stress).raw()
                      : nullptr) {}

  [[nodiscard]] std::string_view name() const override { return "momentum"; }
  [[nodiscard]] std::string_view purpose() const override {
    return "acceleration by nominal stress, V_i V_j (P_i + P_j) in the reference configuration";
  }
  [[nodiscard]] PairNeeds needs() const override { return {.plain_gradient = true, .nominal = true}; }

  void pack(ParticleRange range, PairRecords<D>& records) const override { pack_impulses(range, 1.0, records); }

  /// The stresses of the particles times `span` (s), together with the edges' as these are weighed: sums over pairs are
  /// then changes of velocity, m/s.
  void pack_impulses(ParticleRange range, double span, PairRecords<D>& records) const {
    if (edges_ != nullptr) edges_->sum_forces(range);
    point_loops<D>().pack_nominal(range, deformation_.arrays(),
                                  {.pressure = pressure_.data(),
                                   .viscous_pressure = viscous_pressure_,
                                   .deviator = deviator_,
                                   .edge_sums = edges_ == nullptr ? nullptr : edges_->force_sums()},
                                  span, records.nominal[0]);
  }

  void accumulate(const PairTile<D>& tile, const PairRecords<D>& records, double* acceleration,
                  double* /*loss*/) const override {
    pair_loops<D>().nominal_momentum(tile, records, acceleration);
  }

 private:
  using StrainState = typename StrainStateOf<D>::Type;
  const Deformation<D>& deformation_;
  EdgePoints<D>* edges_;
  std::span<const double> pressure_;
  const double* viscous_pressure_;
  const double* deviator_;  // packed, or none
};

}  // namespace anvil
