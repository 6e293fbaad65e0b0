// SPDX-License-Identifier: BSD-3-Clause
// The plates of Wang 2002 and Sun 2017 with the constants of their tables.
#pragma once

#include "anvil/exact/plate.hpp"

namespace anvil {

constexpr double mm = 1e-3;
constexpr double us = 1e-6;
constexpr double gpa = 1e9;

inline constexpr ElasticPlasticConstants steel_constants{.shear_modulus = 85.3 * gpa, .yield_stress = 1.0 * gpa};
inline constexpr double steel_density = 7800.0;
inline constexpr double steel_bulk_modulus = 222.5 * gpa;

inline ElasticPlasticConstants hardening_steel() {
  constexpr double young = 227.5 * gpa;
  constexpr double tangent = young / 10.0;
  ElasticPlasticConstants constants = steel_constants;
  constants.hardening_modulus = young * tangent / (young - tangent);
  return constants;
}

inline WaveMaterial steel(const ElasticPlasticConstants& constants = steel_constants) {
  return WaveMaterial::small_strain(steel_density, steel_bulk_modulus, constants);
}
inline WaveMaterial logarithmic_steel(const ElasticPlasticConstants& constants = steel_constants) {
  return WaveMaterial::finite_strain(steel_density, PressureLogarithmic{steel_bulk_modulus}, constants);
}
inline WaveMaterial dense_steel(const ElasticPlasticConstants& constants = steel_constants) {
  return WaveMaterial::finite_strain(steel_density, PressureLinearInDensity{steel_bulk_modulus}, constants);
}
inline WaveMaterial elastic_steel() { return steel({.shear_modulus = 85.3 * gpa}); }
inline WaveMaterial elastic_aluminium() {
  return WaveMaterial::small_strain(2710.0, 66.67 * gpa, {.shear_modulus = 25.0 * gpa});
}

inline PlateProblem two_layer_plate() {
  PlateProblem plate;
  plate.layers = {{50.0 * mm, elastic_aluminium()}, {30.0 * mm, elastic_steel()}};
  plate.left_face.pressure = PressureHistory::rectangular(0.5 * gpa, 5.0 * us);
  return plate;
}

inline PlateProblem loaded_plate(const WaveMaterial& material, const PressureHistory& pressure) {
  PlateProblem plate;
  plate.layers = {{80.0 * mm, material}};
  plate.left_face.pressure = pressure;
  return plate;
}

inline PlateProblem perfect_plate(const WaveMaterial& material) {
  return loaded_plate(material, PressureHistory::rectangular(5.0 * gpa, 5.0 * us));
}

inline PlateProblem hardening_plate(const WaveMaterial& material) {
  return loaded_plate(material, PressureHistory::exponential(6.0 * gpa, 7.0 * us));
}

inline PlateProblem two_plates(const WaveMaterial& flyer, const WaveMaterial& target, double velocity) {
  PlateProblem plates;
  plates.left_position = -100.0 * mm;
  plates.layers = {{100.0 * mm, flyer, velocity}, {100.0 * mm, target}};
  return plates;
}

}  // namespace anvil
