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

/// exp(x) - 1, relative error x^3 / 24: what is strained until yield, x of Y/G at most, is far less certain in itself
/// where waves run at the speeds ahead of them. Not finite where x is not.
template <class Number>
ANVIL_INLINE Number exp_minus_one(const Number& x) {
  return x * (Number(1.0) + x * (Number(0.5) + x * Number(1.0 / 6.0)));
}

/// What is left of a side behind its elastic precursor, if there is one: where an elastic trial would pass the yield
/// surface.
template <class Number>
struct BehindPrecursor {
  Number velocity;   // m/s
  Number stress;     // Pa
  Number volume;     // over that ahead
  Number impedance;  // times that volume: of the wave that follows
};

/// `trial` is rho c_E of both sides together times the velocity an elastic wave would bring, kg/(m s2), positive where
/// it stretches. A precursor strains by what takes the deviator to the yield surface, dS = 4 G/3 ln(rho/rho*).
/// Direction +1 on the left side, -1 on the right one: the material left of the contact is compressed when u* < u.
template <class Number>
ANVIL_INLINE BehindPrecursor<Number> behind_precursor(const RiemannSide<Number>& side, const Number& trial,
                                                      const Number& both_impedances, double direction) {
  const Number surface = select(trial < Number(0.0), -side.limit, side.limit);
  const Number to_yield = exp_minus_one((surface - side.deviator) * side.inverse_shear);
  const auto yields = max(to_yield, -to_yield) * both_impedances < max(trial, -trial) * side.inverse_elastic_speed;
  const Number strain = select(yields, to_yield, Number(0.0));
  const Number change = side.elastic_speed * strain;
  return {side.velocity + Number(direction) * change, side.stress + side.density * side.elastic_speed * change,
          Number(1.0) + strain, side.density * select(yields, side.plastic_speed, side.elastic_speed)};
}

/// HLLC for elastic-perfectly plastic solids in Lagrangian coordinates: waves at the acoustic speeds of the two sides.
/// An elastic trial; where its deviator passes the yield limit, the elastic precursor is taken off and what is left
/// runs at the plastic speed. Exact in the limit of weak waves; a strong shock is underestimated by about its Mach
/// number's excess over one. Momentum through both waves, +-Z (u* - u) = +-(sigma* - sigma), with Z = impedance over
/// volume: the volumes are multiplied out, so that one quotient serves all.
template <class Number>
ANVIL_INLINE StarState<Number> hllc_star(const RiemannSide<Number>& left, const RiemannSide<Number>& right) {
  const Number parting = right.velocity - left.velocity, pull = right.stress - left.stress;
  const Number left_impedance = left.density * left.elastic_speed;
  const Number right_impedance = right.density * right.elastic_speed;
  const Number both = left_impedance + right_impedance;
  const auto l = behind_precursor(left, right_impedance * parting + pull, both, 1.0);
  const auto r = behind_precursor(right, left_impedance * parting - pull, both, -1.0);
  const Number left_weight = l.impedance * r.volume, right_weight = r.impedance * l.volume;
  const Number inverse = Number(1.0) / (left_weight + right_weight);
  return {
      (left_weight * l.velocity + right_weight * r.velocity + l.volume * r.volume * (r.stress - l.stress)) * inverse,
      (right_weight * l.stress + left_weight * r.stress + l.impedance * r.impedance * (r.velocity - l.velocity)) *
          inverse};
}

}  // namespace anvil
