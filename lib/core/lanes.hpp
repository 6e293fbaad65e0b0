// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Included only by the pair loops, which are compiled once per instruction set (ANVIL_SIMD_LEVEL names it); everything
// here lives in the namespace of that level, so that no two levels ever share a function.

// Highway asks for AES before it believes in AVX2; no pair loop encrypts anything.
#ifndef HWY_DISABLE_PCLMUL_AES
#define HWY_DISABLE_PCLMUL_AES
#endif
#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "anvil/core/inline.hpp"
#include "anvil/core/lane_math.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {

namespace hn = hwy::HWY_NAMESPACE;

/// Lanes of the widest vector of this level.
inline constexpr int widest = static_cast<int>(HWY_LANES(double));

template <int N>
struct LaneMask;

/// N doubles worked on at once. Arithmetic is lane by lane; a plain double stands for N equal lanes.
template <int N>
struct Lanes {
  using Tag = hn::CappedTag<double, N>;
  using Vector = hn::Vec<Tag>;
  Vector v;

  Lanes() = default;
  ANVIL_INLINE Lanes(double x) : v(hn::Set(Tag(), x)) {}  // NOLINT(google-explicit-constructor): formulas mix both
  ANVIL_INLINE explicit Lanes(Vector x) : v(x) {}

  ANVIL_INLINE static Lanes load(const double* p) { return Lanes(hn::LoadU(Tag(), p)); }
  ANVIL_INLINE void store(double* p) const { hn::StoreU(v, Tag(), p); }
  [[nodiscard]] ANVIL_INLINE double first() const { return hn::GetLane(v); }
  [[nodiscard]] ANVIL_INLINE double sum() const { return hn::GetLane(hn::SumOfLanes(Tag(), v)); }

  friend ANVIL_INLINE Lanes operator+(Lanes a, Lanes b) { return Lanes(hn::Add(a.v, b.v)); }
  friend ANVIL_INLINE Lanes operator-(Lanes a, Lanes b) { return Lanes(hn::Sub(a.v, b.v)); }
  friend ANVIL_INLINE Lanes operator*(Lanes a, Lanes b) { return Lanes(hn::Mul(a.v, b.v)); }
  friend ANVIL_INLINE Lanes operator/(Lanes a, Lanes b) { return Lanes(hn::Div(a.v, b.v)); }
  friend ANVIL_INLINE Lanes operator-(Lanes a) { return Lanes(hn::Neg(a.v)); }
  friend ANVIL_INLINE Lanes& operator+=(Lanes& a, Lanes b) { return a = a + b; }
  friend ANVIL_INLINE Lanes& operator-=(Lanes& a, Lanes b) { return a = a - b; }
  friend ANVIL_INLINE Lanes max(Lanes a, Lanes b) { return Lanes(hn::Max(a.v, b.v)); }
  friend ANVIL_INLINE Lanes min(Lanes a, Lanes b) { return Lanes(hn::Min(a.v, b.v)); }
  friend ANVIL_INLINE Lanes sqrt(Lanes a) { return Lanes(hn::Sqrt(a.v)); }
  friend ANVIL_INLINE Lanes exp(Lanes a) { return Lanes(hn::Exp(Tag(), a.v)); }
  friend ANVIL_INLINE LaneMask<N> operator<(Lanes a, Lanes b) { return LaneMask<N>{hn::Lt(a.v, b.v)}; }
  friend ANVIL_INLINE Lanes select(LaneMask<N> mask, Lanes yes, Lanes no) {
    return Lanes(hn::IfThenElse(mask.m, yes.v, no.v));
  }
};

template <int N>
struct LaneMask {
  hn::Mask<typename Lanes<N>::Tag> m;
  /// Bit l is set where lane l holds.
  [[nodiscard]] ANVIL_INLINE std::uint32_t bits() const {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(typename Lanes<N>::Tag(), m, bytes);
    return bytes[0];
  }
};

template <int N>
ANVIL_INLINE bool any(LaneMask<N> mask) {
  return !hn::AllFalse(typename Lanes<N>::Tag(), mask.m);
}

#if HWY_TARGET == HWY_AVX2
/// Halves of the lanes to take for each mask of four. Highway's own compress copies such a table at every call.
alignas(32) inline constexpr auto compressed_halves = [] {
  std::array<std::array<std::uint32_t, 8>, 16> halves{};
  for (std::uint32_t mask = 0; mask < 16; ++mask)
    for (std::uint32_t lane = 0, next = 0; lane < 4; ++lane)
      if ((mask >> lane & 1U) != 0) {
        halves[mask][next++] = 2 * lane;
        halves[mask][next++] = 2 * lane + 1;
      }
  return halves;
}();
#endif

