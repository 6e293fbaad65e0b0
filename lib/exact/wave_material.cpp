// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/exact/wave_material.hpp"

#include <cmath>
#include <utility>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

void check_constants(double density, const ElasticPlasticConstants& constants) {
  if (!(density > 0.0)) throw InputError("the density of a layer must be above zero");
  if (!(constants.shear_modulus >= 0.0)) throw InputError("the shear modulus of a layer must not be negative");
  if (!(constants.yield_stress >= 0.0)) throw InputError("the yield stress of a layer must not be negative");
  if (!(constants.hardening_modulus >= 0.0)) throw InputError("the hardening modulus of a layer must not be negative");
  if (!(constants.isotropic_fraction >= 0.0 && constants.isotropic_fraction <= 1.0))
    throw InputError("the isotropic fraction of the hardening lies between 0 and 1");
}

double uniaxial_strain_tangent(const ElasticPlasticConstants& constants) {
  if (constants.hardening_modulus == 0.0) return 0.0;
  return 4.0 / 3.0 * constants.shear_modulus * constants.hardening_modulus /
         (3.0 * constants.shear_modulus + constants.hardening_modulus);
}

}  // namespace

WaveMaterial::WaveMaterial(double density, const PressureLaw& law, double modulus, double tangent,
                           double yield_deviator, double isotropic_fraction, bool logarithmic)
    : density_(density),
      law_(law),
      modulus_(modulus),
      tangent_(tangent),
      yield_deviator_(yield_deviator),
      isotropic_fraction_(isotropic_fraction),
      logarithmic_(logarithmic) {
  if (!(elastic_modulus() > 0.0)) throw InputError("a layer with no stiffness carries no waves");
}

WaveMaterial WaveMaterial::small_strain(double density, double bulk_modulus, const ElasticPlasticConstants& constants) {
  check_constants(density, constants);
  return {density,
          PressureLinearInStrain{bulk_modulus},
          4.0 / 3.0 * constants.shear_modulus,
          uniaxial_strain_tangent(constants),
          2.0 / 3.0 * constants.yield_stress,
          constants.isotropic_fraction,
          false};
}

WaveMaterial WaveMaterial::finite_strain(double density, const PressureLaw& law,
                                         const ElasticPlasticConstants& constants) {
  check_constants(density, constants);
  return {density,
          law,
          4.0 / 3.0 * constants.shear_modulus,
          uniaxial_strain_tangent(constants),
          2.0 / 3.0 * constants.yield_stress,
          constants.isotropic_fraction,
          true};
}

WaveMaterial WaveMaterial::uniaxial_stress(double density, double young_modulus,
                                           const ElasticPlasticConstants& constants) {
  check_constants(density, constants);
  if (std::isfinite(constants.yield_stress) && constants.hardening_modulus == 0.0)
    throw InputError("a rod that yields without hardening has no plastic wave: give it a hardening modulus");
  return {density,
          PressureLinearInStrain{0.0},
          young_modulus,
          young_modulus * constants.hardening_modulus / (young_modulus + constants.hardening_modulus),
          constants.yield_stress,
          constants.isotropic_fraction,
          false};
}

double WaveMaterial::elastic_modulus() const {
  return modulus_ + std::visit([](const auto& law) { return law.bulk_stiffness(); }, law_);
}

double WaveMaterial::plastic_modulus() const {
  return tangent_ + std::visit([](const auto& law) { return law.bulk_stiffness(); }, law_);
}

double WaveMaterial::elastic_wave_speed() const { return std::sqrt(elastic_modulus() / density_); }

double WaveMaterial::plastic_wave_speed() const { return std::sqrt(plastic_modulus() / density_); }

double WaveMaterial::elastic_limit() const {
  if (modulus_ == 0.0) return 0.0;
  return yield_deviator_ * elastic_modulus() / modulus_;
}

WaveState WaveMaterial::rest(double velocity, double deviator) const {
  if (std::abs(deviator) > yield_deviator_)
    throw InputError("the initial deviator of a layer lies beyond its yield limit");
  WaveState state;
  state.velocity = velocity;
  state.stress = deviator;
  state.deviator = deviator;
  state.yield_deviator = yield_deviator_;
  return state;
}

void WaveMaterial::strain_deviator(WaveState& state, double change) const {
  const double sense = change < 0.0 ? -1.0 : 1.0;
  const double limit = state.back_deviator + sense * state.yield_deviator;
  const double trial = state.deviator + modulus_ * change;
  if (sense * (trial - limit) <= 0.0) {
    state.deviator = trial;
    return;
  }
  const double hardened = (trial - limit) * tangent_ / modulus_;
  state.deviator = limit + hardened;
  state.back_deviator += (1.0 - isotropic_fraction_) * hardened;
  state.yield_deviator += isotropic_fraction_ * std::abs(hardened);
}

WaveState WaveMaterial::behind_front(const WaveState& from, double strain) const {
  WaveState state = from;
  state.strain = strain;
  strain_deviator(state,
                  logarithmic_ ? std::log1p((strain - from.strain) / (1.0 + from.strain)) : strain - from.strain);
  const double work_per_stress = 0.5 * (strain - from.strain) / density_;
  const auto [cold, thermal] =
      std::visit([strain](const auto& law) { return std::pair(law.cold(strain), law.thermal(strain)); }, law_);
  // The stress stands on both sides of stress = deviator - cold - thermal * energy(stress); it is linear there.
  state.stress = (state.deviator - cold - thermal * (from.energy + work_per_stress * from.stress)) /
                 (1.0 + thermal * work_per_stress);
  state.energy = from.energy + work_per_stress * (from.stress + state.stress);
  return state;
}

double WaveMaterial::yield_strain(const WaveState& from, double sense) const {
  const double to_limit = from.back_deviator + sense * from.yield_deviator - from.deviator;
  if (modulus_ == 0.0 || !std::isfinite(to_limit)) return sense * std::numeric_limits<double>::infinity();
  const double change = to_limit / modulus_;
  return logarithmic_ ? from.strain + (1.0 + from.strain) * std::expm1(change) : from.strain + change;
}

}  // namespace anvil
