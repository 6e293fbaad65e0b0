// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/pairs/lane_loop.hpp"
#include "anvil/terms/coefficients.hpp"
#include "anvil/terms/hllc_star.hpp"
#include "anvil/terms/momentum_loop.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

/// A particle or its neighbours in the loop: what their records hold.
template <int D, class L>
struct HllcRecords {
  L motion[PairRecords<D>::small], traction[PairRecords<D>::large], response[8], slope[SlopeField<D>::size];
};

/// Components along n of the velocity and the stress of one side, and their differences over a distance along n.
template <class L>
struct AlongPair {
  L velocity, stress;
};

template <int D, class L>
ANVIL_INLINE AlongPair<L> state_along(const HllcRecords<D, L>& from, const L* n) {
  AlongPair<L> along{L(0.0), L(0.0)};
  for (int a = 0; a < D; ++a) {
    along.velocity += from.motion[a] * n[a];
    for (int b = 0; b < D; ++b) along.stress += from.traction[packed_index<D>(a, b)] * n[a] * n[b];
  }
  return along;
}

/// The slope of the stress along n is that of a plane wave in this direction: n . div sigma.
template <int D, class L>
ANVIL_INLINE AlongPair<L> slope_along(const HllcRecords<D, L>& from, const L* n) {
  AlongPair<L> along{L(0.0), L(0.0)};
  for (int a = 0; a < D; ++a) {
    along.stress += from.slope[SlopeField<D>::stress + a] * n[a];
    for (int b = 0; b < D; ++b) along.velocity += from.slope[a * D + b] * n[a] * n[b];
  }
  return along;
}

/// Changes from either side to the middle of a pair.
template <class L>
struct HalfChanges {
  L left, right;
};

/// The third-order limiter of Koren (1993) between the change behind, which the slope implies, and that to the partner.
template <class L>
ANVIL_INLINE L koren(const L& behind, const L& ahead) {
  const L sign = select(ahead < L(0.0), L(-1.0), L(1.0)), size = sign * ahead, back = sign * behind;
  return sign * max(L(0.0), min(L(2.0) * min(size, back), L(1.0 / 3.0) * (L(2.0) * size + back)));
}

/// Half of the change to the partner as two limiters see it, in the mean: that of van Albada, van Leer and Roberts
/// (1982) and Koren's. Zero at an extremum. docs/riemann.md compares limiters.
template <class L>
ANVIL_INLINE HalfChanges<L> limited_halves(const L& left_change, const L& right_change, const L& difference) {
  const L left = L(2.0) * left_change - difference, right = L(2.0) * right_change - difference;
  const L square = difference * difference + L(1e-100);
  const L left_squares = left * left + square, right_squares = right * right + square;
  const L quarter = L(0.25) / (left_squares * right_squares);  // one quotient for both
  return {quarter * right_squares * max(left * difference, L(0.0)) * (left + difference) +
              L(0.25) * koren(left, difference),
          quarter * left_squares * max(right * difference, L(0.0)) * (right + difference) +
              L(0.25) * koren(right, difference)};
}

template <int D, class L>
ANVIL_INLINE RiemannSide<L> riemann_side(const HllcRecords<D, L>& from, const AlongPair<L>& own,
                                         const AlongPair<L>& at_middle) {
  return {.velocity = at_middle.velocity,
          .stress = at_middle.stress,
          .deviator = own.stress + from.response[response_pressure],
          .density = from.response[response_density],
          .elastic_speed = from.response[response_elastic_speed],
          .plastic_speed = from.response[response_plastic_speed],
          .inverse_elastic_speed = from.response[response_inverse_elastic_speed],
          .inverse_shear = from.response[response_inverse_shear],
          .limit = from.response[response_limit]};
}

/// What the star state of approaching pairs has beyond the mean of both sides, along n; zero for parting pairs. Parting
/// is judged by the velocities of the particles.
template <int D, bool Reconstructs, class L, class Mask>
ANVIL_INLINE AlongPair<L> star_excess(const HllcRecords<D, L>& own, const HllcRecords<D, L>& other, const L* n,
                                      const L& distance, const Mask& approaching) {
  const AlongPair<L> left = state_along<D>(own, n), right = state_along<D>(other, n);
  AlongPair<L> left_middle = left, right_middle = right;
  if constexpr (Reconstructs) {
    const AlongPair<L> left_slope = slope_along<D>(own, n), right_slope = slope_along<D>(other, n);
    const L rise = right.velocity - left.velocity, pull = right.stress - left.stress;
    const L bodies = own.slope[SlopeField<D>::body] - other.slope[SlopeField<D>::body];
    const auto same = bodies * bodies < L(0.25);
    const L length = select(same, distance, L(0.0)), one = select(same, L(1.0), L(0.0));
    const HalfChanges<L> rises = limited_halves(left_slope.velocity * length, right_slope.velocity * length, rise);
    const HalfChanges<L> pulls = limited_halves(left_slope.stress * length, right_slope.stress * length, pull);
    left_middle.velocity += one * rises.left;
    left_middle.stress += one * pulls.left;
    right_middle.velocity -= one * rises.right;
    right_middle.stress -= one * pulls.right;
  }
  const StarState<L> star =
      hllc_star(riemann_side<D>(own, left, left_middle), riemann_side<D>(other, right, right_middle));
  return {select(approaching, star.velocity - L(0.5) * (left.velocity + right.velocity), L(0.0)),
          select(approaching, star.stress - L(0.5) * (left.stress + right.stress), L(0.0))};
}

