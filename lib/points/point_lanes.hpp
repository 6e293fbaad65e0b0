// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/pairs/lane_loop.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

/// Lanes of the loops over points: eight tensors at once would not fit into the registers.
inline constexpr int point_lanes = widest > 4 ? 4 : widest;
using PointLanes = Lanes<point_lanes>;

/// The points in the lanes. Where fewer are left than there are lanes, the others repeat the last one: what is read and
/// written by number is then the same as with every lane of its own.
struct Batch {
  std::int32_t point[point_lanes];
  bool full;

  ANVIL_INLINE Batch(std::int32_t begin, std::int32_t end) : full(end - begin >= point_lanes) {
    for (int lane = 0; lane < point_lanes; ++lane) point[lane] = begin + lane < end ? begin + lane : end - 1;
  }
};

/// Calls work(batch, how many of its lanes count) for the points begin .. end-1.
template <class Work>
ANVIL_INLINE void for_each_batch(std::int32_t begin, std::int32_t end, Work&& work) {
  for (std::int32_t i = begin; i < end; i += point_lanes)
    work(Batch(i, end), end - i < point_lanes ? end - i : point_lanes);
}

/// One number per point.
ANVIL_INLINE PointLanes load_each(const double* values, const std::int32_t* point) {
  double lanes[point_lanes];
  for (int lane = 0; lane < point_lanes; ++lane) lanes[lane] = values[point[lane]];
  return PointLanes::load(lanes);
}
ANVIL_INLINE PointLanes load_each(const double* values, const Batch& batch) {
  return batch.full ? PointLanes::load(values + batch.point[0]) : load_each(values, batch.point);
}
ANVIL_INLINE void store_each(PointLanes lanes, double* values, const Batch& batch) {
  if (batch.full) return lanes.store(values + batch.point[0]);
  double each[point_lanes];
  lanes.store(each);
  for (int lane = 0; lane < point_lanes; ++lane) values[batch.point[lane]] = each[lane];
}

/// Rows into columns: out[f] holds row[l][f] in lane l. Its own inverse.
ANVIL_INLINE void transpose([[maybe_unused]] const PointLanes row[4], [[maybe_unused]] PointLanes out[4]) {
#if HWY_TARGET != HWY_SCALAR
  if constexpr (point_lanes == 4) {
    const PointLanes::Tag tag;
    const auto ac01 = hn::InterleaveLower(tag, row[0].v, row[1].v), bd01 = hn::InterleaveUpper(tag, row[0].v, row[1].v);
    const auto ac23 = hn::InterleaveLower(tag, row[2].v, row[3].v), bd23 = hn::InterleaveUpper(tag, row[2].v, row[3].v);
    out[0].v = hn::ConcatLowerLower(tag, ac23, ac01);
    out[1].v = hn::ConcatLowerLower(tag, bd23, bd01);
    out[2].v = hn::ConcatUpperUpper(tag, ac23, ac01);
    out[3].v = hn::ConcatUpperUpper(tag, bd23, bd01);
  }
#endif
}

/// The first Fields numbers of a row, up to four, in the first lanes of a vector.
template <int Fields>
ANVIL_INLINE PointLanes load_row(const double* row) {
  if constexpr (Fields >= point_lanes)
    return PointLanes::load(row);
  else
    return PointLanes(hn::MaskedLoad(hn::FirstN(PointLanes::Tag(), Fields), PointLanes::Tag(), row));
}

/// Combines the rows of two sets of points, `stride` numbers each, and puts the first Fields numbers from First on into
/// one vector each: out[f] = combine(a[f], b[f]). combine works lane by lane, so that it may come before the transpose.
template <int Fields, int First = 0, class Combine>
ANVIL_INLINE void load_combined(const double* rows, int stride, const std::int32_t* a, const std::int32_t* b,
                                PointLanes* out, Combine&& combine) {
  if constexpr (point_lanes == 4) {
    constexpr int width = Fields < 4 ? Fields : 4;
    // The last four of a row that is no multiple of four overlap with those before.
    constexpr int from = First + 4 <= Fields || Fields < 4 ? First : Fields - 4;
    PointLanes row[4], column[4];
    for (int lane = 0; lane < 4; ++lane)
      row[lane] = combine(load_row<width>(rows + static_cast<std::ptrdiff_t>(a[lane]) * stride + from),
                          load_row<width>(rows + static_cast<std::ptrdiff_t>(b[lane]) * stride + from));
    transpose(row, column);
    for (int f = 0; f < width; ++f) out[from + f] = column[f];
    if constexpr (First + 4 < Fields) load_combined<Fields, First + 4>(rows, stride, a, b, out, combine);
  } else {
    for (int f = 0; f < Fields; ++f) {
      double left[point_lanes], right[point_lanes];
      for (int lane = 0; lane < point_lanes; ++lane) {
        left[lane] = rows[static_cast<std::ptrdiff_t>(a[lane]) * stride + f];
        right[lane] = rows[static_cast<std::ptrdiff_t>(b[lane]) * stride + f];
      }
      out[f] = combine(PointLanes::load(left), PointLanes::load(right));
    }
  }
}