/// Writes the lanes where the mask holds side by side. `out` has room for all of them.
template <int N>
ANVIL_INLINE void compress(Lanes<N> values, LaneMask<N> mask, double* out) {
  const typename Lanes<N>::Tag tag;
#if HWY_TARGET == HWY_AVX2
  if constexpr (N == 4) {
    const hn::Repartition<std::uint32_t, typename Lanes<N>::Tag> half;
    const auto indices = hn::SetTableIndices(half, compressed_halves[mask.bits()].data());
    hn::StoreU(hn::BitCast(tag, hn::TableLookupLanes(hn::BitCast(half, values.v), indices)), tag, out);
    return;
  }
#endif
  hn::CompressStore(values.v, mask.m, tag, out);
}

/// The same for a number per lane; returns how many there are.
template <int N>
ANVIL_INLINE int compress(const std::int32_t* numbers, LaneMask<N> mask, std::int32_t* out) {
  const std::uint32_t bits = mask.bits();
  int count = 0;
  for (int lane = 0; lane < N; ++lane) {
    out[count] = numbers[lane];
    count += static_cast<int>(bits >> lane & 1U);
  }
  return count;
}

/// Fields first .. first+3 of the records of N particles, each field in its own vector: out[f] holds field f of record
/// index[l] in lane l. A record is `stride` doubles long.
template <int N>
ANVIL_INLINE void load_four_fields(const double* records, int stride, const std::int32_t* index, Lanes<N> out[4]) {
  const auto at = [&](int lane) { return records + static_cast<std::ptrdiff_t>(index[lane]) * stride; };
  using Tag = typename Lanes<N>::Tag;
  [[maybe_unused]] const Tag tag;
#if HWY_TARGET != HWY_SCALAR  // which knows vectors of one lane only
  if constexpr (N == 8) {
    const hn::Half<Tag> half;
    const auto two = [&](int lane) {
      return hn::Combine(tag, hn::LoadU(half, at(lane + 4)), hn::LoadU(half, at(lane)));
    };
    const auto r0 = two(0), r1 = two(1), r2 = two(2), r3 = two(3);
    const auto ac01 = hn::InterleaveLower(tag, r0, r1), bd01 = hn::InterleaveUpper(tag, r0, r1);
    const auto ac23 = hn::InterleaveLower(tag, r2, r3), bd23 = hn::InterleaveUpper(tag, r2, r3);
    out[0].v = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(ac23), ac01);
    out[1].v = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(bd23), bd01);
    out[2].v = hn::OddEvenBlocks(ac23, hn::SwapAdjacentBlocks(ac01));
    out[3].v = hn::OddEvenBlocks(bd23, hn::SwapAdjacentBlocks(bd01));
  } else if constexpr (N == 4) {
    const auto r0 = hn::LoadU(tag, at(0)), r1 = hn::LoadU(tag, at(1)), r2 = hn::LoadU(tag, at(2)),
               r3 = hn::LoadU(tag, at(3));
    const auto ac01 = hn::InterleaveLower(tag, r0, r1), bd01 = hn::InterleaveUpper(tag, r0, r1);
    const auto ac23 = hn::InterleaveLower(tag, r2, r3), bd23 = hn::InterleaveUpper(tag, r2, r3);
    out[0].v = hn::ConcatLowerLower(tag, ac23, ac01);
    out[1].v = hn::ConcatLowerLower(tag, bd23, bd01);
    out[2].v = hn::ConcatUpperUpper(tag, ac23, ac01);
    out[3].v = hn::ConcatUpperUpper(tag, bd23, bd01);
  } else  // NOLINT(readability-misleading-indentation)
#endif
  {
    double field[N];
    for (int f = 0; f < 4; ++f) {
      for (int lane = 0; lane < N; ++lane) field[lane] = at(lane)[f];
      out[f] = Lanes<N>::load(field);
    }
  }
}

