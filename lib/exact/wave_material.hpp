// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "anvil/exact/pressure_law.hpp"

namespace anvil {

/// A material point in a plane wave along x. Stress is positive in tension.
struct WaveState {
  double strain = 0.0;          // rho0 / rho - 1
  double velocity = 0.0;        // m/s
  double energy = 0.0;          // specific internal energy, J/kg, from the Rankine-Hugoniot relation of every front
  double stress = 0.0;          // axial, Pa
  double deviator = 0.0;        // Pa, axial part of the stress deviator (uniaxial stress: the axial stress)
  double back_deviator = 0.0;   // Pa, centre of the elastic range of `deviator`
  double yield_deviator = 0.0;  // Pa, half the width of that range

  [[nodiscard]] double pressure() const { return deviator - stress; }
};

/// Elastic constants and yield of an isotropic material, in Pa. No yield stress: elastic. `hardening_modulus` is
/// d(yield stress) / d(plastic strain); of a tangent modulus Et in simple tension it is E Et / (E - Et).
struct ElasticPlasticConstants {
  double shear_modulus = 0.0;
  double yield_stress = std::numeric_limits<double>::infinity();
  double hardening_modulus = 0.0;
  double isotropic_fraction = 1.0;  // of the hardening; the rest moves the elastic range
};

/// What one material does in a plane wave: axial stress = deviator - pressure. The deviator follows the strain
/// with a constant modulus between the yield limits and with a constant tangent beyond them.
class WaveMaterial {
 public:
  /// Uniaxial strain. Small strain: both strain measures are rho0 / rho - 1, and every wave speed is constant.
  /// Otherwise the deviator follows ln(rho0 / rho), which is what a rate form with a Jaumann or any other rate
  /// integrates to. Elastic and plastic moduli of the deviator: 4 G / 3 and (4 G / 3) H / (3 G + H). Throws InputError.
  static WaveMaterial small_strain(double density, double bulk_modulus, const ElasticPlasticConstants& constants);
  static WaveMaterial finite_strain(double density, const PressureLaw& law, const ElasticPlasticConstants& constants);

  /// Uniaxial stress (a slender rod) in small strain: E and E H / (E + H). A rod that yields must harden: without
  /// hardening there is no plastic wave. Throws InputError.
  static WaveMaterial uniaxial_stress(double density, double young_modulus, const ElasticPlasticConstants& constants);

  [[nodiscard]] double density() const { return density_; }
  /// Axial stress over strain at the reference density, elastic and yielding, Pa.
  [[nodiscard]] double elastic_modulus() const;
  [[nodiscard]] double plastic_modulus() const;
  [[nodiscard]] double elastic_wave_speed() const;
  [[nodiscard]] double plastic_wave_speed() const;
  /// Hugoniot elastic limit in small strain, Pa.
  [[nodiscard]] double elastic_limit() const;
  /// All fronts of a small-strain material move at one of two speeds.
  [[nodiscard]] bool is_linear() const { return !logarithmic_; }

  /// Unloaded, or with a deviator that the yield limit holds; throws InputError when it does not.
  [[nodiscard]] WaveState rest(double velocity = 0.0, double deviator = 0.0) const;

  /// The state at `strain` behind one front that runs into `from`, all but its velocity: deviator along the
  /// monotone path, energy and stress by the Rankine-Hugoniot relation
  ///   energy - energy0 = (stress + stress0) (strain - strain0) / (2 rho0).
  [[nodiscard]] WaveState behind_front(const WaveState& from, double strain) const;

  /// Strain at which the deviator reaches its yield limit, growing (sense > 0) or falling; infinite if it never does.
  [[nodiscard]] double yield_strain(const WaveState& from, double sense) const;

 private:
  WaveMaterial(double density, const PressureLaw& law, double modulus, double tangent, double yield_deviator,
               double isotropic_fraction, bool logarithmic);
  void strain_deviator(WaveState& state, double change) const;

  double density_;
  PressureLaw law_;
  double modulus_;         // of the deviator, elastic
  double tangent_;         // of the deviator, yielding
  double yield_deviator_;  // at the start
  double isotropic_fraction_;
  bool logarithmic_;
};

}  // namespace anvil
