// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/core/inline.hpp"
#include "anvil/core/lane_math.hpp"

namespace anvil {

/// One side of a Riemann problem along n, from the left side to the right one. `Number` is a double or a vector of
/// lanes. Stress is positive in tension; velocity, stress and deviator are components along n.
template <class Number>
struct RiemannSide {
  Number velocity;               // m/s
  Number stress;                 // Pa
  Number deviator;               // Pa
  Number density;                // kg/m3
  Number elastic_speed;          // c_E, m/s: c_E^2 = c_P^2 + 4 G / (3 rho)
  Number plastic_speed;          // c_P, m/s: the bulk speed of sound
  Number inverse_elastic_speed;  // s/m
  Number inverse_shear;          // 3 / (4 G), 1/Pa; zero in a fluid
  Number limit;                  // 2 Y / 3, Pa: the deviator's largest magnitude; infinite without yield
};

/// What both sides share behind their waves.
template <class Number>
struct StarState {
  Number velocity;  // m/s
  Number stress;    // Pa
};

/// exp(x) - 1, relative error x^6 / 5040; not finite where x is not.
template <class Number>
ANVIL_INLINE Number exp_minus_one(const Number& x) {
  const Number inner = Number(1.0 / 24.0) + x * (Number(1.0 / 120.0) + x * Number(1.0 / 720.0));
  return x * (Number(1.0) + x * (Number(0.5) + x * (Number(1.0 / 6.0) + x * inner)));
}

/// Momentum through both waves: +-rho c (u* - u) = +-(sigma* - sigma).
template <class Number>
ANVIL_INLINE StarState<Number> acoustic_star(const RiemannSide<Number>& left, const Number& left_impedance,
                                             const RiemannSide<Number>& right, const Number& right_impedance) {
  const Number inverse = Number(1.0) / (left_impedance + right_impedance);
  const Number closing = left.velocity - right.velocity;
  return {(left_impedance * left.velocity + right_impedance * right.velocity - (left.stress - right.stress)) * inverse,
          (right_impedance * left.stress + left_impedance * right.stress - left_impedance * right_impedance * closing) *
              inverse};
}

/// An elastic wave ahead of a plastic one, where the trial passes the yield surface.
template <class Number, class Mask>
struct Precursor {
  Mask yields;
  Number strain;  // of volume, zero where the side stays elastic
};

/// The strain of a precursor brings the deviator to the yield surface, dS = 4 G/3 ln(rho/rho*). Direction +1 on the
/// left side, -1 on the right one: the material between a left-going wave and the contact is compressed when u* < u.
template <class Number>
ANVIL_INLINE auto precursor_of(const RiemannSide<Number>& side, const Number& star, double direction) {
  const Number trial = Number(direction) * (star - side.velocity) * side.inverse_elastic_speed;
  const Number surface = select(trial < Number(0.0), -side.limit, side.limit);
  const Number strain = exp_minus_one((surface - side.deviator) * side.inverse_shear);
  const auto yields = max(strain, -strain) < max(trial, -trial);
  return Precursor<Number, decltype(yields)>{yields, select(yields, strain, Number(0.0))};
}

/// The side behind its precursor: velocity and stress.
template <class Number>
ANVIL_INLINE RiemannSide<Number> behind_precursor(const RiemannSide<Number>& side, const Number& strain,
                                                  double direction) {
  RiemannSide<Number> behind = side;
  behind.velocity += Number(direction) * side.elastic_speed * strain;
  behind.stress += side.density * side.elastic_speed * side.elastic_speed * strain;
  return behind;
}

/// HLLC for elastic-perfectly plastic solids in Lagrangian coordinates: waves at the acoustic speeds of the two sides.
/// An elastic trial; where its deviator passes the yield limit, the elastic precursor is taken off and what is left
/// runs at the plastic speed. Exact in the limit of weak waves; a strong shock is underestimated by about its Mach
/// number's excess over one.
template <class Number>
ANVIL_INLINE StarState<Number> hllc_star(const RiemannSide<Number>& left, const RiemannSide<Number>& right) {
  const Number left_impedance = left.density * left.elastic_speed;
  const Number right_impedance = right.density * right.elastic_speed;
  const StarState<Number> trial = acoustic_star(left, left_impedance, right, right_impedance);
  const auto left_wave = precursor_of(left, trial.velocity, 1.0),
             right_wave = precursor_of(right, trial.velocity, -1.0);
  if (!any(left_wave.yields) && !any(right_wave.yields)) return trial;
  const Number left_volume = Number(1.0) + left_wave.strain, right_volume = Number(1.0) + right_wave.strain;
  const Number inverse = Number(1.0) / (left_volume * right_volume);  // one quotient for both densities
  const Number left_plastic = left.density * right_volume * inverse * left.plastic_speed;
  const Number right_plastic = right.density * left_volume * inverse * right.plastic_speed;
  return acoustic_star(
      behind_precursor(left, left_wave.strain, 1.0), select(left_wave.yields, left_plastic, left_impedance),
      behind_precursor(right, right_wave.strain, -1.0), select(right_wave.yields, right_plastic, right_impedance));
}

}  // namespace anvil
