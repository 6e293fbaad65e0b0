// SPDX-License-Identifier: BSD-3-Clause
// Compiled once per instruction set, as the pair loops of the library are.
#include "benchmarks/pair_layouts_level.hpp"

#include "anvil/kernels/cubic_spline.hpp"
#include "anvil/pairs/lane_loop.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {
namespace {

using L = Lanes<lanes<3>>;

struct Neighbours {
  L position[3], smoothing_length, velocity[3], volume;
};

/// Adds V_j (v_j - v_i) grad_ij for the neighbours in the lanes.
ANVIL_INLINE void add_pairs(const Neighbours& own, const Neighbours& other, L sum[9]) {
  L x_ij[3], r_squared(0.0);
  for (int a = 0; a < 3; ++a) {
    x_ij[a] = own.position[a] - other.position[a];
    r_squared += x_ij[a] * x_ij[a];
  }
  const L h_inverse = L(2.0) / (own.smoothing_length + other.smoothing_length);
  const L h_inverse_squared = h_inverse * h_inverse;
  const L factor = L(CubicSpline::normalisation(3)) * h_inverse_squared * h_inverse_squared * h_inverse *
                   CubicSpline::slope_over_q(sqrt(r_squared) * h_inverse) * other.volume;
  for (int a = 0; a < 3; ++a) {
    const L difference = factor * (other.velocity[a] - own.velocity[a]);
    for (int b = 0; b < 3; ++b) sum[3 * a + b] += difference * x_ij[b];
  }
}

/// fetch(index) loads the neighbours whose numbers stand at `index`; broadcast(i) puts particle i into all lanes.
template <class Fetch, class Broadcast>
ANVIL_INLINE void sum_rows(const Rows& rows, double* out, Fetch&& fetch, Broadcast&& broadcast) {
  for (std::int32_t i = 0; i < rows.particles; ++i) {
    const Neighbours own = broadcast(static_cast<std::size_t>(i));
    L sum[9];
    for (L& component : sum) component = L(0.0);
    for (std::int64_t k = rows.first[i]; k < rows.first[i + 1]; k += lanes<3>)
      add_pairs(own, fetch(rows.neighbour + k), sum);
    for (const L& component : sum) *out++ = component.sum();
  }
}

void sum_by_gathers(const Rows& rows, const Arrays& arrays, double* out) {
  const auto fetch = [&](const std::int32_t* index) ANVIL_INLINE_LAMBDA {
    const hn::Rebind<std::int64_t, L::Tag> wide;
    const hn::Rebind<std::int32_t, L::Tag> narrow;
    const auto at = hn::PromoteTo(wide, hn::LoadU(narrow, index));
    const auto gather = [&](const double* field)
                            ANVIL_INLINE_LAMBDA { return L(hn::GatherIndex(L::Tag(), field, at)); };
    return Neighbours{{gather(arrays.x), gather(arrays.y), gather(arrays.z)},
                      gather(arrays.smoothing_length),
                      {gather(arrays.velocity_x), gather(arrays.velocity_y), gather(arrays.velocity_z)},
                      gather(arrays.volume)};
  };
  const auto broadcast = [&](std::size_t i) ANVIL_INLINE_LAMBDA {
    return Neighbours{{L(arrays.x[i]), L(arrays.y[i]), L(arrays.z[i])},
                      L(arrays.smoothing_length[i]),
                      {L(arrays.velocity_x[i]), L(arrays.velocity_y[i]), L(arrays.velocity_z[i])},
                      L(arrays.volume[i])};
  };
  sum_rows(rows, out, fetch, broadcast);
}

void sum_packed(const Rows& rows, const WideRecords& records, double* out) {
  const auto unpack = [](const L* field) ANVIL_INLINE_LAMBDA {
    return Neighbours{{field[0], field[1], field[2]}, field[3], {field[4], field[5], field[6]}, field[7]};
  };
  const auto fetch = [&](const std::int32_t* index) ANVIL_INLINE_LAMBDA {
    L field[WideRecords::size];
    load_record(records, index, field);
    return unpack(field);
  };
  const auto broadcast = [&](std::size_t i) ANVIL_INLINE_LAMBDA {
    L field[WideRecords::size];
    for (int f = 0; f < WideRecords::size; ++f) field[f] = L(records[i][f]);
    return unpack(field);
  };
  sum_rows(rows, out, fetch, broadcast);
}

}  // namespace

extern constinit const VectorLayouts vector_layouts{&sum_by_gathers, &sum_packed};

}  // namespace anvil::ANVIL_SIMD_LEVEL