/// out[f] holds field f of the rows of the points.
template <int Fields>
ANVIL_INLINE void load_fields(const double* rows, int stride, const std::int32_t* point, PointLanes* out) {
  load_combined<Fields>(rows, stride, point, point, out,
                        [](PointLanes one, PointLanes) ANVIL_INLINE_LAMBDA { return one; });
}

/// The other way round.
template <int Fields>
ANVIL_INLINE void store_fields(const PointLanes* fields, double* rows, int stride, const std::int32_t* point) {
  constexpr int in_fours = point_lanes == 4 && Fields >= 4 ? Fields : 0;
  for (int first = 0; first < in_fours; first += 4) {
    const int from = first + 4 <= Fields ? first : Fields - 4;
    PointLanes row[4];
    transpose(fields + from, row);
    for (int lane = 0; lane < 4; ++lane)
      row[lane].store(rows + static_cast<std::ptrdiff_t>(point[lane]) * stride + from);
  }
  for (int f = in_fours; f < Fields; ++f) {
    double each[point_lanes];
    fields[f].store(each);
    for (int lane = 0; lane < point_lanes; ++lane)
      rows[static_cast<std::ptrdiff_t>(point[lane]) * stride + f] = each[lane];
  }
}

/// cof F = det F F^-T, see cofactor of deformation.hpp.
template <int D>
ANVIL_INLINE void find_cofactor(const PointLanes* f, PointLanes* c) {
  if constexpr (D == 1) {
    c[0] = PointLanes(1.0);
  } else if constexpr (D == 2) {
    c[0] = f[3];
    c[1] = -f[2];
    c[2] = -f[1];
    c[3] = f[0];
  } else {
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        const int a1 = 3 * ((a + 1) % 3), a2 = 3 * ((a + 2) % 3), b1 = (b + 1) % 3, b2 = (b + 2) % 3;
        c[3 * a + b] = f[a1 + b1] * f[a2 + b2] - f[a1 + b2] * f[a2 + b1];
      }
  }
}

/// det F, from its cofactor.
template <int D>
ANVIL_INLINE PointLanes find_determinant(const PointLanes* f, const PointLanes* c) {
  PointLanes sum = f[0] * c[0];
  for (int b = 1; b < D; ++b) sum += f[b] * c[b];
  return sum;
}

/// a b, D x D; `out` is different memory.
template <int D>
ANVIL_INLINE void multiply(const PointLanes* a, const PointLanes* b, PointLanes* out) {
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      PointLanes sum = a[i * D] * b[j];
      for (int k = 1; k < D; ++k) sum += a[i * D + k] * b[k * D + j];
      out[i * D + j] = sum;
    }
}

/// a b^T.
template <int D>
ANVIL_INLINE void multiply_transposed(const PointLanes* a, const PointLanes* b, PointLanes* out) {
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      PointLanes sum = a[i * D] * b[j * D];
      for (int k = 1; k < D; ++k) sum += a[i * D + k] * b[j * D + k];
      out[i * D + j] = sum;
    }
}

/// Components of a packed symmetric tensor as stored, XX | XX YY XY | XX YY ZZ XY YZ XZ.
template <int D>
inline constexpr int packed_size = D == 1 ? 1 : (D == 2 ? 3 : 6);

/// D x D from a packed one.
template <int D>
ANVIL_INLINE void unpack_symmetric(const PointLanes* packed, PointLanes* full) {
  constexpr int row[] = {0, 1, D == 2 ? 0 : 2, 0, 1, 0}, column[] = {0, 1, D == 2 ? 1 : 2, 1, 2, 2};
  for (int c = 0; c < packed_size<D>; ++c) full[row[c] * D + column[c]] = full[column[c] * D + row[c]] = packed[c];
}

template <int D>
ANVIL_INLINE void pack_symmetric(const PointLanes* full, PointLanes* packed) {
  constexpr int row[] = {0, 1, D == 2 ? 0 : 2, 0, 1, 0}, column[] = {0, 1, D == 2 ? 1 : 2, 1, 2, 2};
  for (int c = 0; c < packed_size<D>; ++c) packed[c] = full[row[c] * D + column[c]];
}

}  // namespace anvil::ANVIL_SIMD_LEVEL