/// The same for records of two fields, and up to four particles.
template <int N>
ANVIL_INLINE void load_two_fields(const double* records, const std::int32_t* index, Lanes<N> out[2]) {
  const auto at = [&](int lane) { return records + static_cast<std::ptrdiff_t>(index[lane]) * 2; };
  using Tag = typename Lanes<N>::Tag;
  [[maybe_unused]] const Tag tag;
#if HWY_TARGET != HWY_SCALAR
  if constexpr (N == 4) {
    const hn::Half<Tag> half;
    const auto r02 = hn::Combine(tag, hn::LoadU(half, at(2)), hn::LoadU(half, at(0)));
    const auto r13 = hn::Combine(tag, hn::LoadU(half, at(3)), hn::LoadU(half, at(1)));
    out[0].v = hn::InterleaveLower(tag, r02, r13);
    out[1].v = hn::InterleaveUpper(tag, r02, r13);
  } else if constexpr (N == 2) {
    const auto r0 = hn::LoadU(tag, at(0)), r1 = hn::LoadU(tag, at(1));
    out[0].v = hn::InterleaveLower(tag, r0, r1);
    out[1].v = hn::InterleaveUpper(tag, r0, r1);
  } else  // NOLINT(readability-misleading-indentation)
#endif
  {
    static_assert(N == 1, "longer vectors are not needed in one dimension");
    out[0] = Lanes<N>(at(0)[0]);
    out[1] = Lanes<N>(at(0)[1]);
  }
}

#if HWY_TARGET != HWY_SCALAR
// Four particles in a row whose records are two fields each. The lanes hold them in the order 0, 2, 1, 3, in which they
// come out of the records with two instructions and go into rows with eight.

template <int N>
ANVIL_INLINE void load_run(const double* records, Lanes<N> out[2]) {
  static_assert(N == 4);
  const typename Lanes<N>::Tag tag;
  const auto r01 = hn::LoadU(tag, records), r23 = hn::LoadU(tag, records + 4);
  out[0].v = hn::InterleaveLower(tag, r01, r23);
  out[1].v = hn::InterleaveUpper(tag, r01, r23);
}

/// Records of four fields.
template <int N>
ANVIL_INLINE void load_long_run(const double* records, Lanes<N> out[4]) {
  static_assert(N == 4);
  const std::int32_t order[] = {0, 2, 1, 3};
  load_four_fields<N>(records, 4, order, out);
}

/// The other way round as store_rows.
template <int N>
ANVIL_INLINE void load_rows(const double* rows, Lanes<N> values[4]) {
  static_assert(N == 4);
  const typename Lanes<N>::Tag tag;
  const auto p0 = hn::LoadU(tag, rows), p1 = hn::LoadU(tag, rows + 4);
  const auto p2 = hn::LoadU(tag, rows + 8), p3 = hn::LoadU(tag, rows + 12);
  const auto a01 = hn::ConcatLowerLower(tag, p1, p0), b01 = hn::ConcatUpperUpper(tag, p1, p0);
  const auto a23 = hn::ConcatLowerLower(tag, p3, p2), b23 = hn::ConcatUpperUpper(tag, p3, p2);
  values[0].v = hn::InterleaveLower(tag, a01, a23);
  values[1].v = hn::InterleaveUpper(tag, a01, a23);
  values[2].v = hn::InterleaveLower(tag, b01, b23);
  values[3].v = hn::InterleaveUpper(tag, b01, b23);
}

/// One value of each particle, in their order.
template <int N>
ANVIL_INLINE void store_run(Lanes<N> values, double* out) {
  static_assert(N == 4);
  const hn::Half<typename Lanes<N>::Tag> half;
  const auto p02 = hn::LowerHalf(half, values.v), p13 = hn::UpperHalf(half, values.v);
  hn::StoreU(hn::InterleaveLower(half, p02, p13), half, out);
  hn::StoreU(hn::InterleaveUpper(half, p02, p13), half, out + 2);
}

/// Four values of each particle: out[4 * particle + n] = values[n] of the particle.
template <int N>
ANVIL_INLINE void store_rows(const Lanes<N> values[4], double* out) {
  static_assert(N == 4);
  const typename Lanes<N>::Tag tag;
  const auto a01 = hn::InterleaveLower(tag, values[0].v, values[1].v);
  const auto a23 = hn::InterleaveUpper(tag, values[0].v, values[1].v);
  const auto b01 = hn::InterleaveLower(tag, values[2].v, values[3].v);
  const auto b23 = hn::InterleaveUpper(tag, values[2].v, values[3].v);
  hn::StoreU(hn::ConcatLowerLower(tag, b01, a01), tag, out);
  hn::StoreU(hn::ConcatUpperUpper(tag, b01, a01), tag, out + 4);
  hn::StoreU(hn::ConcatLowerLower(tag, b23, a23), tag, out + 8);
  hn::StoreU(hn::ConcatUpperUpper(tag, b23, a23), tag, out + 12);
}

#else  // one lane: never called
template <int N>
void load_run(const double* records, Lanes<N> out[2]);
template <int N>
void store_run(Lanes<N> values, double* out);
template <int N>
void store_rows(const Lanes<N> values[4], double* out);
#endif

}  // namespace anvil::ANVIL_SIMD_LEVEL
