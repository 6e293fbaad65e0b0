// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "anvil/core/fields.hpp"
#include "anvil/core/inline.hpp"
#include "anvil/core/particle_range.hpp"
#include "anvil/core/tensor.hpp"
#include "anvil/pairs/records.hpp"
#include "anvil/pairs/tile.hpp"
#include "anvil/points/point_loops.hpp"

namespace anvil {

/// D x D, row first, where it stands in an array of tensors.
template <int D>
using Square = Eigen::Matrix<double, D, D, (D == 1 ? Eigen::ColMajor : Eigen::RowMajor) | Eigen::DontAlign>;
template <int D>
using SquareMap = Eigen::Map<Square<D>>;
template <int D>
using ConstSquareMap = Eigen::Map<const Square<D>>;

/// cof F = det F F^-T, what takes a stress of the present configuration to the reference one; out of the plane and
/// across the line nothing deforms.
template <int D>
ANVIL_INLINE Square<D> cofactor(const Square<D>& f) {
  Square<D> c;
  if constexpr (D == 1) {
    c(0, 0) = 1.0;
  } else if constexpr (D == 2) {
    c << f(1, 1), -f(1, 0), -f(0, 1), f(0, 0);
  } else {
    c << f(1, 1) * f(2, 2) - f(1, 2) * f(2, 1), f(1, 2) * f(2, 0) - f(1, 0) * f(2, 2),
        f(1, 0) * f(2, 1) - f(1, 1) * f(2, 0),  //
        f(0, 2) * f(2, 1) - f(0, 1) * f(2, 2), f(0, 0) * f(2, 2) - f(0, 2) * f(2, 0),
        f(0, 1) * f(2, 0) - f(0, 0) * f(2, 1),  //
        f(0, 1) * f(1, 2) - f(0, 2) * f(1, 1), f(0, 2) * f(1, 0) - f(0, 0) * f(1, 2),
        f(0, 0) * f(1, 1) - f(0, 1) * f(1, 0);
  }
  return c;
}

/// det F, from its cofactor.
template <int D>
ANVIL_INLINE double determinant(const Square<D>& f, const Square<D>& cofactor_of_f) {
  double sum = 0.0;
  for (int b = 0; b < D; ++b) sum += f(0, b) * cofactor_of_f(0, b);
  return sum;
}

/// How far particles have deformed from the configuration they started in. The gradients of that configuration never
/// change, so F_i = sum_j V_j (x_j - x_i) (x) B_i grad_ij is linear in the positions, with V_j the volumes at the start
/// and B_i the gradient correction (Bonet and Lok 1999), and its rate takes the same sum over velocities: F advances by
/// exactly dt times the rate of the middle of a step.
template <int D>
class Deformation {
 public:
  /// Requires the deformation gradient, the unit matrix at the start. Densities are those of the start.
  explicit Deformation(FieldStore& fields);

  /// The corrections of the particles of a tile whose gradients are those of the start. A particle that has none keeps
  /// plain gradients; returns how many do.
  int find_corrections(const PairTile<D>& tile, const PairRecords<D>& records);

  /// Advances the particles of the range over time_step (s) and sets their densities. On entry `gradients` holds the
  /// sums of V_j (v_j - v_i) (x) grad_ij, D x D per particle of the range; on return the velocity gradients of the
  /// present configuration in the middle of the step, 1/s.
  void advance(ParticleRange range, double* gradients, double time_step);

  /// What loops over particles and edges read and write.
  [[nodiscard]] DeformationArrays<D> arrays() const {
    return {gradient_, correction_.data(), reference_density_.data(), density_.data(), volume_.data()};
  }
  /// m3 (m2, m), and 1.
  [[nodiscard]] double volume(std::size_t i) const { return volume_[i]; }
  [[nodiscard]] ConstSquareMap<D> gradient(std::size_t i) const { return ConstSquareMap<D>(gradient_ + i * D * D); }
  [[nodiscard]] ConstSquareMap<D> correction(std::size_t i) const { return ConstSquareMap<D>(&correction_[i * D * D]); }
  [[nodiscard]] double reference_density(std::size_t i) const { return reference_density_[i]; }
  /// The least principal stretch is at least this: sqrt(D) / |F^-1| in the Frobenius norm. It shortens the time step.
  [[nodiscard]] double least_stretch(std::size_t i) const {
    const Square<D> f = gradient(i), c = cofactor<D>(f);
    return std::sqrt(static_cast<double>(D)) * determinant<D>(f, c) / c.norm();
  }
  /// The same of each particle of the range.
  void find_least_stretches(ParticleRange range, double* stretch) const;
  [[nodiscard]] static constexpr int doubles_per_particle() { return D * D + 2; }  // beside the fields

 private:
  double* gradient_;
  std::span<const double> mass_;
  std::span<double> density_;
  std::vector<double> reference_density_, volume_, correction_;
};

}  // namespace anvil
