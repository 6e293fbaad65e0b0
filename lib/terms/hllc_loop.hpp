// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "anvil/pairs/lane_loop.hpp"
#include "anvil/terms/coefficients.hpp"
#include "anvil/terms/hllc_star.hpp"
#include "anvil/terms/momentum_loop.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

/// A particle or its neighbours in a Riemann problem: what their records hold.
template <int D, class L>
struct HllcRecords {
  L motion[PairRecords<D>::small], traction[PairRecords<D>::large], response[8], slope[SlopeField<D>::size];
};

/// Pairs of one particle that approach, side by side: their Riemann problems fill whole vectors. Not worth the while in
/// one dimension, where a particle has a vector of neighbours or two.
template <int D>
struct ApproachingPairs {
  static constexpr int capacity = 64;
  static constexpr int size = capacity + lanes<D>;  // whole vectors are written
  int count = 0;
  std::int32_t neighbour[size];
  alignas(64) double separation[D][size], gradient[D][size];  // x_j - x_i, m; V_j grad_ij, 1/m

  template <class L, class Mask>
  ANVIL_INLINE void add(const std::int32_t* neighbours, const L* x_ji, const L* grad, const Mask& mask) {
    for (int a = 0; a < D; ++a) {
      compress(x_ji[a], mask, separation[a] + count);
      compress(grad[a], mask, gradient[a] + count);
    }
    count += compress(neighbours, mask, neighbour + count);
  }

  /// Fills the last vector with pairs that weigh nothing.
  ANVIL_INLINE void pad(std::int32_t with) {
    for (int k = count; k < count + lanes<D> - 1; ++k) {
      neighbour[k] = with;
      for (int a = 0; a < D; ++a) {
        separation[a][k] = 1.0;
        gradient[a][k] = 0.0;
      }
    }
  }
};

/// n . t . n of a symmetric tensor and the vector t . n.
template <int D, class L>
ANVIL_INLINE void apply_packed(const L* tensor, const L* n, L* out) {
  for (int a = 0; a < D; ++a) {
    out[a] = tensor[packed_index<D>(a, 0)] * n[0];
    for (int b = 1; b < D; ++b) out[a] += tensor[packed_index<D>(a, b)] * n[b];
  }
}

template <int D, class L>
ANVIL_INLINE L dot(const L* a, const L* b) {
  L sum = a[0] * b[0];
  for (int c = 1; c < D; ++c) sum += a[c] * b[c];
  return sum;
}

/// Components along n of a velocity and a stress.
template <class L>
struct AlongPair {
  L velocity, stress;
};

