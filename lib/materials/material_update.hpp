// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string_view>

#include "anvil/core/fields.hpp"
#include "anvil/core/particle_range.hpp"
#include "anvil/materials/material_tables.hpp"

namespace anvil {

/// The strength law of one body at work: one virtual call per range of particles, the law inlined below it.
template <int D>
class StrengthUpdate {
 public:
  StrengthUpdate() = default;
  StrengthUpdate(const StrengthUpdate&) = delete;
  StrengthUpdate& operator=(const StrengthUpdate&) = delete;
  virtual ~StrengthUpdate() = default;

  /// Brings the deviators of the range to the end of a step of time_step (s) under the velocity gradients (D x D per
  /// particle of the range, 1/s) and, where there are any, lateral rates (1/s; null: none). Returns the plastic work
  /// done in the range, J.
  virtual double update(ParticleRange range, const double* velocity_gradient, const double* lateral_rate,
                        double time_step) const = 0;
  /// For a law that limits pressure: brings deviators and pressures of the range, as the equation of state gives them,
  /// back to the yield surface. `bulk_sound_speed_squared` in m2/s2, per particle of the range. Returns the plastic
  /// work, J.
  virtual double limit(ParticleRange range, const double* bulk_sound_speed_squared) const = 0;
  [[nodiscard]] virtual bool limits_pressure() const = 0;
  [[nodiscard]] virtual std::string_view law() const = 0;
  [[nodiscard]] virtual bool resists_shear() const = 0;
  [[nodiscard]] virtual double shear_modulus() const = 0;  // Pa
  /// Equivalent stress at which a particle yields now, Pa: infinite for a law without one, zero for a fluid.
  [[nodiscard]] virtual double yield_stress(std::size_t particle) const = 0;
  /// Energy stored by shear in the range, J.
  [[nodiscard]] virtual double elastic_energy(ParticleRange range) const = 0;
};

/// The equation of state of one body at work.
template <int D>
class EosUpdate {
 public:
  EosUpdate() = default;
  EosUpdate(const EosUpdate&) = delete;
  EosUpdate& operator=(const EosUpdate&) = delete;
  virtual ~EosUpdate() = default;

  /// Sets the pressures of the range from its densities and energies and writes the squared speed of sound without
  /// shear, m2/s2, per particle of the range.
  virtual void update(ParticleRange range, double* bulk_sound_speed_squared) const = 0;
  // Scenes with a specific energy: the work of the stress over a step of time_step (s) under the velocity gradients (D
  // x D per particle of the range, 1/s), half of it before density and deviator of the range change and half after,
  // when the pressure it leaves is its own. The trapezoidal rule is of second order.
  virtual void add_work_before(ParticleRange range, const double* velocity_gradient, double time_step) const = 0;
  virtual void add_work_after(ParticleRange range, const double* velocity_gradient, double time_step) const = 0;
  [[nodiscard]] virtual std::string_view law() const = 0;
  /// Energy stored by compression in the range, J; zero for a law that reads the energy, which holds it already.
  [[nodiscard]] virtual double elastic_energy(ParticleRange range) const = 0;
  /// The same from the pressures, p^2/(2 K) per volume, where a strength law limits them.
  [[nodiscard]] virtual double energy_of_pressure(ParticleRange range) const = 0;
};

/// Require the fields the law needs, nothing else. The equation of state of a body comes after its strength; a scene
/// with a specific energy has required it before.
template <int D>
std::unique_ptr<StrengthUpdate<D>> make_strength_update(const Strength& law, FieldStore& fields);
template <int D>
std::unique_ptr<EosUpdate<D>> make_eos_update(const Eos& law, FieldStore& fields);

}  // namespace anvil
