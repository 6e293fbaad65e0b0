// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/core/inline.hpp"
#include "anvil/core/lane_math.hpp"

namespace anvil {

/// One side of a Riemann problem along n, from the left side to the right one. `Number` is a double or a vector of
/// lanes. Stress is positive in tension; velocity, stress and deviator are components along n.
template <class Number>
struct RiemannSide {
  Number velocity;       // m/s
  Number stress;         // Pa
  Number deviator;       // Pa
  Number density;        // kg/m3
  Number elastic_speed;  // c_E, m/s: c_E^2 = c_P^2 + 4 G / (3 rho)
  Number plastic_speed;  // c_P, m/s: the bulk speed of sound
  Number shear;          // 4 G / 3, Pa
  Number inverse_shear;  // 1/Pa; zero in a fluid
  Number limit;          // 2 Y / 3, Pa: the deviator's largest magnitude; infinite without yield
};

/// What both sides share behind their waves.
template <class Number>
struct StarState {
  Number velocity;  // m/s
  Number stress;    // Pa
};

/// ln(1 + x) by the series of the inverse hyperbolic tangent: relative error 1e-7 at x = 0.5, round-off below 0.02.
template <class Number>
ANVIL_INLINE Number log_of_one_plus(const Number& x) {
  const Number z = x / (Number(2.0) + x), square = z * z;
  return Number(2.0) * z *
         (Number(1.0) + square * (Number(1.0 / 3.0) + square * (Number(1.0 / 5.0) + square * Number(1.0 / 7.0))));
}

/// exp(x) - 1 by a Pade approximant, x^7 / 100800 off.
template <class Number>
ANVIL_INLINE Number exp_minus_one(const Number& x) {
  const Number square = x * x;
  return x * (Number(120.0) + Number(2.0) * square) /
         (Number(120.0) + Number(12.0) * square - x * (Number(60.0) + square));
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

/// The deviator behind an elastic wave that brings the velocity to `star`; direction +1 on the left side, -1 on the
/// right one: the material between a left-going wave and the contact is compressed when u* < u.
template <class Number>
ANVIL_INLINE Number elastic_deviator(const RiemannSide<Number>& side, const Number& star, double direction) {
  const Number volume_strain = Number(direction) * (star - side.velocity) / side.elastic_speed;
  return side.deviator + side.shear * log_of_one_plus(volume_strain);
}

/// The side behind its elastic precursor, where it yields at `limit` with the sign of the trial deviator.
template <class Number>
ANVIL_INLINE RiemannSide<Number> behind_precursor(const RiemannSide<Number>& side, const Number& trial,
                                                  double direction) {
  RiemannSide<Number> behind = side;
  behind.deviator = select(trial < Number(0.0), -side.limit, side.limit);
  const Number volume_strain = exp_minus_one((behind.deviator - side.deviator) * side.inverse_shear);
  behind.density = side.density / (Number(1.0) + volume_strain);
  behind.velocity = side.velocity + Number(direction) * side.elastic_speed * volume_strain;
  behind.stress = side.stress + side.density * side.elastic_speed * side.elastic_speed * volume_strain;
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
  const Number left_trial = elastic_deviator(left, trial.velocity, 1.0);
  const Number right_trial = elastic_deviator(right, trial.velocity, -1.0);
  const auto left_yields = left.limit < max(left_trial, -left_trial);
  const auto right_yields = right.limit < max(right_trial, -right_trial);
  if (!any(left_yields) && !any(right_yields)) return trial;
  RiemannSide<Number> left_behind = behind_precursor(left, left_trial, 1.0);
  RiemannSide<Number> right_behind = behind_precursor(right, right_trial, -1.0);
  left_behind.velocity = select(left_yields, left_behind.velocity, left.velocity);
  left_behind.stress = select(left_yields, left_behind.stress, left.stress);
  right_behind.velocity = select(right_yields, right_behind.velocity, right.velocity);
  right_behind.stress = select(right_yields, right_behind.stress, right.stress);
  return acoustic_star(left_behind, select(left_yields, left_behind.density * left.plastic_speed, left_impedance),
                       right_behind, select(right_yields, right_behind.density * right.plastic_speed, right_impedance));
}

}  // namespace anvil
