// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "anvil/core/fields.hpp"
#include "anvil/core/particle_range.hpp"
#include "anvil/materials/material_tables.hpp"

namespace anvil {

/// Uniaxial stress, the state of a slender bar in one dimension: the two lateral strain rates are those that leave no
/// lateral stress at the end of a step. Any pair of equation of state and strength law then answers an axial strain as
/// a bar does: elastic with Young's modulus, yielding at the yield stress in simple tension.
class LateralRelease {
 public:
  LateralRelease() = default;
  LateralRelease(const LateralRelease&) = delete;
  LateralRelease& operator=(const LateralRelease&) = delete;
  virtual ~LateralRelease() = default;

  /// Writes the lateral rate of each particle of the range, 1/s, for the axial rates (1/s) of a step of time_step (s)
  /// from the present density, deviator and history.
  virtual void find_rates(ParticleRange range, const double* axial_rate, double time_step,
                          double* lateral_rate) const = 0;
};

/// The fields that the laws need must have been required.
std::unique_ptr<LateralRelease> make_lateral_release(const Strength& strength, const Eos& eos, FieldStore& fields);

}  // namespace anvil