/// grad -> (L_i + L_j)/2 grad.
template <int D, class L>
ANVIL_INLINE void symmetrise(const PairRecords<D>& records, std::size_t row, const std::int32_t* neighbour, L* grad) {
  L other[PairRecords<D>::large], plain[D];
  load_record(records.correction, neighbour, other);
  for (int a = 0; a < D; ++a) {
    plain[a] = L(0.5) * grad[a];
    grad[a] = L(0.0);
  }
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) {
      const int c = packed_index<D>(a, b);
      grad[a] += (L(records.correction[row][c]) + other[c]) * plain[b];
    }
}

template <int D, bool Reconstructs, bool Symmetrised>
void sum_hllc_of(const PairTile<D>& tile, const PairRecords<D>& records, bool corrected, const HllcSums& sums) {
  using L = Lanes<lanes<D>>;
  const auto& gradient = corrected ? tile.gradient : tile.plain_gradient;
  for_each_row(tile, [&](std::int32_t i, std::int64_t begin, std::int64_t end) ANVIL_INLINE_LAMBDA {
    const auto row = static_cast<std::size_t>(i);
    HllcRecords<D, L> own;
    L place[D];
    for (int a = 0; a < D; ++a) place[a] = L(records.geometry[row][a]);
    for (int f = 0; f < PairRecords<D>::small; ++f) own.motion[f] = L(records.motion[row][f]);
    for (int f = 0; f < PairRecords<D>::large; ++f) own.traction[f] = L(records.traction[row][f]);
    for (int f = 0; f < 8; ++f) own.response[f] = L(records.response[row][f]);
    if constexpr (Reconstructs)
      for (int f = 0; f < SlopeField<D>::size; ++f) own.slope[f] = L(records.slope[row][f]);
    L force[D], work(0.0), star_gradient[D][D];
    for (int a = 0; a < D; ++a) {
      force[a] = L(0.0);
      for (int b = 0; b < D; ++b) star_gradient[a][b] = L(0.0);
    }
    for (std::int64_t k = begin; k < end; k += lanes<D>) {
      const std::int64_t at = k - tile.first[tile.begin];
      if constexpr (lanes<D> == 1 && D == 1)
        if (gradient[0][at] == 0.0) continue;  // out of reach
      HllcRecords<D, L> other;
      L other_place[PairRecords<D>::small];
      load_record(records.geometry, tile.neighbour + k, other_place);
      load_record(records.motion, tile.neighbour + k, other.motion);
      load_record(records.traction, tile.neighbour + k, other.traction);
      L n[D], length_squared(1e-300), closing(0.0);  // n from i to j
      for (int a = 0; a < D; ++a) {
        n[a] = other_place[a] - place[a];
        length_squared += n[a] * n[a];
      }
      const L distance = sqrt(length_squared), inverse = L(1.0) / distance;
      for (int a = 0; a < D; ++a) {
        n[a] = n[a] * inverse;
        closing += (own.motion[a] - other.motion[a]) * n[a];
      }
      L grad[D], along(0.0);
      for (std::size_t a = 0; a < D; ++a) grad[a] = other.motion[D] * L::load(gradient[a] + at);
      if constexpr (Symmetrised) symmetrise<D>(records, row, tile.neighbour + k, grad);
      for (int a = 0; a < D; ++a) along += grad[a] * n[a];
      AlongPair<L> excess{L(0.0), L(0.0)};
      const auto approaching = L(0.0) < closing;
      if (any(approaching)) {
        load_record(records.response, tile.neighbour + k, other.response);
        if constexpr (Reconstructs) load_record(records.slope, tile.neighbour + k, other.slope);
        excess = star_excess<D, Reconstructs>(own, other, n, distance, approaching);
        for (int a = 0; a < D; ++a)
          for (int b = 0; b < D; ++b) star_gradient[a][b] += excess.velocity * n[a] * grad[b];
      }
      for (int a = 0; a < D; ++a) {
        L pull = excess.stress * along * n[a];
        for (int b = 0; b < D; ++b) {
          const int c = packed_index<D>(a, b);
          pull += L(0.5) * (own.traction[c] + other.traction[c]) * grad[b];
        }
        force[a] += pull;
        work += pull * (L(0.5) * (own.motion[a] + other.motion[a]) + excess.velocity * n[a]);
      }
    }
    const int local = i - tile.begin;
    const double scale = 2.0 / records.response[row][response_density];
    sums.power[local] += scale * work.sum();
    for (int a = 0; a < D; ++a) {
      sums.acceleration[local * D + a] += scale * force[a].sum();
      for (int b = 0; b < D; ++b) sums.star_gradient[(local * D + a) * D + b] += 2.0 * star_gradient[a][b].sum();
    }
  });
}

/// Sums over pairs of star states u*_ij, sigma*_ij, with V_j grad_ij:
///   acceleration_i += (2/rho_i) sum_j V_j sigma* . grad_ij
///   power_i        += (2/rho_i) sum_j V_j u* . sigma* . grad_ij
///   star_gradient_i += 2 sum_j V_j (u* - (u_i + u_j)/2) (x) grad_ij
/// For approaching pairs the components of u* and sigma* along the pair come from hllc_star, all others are means.
template <int D>
void sum_hllc(const PairTile<D>& tile, const PairRecords<D>& records, const HllcChoices& choices,
              const HllcSums& sums) {
  const bool corrected = choices.gradient == PairGradient::corrected;
  if (choices.gradient == PairGradient::symmetrised && choices.reconstructs)
    sum_hllc_of<D, true, true>(tile, records, corrected, sums);
  else if (choices.gradient == PairGradient::symmetrised)
    sum_hllc_of<D, false, true>(tile, records, corrected, sums);
  else if (choices.reconstructs)
    sum_hllc_of<D, true, false>(tile, records, corrected, sums);
  else
    sum_hllc_of<D, false, false>(tile, records, corrected, sums);
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