/// Slopes along n. That of the stress is a plane wave's in this direction: n . div sigma.
template <int D, class L>
ANVIL_INLINE AlongPair<L> slope_along(const HllcRecords<D, L>& from, const L* n) {
  L gradient[D];
  for (int a = 0; a < D; ++a) gradient[a] = dot<D>(from.slope + a * D, n);
  return {dot<D>(gradient, n), dot<D>(from.slope + SlopeField<D>::stress, n)};
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
ANVIL_INLINE RiemannSide<L> riemann_side(const HllcRecords<D, L>& from, const AlongPair<L>& state, const L& stress) {
  return {.velocity = state.velocity,
          .stress = state.stress,
          .deviator = stress + from.response[response_pressure],
          .density = from.response[response_density],
          .elastic_speed = from.response[response_elastic_speed],
          .plastic_speed = from.response[response_plastic_speed],
          .inverse_elastic_speed = from.response[response_inverse_elastic_speed],
          .inverse_shear = from.response[response_inverse_shear],
          .limit = from.response[response_limit]};
}

/// What the star state of a pair has beyond the mean of both sides, along n. `jump`: right side less left one;
/// stresses: of either side along n.
template <int D, bool Reconstructs, class L>
ANVIL_INLINE AlongPair<L> star_excess(const HllcRecords<D, L>& own, const HllcRecords<D, L>& other, const L* n,
                                      const L& distance, const AlongPair<L>& jump, const L& left_stress,
                                      const L& right_stress) {
  AlongPair<L> left{L(-0.5) * jump.velocity, L(-0.5) * jump.stress};  // from the mean
  AlongPair<L> right{L(0.5) * jump.velocity, L(0.5) * jump.stress};
  if constexpr (Reconstructs) {
    const AlongPair<L> left_slope = slope_along<D>(own, n), right_slope = slope_along<D>(other, n);
    const L bodies = own.slope[SlopeField<D>::body] - other.slope[SlopeField<D>::body];
    const L one = select(bodies * bodies < L(0.25), L(1.0), L(0.0));
    const HalfChanges<L> rises =
        limited_halves(left_slope.velocity * distance, right_slope.velocity * distance, jump.velocity);
    const HalfChanges<L> pulls =
        limited_halves(left_slope.stress * distance, right_slope.stress * distance, jump.stress);
    left.velocity += one * rises.left;
    left.stress += one * pulls.left;
    right.velocity -= one * rises.right;
    right.stress -= one * pulls.right;
  }
  const StarState<L> star =
      hllc_star(riemann_side<D>(own, left, left_stress), riemann_side<D>(other, right, right_stress));
  return {star.velocity, star.stress};
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

/// Sums of one particle.
template <int D, class L>
struct HllcRow {
  L force[D], work, star_gradient[D][D];
};

/// Adds what the star states of pairs have beyond the means of both sides. `x_ji`: x_j - x_i; grad: V_j grad_ij.
template <int D, bool Reconstructs, class L>
ANVIL_INLINE void add_excess(const HllcRecords<D, L>& own, const HllcRecords<D, L>& other, const L* x_ji, const L* grad,
                             HllcRow<D, L>& sums) {
  L n[D], distance;
  if constexpr (D == 1) {
    distance = max(x_ji[0], -x_ji[0]);
    n[0] = select(x_ji[0] < L(0.0), L(-1.0), L(1.0));
  } else {
    distance = sqrt(dot<D>(x_ji, x_ji));
    const L inverse = L(1.0) / distance;
    for (int a = 0; a < D; ++a) n[a] = x_ji[a] * inverse;
  }
  L left_pull[D], right_pull[D], twice_mean[D], difference[D];
  apply_packed<D>(own.traction, n, left_pull);
  apply_packed<D>(other.traction, n, right_pull);
  for (int a = 0; a < D; ++a) {
    twice_mean[a] = own.motion[a] + other.motion[a];
    difference[a] = other.motion[a] - own.motion[a];
  }
  const L left_stress = dot<D>(left_pull, n), right_stress = dot<D>(right_pull, n);
  const AlongPair<L> jump{dot<D>(difference, n), right_stress - left_stress};
  const AlongPair<L> excess = star_excess<D, Reconstructs>(own, other, n, distance, jump, left_stress, right_stress);
  const L pull = excess.stress * dot<D>(grad, n);
  L mean_pull(0.0);
  for (int a = 0; a < D; ++a) {
    sums.force[a] += pull * n[a];
    mean_pull += (left_pull[a] + right_pull[a]) * grad[a];
    const L along = excess.velocity * n[a];
    for (int b = 0; b < D; ++b) sums.star_gradient[a][b] += along * grad[b];
  }
  sums.work += pull * (L(0.5) * dot<D>(twice_mean, n) + excess.velocity) + L(0.5) * mean_pull * excess.velocity;
}

template <int D, bool Reconstructs, class L>
ANVIL_INLINE void load_rest(const PairRecords<D>& records, const std::int32_t* neighbour, HllcRecords<D, L>& out) {
  load_record(records.response, neighbour, out.response);
  if constexpr (Reconstructs) load_record(records.slope, neighbour, out.slope);
}

template <int D, bool Reconstructs, class L>
ANVIL_INLINE void add_excesses(const PairRecords<D>& records, const ApproachingPairs<D>& pairs,
                               const HllcRecords<D, L>& own, HllcRow<D, L>& sums) {
  for (int k = 0; k < pairs.count; k += lanes<D>) {
    HllcRecords<D, L> other;
    load_record(records.motion, pairs.neighbour + k, other.motion);
    load_record(records.traction, pairs.neighbour + k, other.traction);
    load_rest<D, Reconstructs>(records, pairs.neighbour + k, other);
    L x_ji[D], grad[D];
    for (int a = 0; a < D; ++a) {
      x_ji[a] = L::load(pairs.separation[a] + k);
      grad[a] = L::load(pairs.gradient[a] + k);
    }
    add_excess<D, Reconstructs>(own, other, x_ji, grad, sums);
  }
}

template <int D, bool Reconstructs, bool Symmetrised>
void sum_hllc_of(const PairTile<D>& tile, const PairRecords<D>& records, bool corrected, const HllcSums& sums) {
  using L = Lanes<lanes<D>>;
  const auto& gradient = corrected ? tile.gradient : tile.plain_gradient;
  const auto padding = static_cast<std::int32_t>(records.first_image() - 1);
  ApproachingPairs<D> approaching;
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
    HllcRow<D, L> total;
    total.work = L(0.0);
    for (int a = 0; a < D; ++a) {
      total.force[a] = L(0.0);
      for (int b = 0; b < D; ++b) total.star_gradient[a][b] = L(0.0);
    }
    for (std::int64_t chunk = begin; chunk < end; chunk += ApproachingPairs<D>::capacity) {
      approaching.count = 0;
      const std::int64_t chunk_end = std::min<std::int64_t>(end, chunk + ApproachingPairs<D>::capacity);
      for (std::int64_t k = chunk; k < chunk_end; k += lanes<D>) {
        const std::int64_t at = k - tile.first[tile.begin];
        HllcRecords<D, L> other;
        L other_place[PairRecords<D>::small];
        load_record(records.geometry, tile.neighbour + k, other_place);
        load_record(records.motion, tile.neighbour + k, other.motion);
        load_record(records.traction, tile.neighbour + k, other.traction);
        L grad[D], x_ji[D], mean[D], pull[D], tensor[symmetric_components<D>], closing(0.0);
        for (std::size_t a = 0; a < D; ++a) grad[a] = other.motion[D] * L::load(gradient[a] + at);
        if constexpr (Symmetrised) symmetrise<D>(records, row, tile.neighbour + k, grad);
        for (int c = 0; c < symmetric_components<D>; ++c) tensor[c] = L(0.5) * (own.traction[c] + other.traction[c]);
        for (int a = 0; a < D; ++a) {
          x_ji[a] = other_place[a] - place[a];
          closing += (own.motion[a] - other.motion[a]) * x_ji[a];
          mean[a] = L(0.5) * (own.motion[a] + other.motion[a]);
        }
        apply_packed<D>(tensor, grad, pull);
        for (int a = 0; a < D; ++a) total.force[a] += pull[a];
        total.work += dot<D>(pull, mean);
        const auto meets = L(0.0) < min(closing, dot<D>(grad, grad));  // approaches, and in reach
        if (!any(meets)) continue;
        if constexpr (D == 1) {
          load_rest<D, Reconstructs>(records, tile.neighbour + k, other);
          grad[0] = select(meets, grad[0], L(0.0));
          add_excess<D, Reconstructs>(own, other, x_ji, grad, total);
        } else {
          approaching.add(tile.neighbour + k, x_ji, grad, meets);
        }
      }
      if (approaching.count == 0) continue;
      approaching.pad(padding);
      add_excesses<D, Reconstructs>(records, approaching, own, total);
    }
    const int local = i - tile.begin;
    const double scale = 2.0 / records.response[row][response_density];
    sums.power[local] += scale * total.work.sum();
    for (int a = 0; a < D; ++a) {
      sums.acceleration[local * D + a] += scale * total.force[a].sum();
      for (int b = 0; b < D; ++b) sums.star_gradient[(local * D + a) * D + b] += 2.0 * total.star_gradient[a][b].sum();
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
