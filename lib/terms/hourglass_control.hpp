// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

#include "anvil/core/fields.hpp"
#include "anvil/core/particle_range.hpp"
#include "anvil/kernels/kernel.hpp"
#include "anvil/pairs/images.hpp"
#include "anvil/terms/force_term.hpp"
#include "anvil/total_lagrangian/deformation.hpp"

namespace anvil {

/// Hourglass control by stiffness (Ganzenmueller 2015): a pair at x_ij instead of at (F_i + F_j)/2 X_ij, which its
/// deformation gradients predict, is pushed there along x_ij, a_i = (1/m_i) sum_j V_i V_j W(X_ij)/X_ij^2 alpha E delta
/// x_ij/r_ij with delta = ((F_i + F_j)/2 X_ij - x_ij) . x_ij/r_ij. Pair forces are central and antisymmetric. They
/// resist plastic flow too: whatever the gradients do not see is taken for an error.
template <int D>
class HourglassControl final : public ForceTerm<D> {
 public:
  /// A range of particles, a body, and alpha E of its material, Pa.
  struct Stiffness {
    ParticleRange body;
    double modulus;
  };

  /// Pairs of the start within bodies, and with `images` behind symmetry planes. Requires its own acceleration of the
  /// last step: its work over a step is that of the mean of the forces at both ends.
  HourglassControl(FieldStore& fields, const Deformation<D>& deformation, const Kernel& kernel,
                   const std::vector<Stiffness>& bodies, Images<D> images = {});

  [[nodiscard]] std::string_view name() const override { return "hourglass_control"; }
  [[nodiscard]] std::string_view purpose() const override {
    return "pairs are pushed to the distance their deformation gradients predict";
  }
  [[nodiscard]] PairNeeds needs() const override { return {}; }
  void pack(ParticleRange /*range*/, PairRecords<D>& /*records*/) const override {}
  /// `loss` is what the motion gives, and may get back: W/kg.
  void accumulate(const PairTile<D>& tile, const PairRecords<D>& records, double* acceleration,
                  double* loss) const override;

 private:
  struct Pair {
    std::int32_t other, transform;  // transform -1: none
    Vec<D> start;                   // X_ij, m
    double weight;                  // V_j W(X_ij) / X_ij^2 alpha E / rho0, 1/s2
  };
  void add_pair(std::size_t i, std::size_t j, std::int32_t transform, double modulus,
                std::span<const double> smoothing_length);
  [[nodiscard]] Vec<D> pull(std::size_t i, const Pair& pair) const;

  VectorView<D> position_, initial_position_, velocity_;
  double* last_;  // m/s2, D per particle
  const Deformation<D>& deformation_;
  Kernel kernel_;
  std::vector<Transform<D>> transforms_;
  std::vector<Pair> pairs_;
  std::vector<std::size_t> first_pair_;  // by particle
};

}  // namespace anvil
