// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>

#include "anvil/pairs/correction_loop.hpp"
#include "anvil/pairs/gradient_loop.hpp"
#include "anvil/pairs/line_runs.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

// Along a line rows are one vector long and the correction of gradients is a number: passes that are apart in two and
// three dimensions are one here, and gradients need not go through memory in between.

/// A_i^-1, or 1 where the gradients of a particle cannot be corrected; those are counted in `kept`.
ANVIL_INLINE double invert_line_moment(double moment, int& kept) {
  double inverse = 1.0;
  if (!invert_moment<1>(&moment, &inverse)) ++kept;
  return inverse;
}

/// What a run sees of its n-th neighbours: x_ij, their motion, and the gradient.
template <class Kernel, int N>
struct RunPairs {
  Lanes<N> x_ij, motion[2], gradient;
  ANVIL_INLINE RunPairs(const double* geometry, const double* motions, const Lanes<N> own[2], std::ptrdiff_t step) {
    Lanes<N> place[2];
    load_run(geometry + 2 * step, place);
    load_run(motions + 2 * step, motion);
    x_ij = own[0] - place[0];
    gradient = line_gradient<Kernel>(x_ij, Lanes<N>(2.0) / (own[1] + place[1]));
  }
};

template <int N>
ANVIL_INLINE Lanes<N> invert_run_moments(Lanes<N> moment, int& kept) {
  const auto sound = Lanes<N>(least_moment) < moment;
  kept += run_length - std::popcount(sound.bits());
  return select(sound, Lanes<N>(1.0) / moment, Lanes<N>(1.0));
}

/// fill_pairs and correct_gradients in one.
template <class Kernel>
int fill_corrected_line(const PairTile<1>& opened, const PairRecords<1>& records) {
  using L = Lanes<lanes<1>>;
  const PairTile<1> tile = opened;  // these stay in registers while the loop writes
  const auto geometry = records.geometry.rows();
  const auto motion = records.motion.rows();
  double *plain = tile.plain_gradient[0], *corrected = tile.gradient[0];
  const std::int64_t first = tile.first[tile.begin];
  int kept = 0;
  const auto run = [&](auto i, std::int64_t begin) ANVIL_INLINE_LAMBDA {
    const double *places = geometry[static_cast<std::size_t>(i)], *motions = motion[static_cast<std::size_t>(i)];
    L own[2], gradient[run_length], sum(0.0);
    load_run(places, own);
    for (int n = 0; n < run_length; ++n) {
      const RunPairs<Kernel, lanes<1>> pairs(places, motions, own, run_steps[n]);
      gradient[n] = pairs.gradient;
      sum -= pairs.x_ij * (pairs.motion[1] * pairs.gradient);
    }
    if (plain != corrected) store_rows(gradient, plain + (begin - first));
    const L inverse = invert_run_moments(sum, kept);
    if (tile.correction != nullptr) store_run(inverse, tile.correction + (i - tile.begin));
    for (auto& one : gradient) one = inverse * one;
    store_rows(gradient, corrected + (begin - first));
  };
  const auto row = [&](std::int32_t i, std::int64_t begin, std::int64_t end) ANVIL_INLINE_LAMBDA {
    const double* own = geometry[static_cast<std::size_t>(i)];
    L sum(0.0), gradient(0.0);
    for (std::int64_t k = begin; k < end; k += lanes<1>) {
      L place[2], other[2];
      load_record(geometry, tile.neighbour + k, place);
      load_record(motion, tile.neighbour + k, other);
      const L x_ij = L(own[0]) - place[0];
      gradient = line_gradient<Kernel>(x_ij, L(2.0) / (L(own[1]) + place[1]));
      sum -= x_ij * (other[1] * gradient);
      gradient.store(plain + (k - first));
    }
    const double inverse = invert_line_moment(sum.sum(), kept);
    if (tile.correction != nullptr) tile.correction[i - tile.begin] = inverse;
    if (begin == end) return;
    (L(inverse) * gradient).store(corrected + (end - lanes<1> - first));  // the last ones need not be read again
    for (std::int64_t k = begin - first; k < end - lanes<1> - first; k += lanes<1>)
      (L(inverse) * L::load(plain + k)).store(corrected + k);
  };
  for_each_run_or_row(tile, run, row);
  return kept;
}

/// dv/dx with corrected gradients, 1/s per particle of the tile: what fill_pairs, correct_gradients and
/// sum_velocity_gradient give, without the gradients.
template <class Kernel>
int sum_line_velocity_gradient(const PairTile<1>& opened, const PairRecords<1>& records, double* out) {
  using L = Lanes<lanes<1>>;
  const PairTile<1> tile = opened;
  const auto geometry = records.geometry.rows();
  const auto motion = records.motion.rows();
  int kept = 0;
  const auto run = [&](auto i, std::int64_t /*begin*/) ANVIL_INLINE_LAMBDA {
    const double *places = geometry[static_cast<std::size_t>(i)], *motions = motion[static_cast<std::size_t>(i)];
    L own[2], moving[2], moment(0.0), sum(0.0);
    load_run(places, own);
    load_run(motions, moving);
    for (int n = 0; n < run_length; ++n) {
      const RunPairs<Kernel, lanes<1>> pairs(places, motions, own, run_steps[n]);
      const L weighted = pairs.motion[1] * pairs.gradient;
      moment -= pairs.x_ij * weighted;
      sum += (pairs.motion[0] - moving[0]) * weighted;
    }
    store_run(invert_run_moments(moment, kept) * sum, out + (i - tile.begin));
  };
  const auto row = [&](std::int32_t i, std::int64_t begin, std::int64_t end) ANVIL_INLINE_LAMBDA {
    const double* own = geometry[static_cast<std::size_t>(i)];
    const double* moving = motion[static_cast<std::size_t>(i)];
    L moment(0.0), sum(0.0);
    for (std::int64_t k = begin; k < end; k += lanes<1>) {
      L place[2], other[2];
      load_record(geometry, tile.neighbour + k, place);
      load_record(motion, tile.neighbour + k, other);
      const L x_ij = L(own[0]) - place[0];
      const L weighted = other[1] * line_gradient<Kernel>(x_ij, L(2.0) / (L(own[1]) + place[1]));
      moment -= x_ij * weighted;
      sum += (other[0] - L(moving[0])) * weighted;
    }
    out[i - tile.begin] = invert_line_moment(moment.sum(), kept) * sum.sum();
  };
  for_each_run_or_row(tile, run, row);
  return kept;
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
