// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/align/aligned_allocator.hpp>
#include <cstddef>
#include <vector>

namespace anvil {

/// Independent components a symmetric tensor shows to forces in D dimensions: XX | XX YY XY | XX YY ZZ XY YZ XZ.
template <int D>
inline constexpr int symmetric_components = D == 1 ? 1 : (D == 2 ? 3 : 6);

/// What the pair loops read of a neighbour, packed: a few doubles side by side per particle, so that one neighbour
/// costs one cache line per record and eight of them are loaded and transposed into vector lanes. One record stands
/// behind the last particle: what list padding points to. It is far away and weightless, so it adds nothing to any sum.
template <int Size>
class Records {
 public:
  static constexpr int size = Size;  // doubles per record
  void resize(std::size_t particles) { values_.assign((particles + 1) * Size, 0.0); }
  [[nodiscard]] double* operator[](std::size_t i) { return values_.data() + i * Size; }
  [[nodiscard]] const double* operator[](std::size_t i) const { return values_.data() + i * Size; }
  [[nodiscard]] const double* raw() const { return values_.data(); }

 private:
  std::vector<double, boost::alignment::aligned_allocator<double, 64>> values_;
};

/// The records of a D-dimensional scene; `medium` is filled only when a term asks for it.
template <int D>
struct PairRecords {
  static constexpr int small = D == 1 ? 2 : 4;
  static constexpr int large = D == 1 ? 2 : (D == 2 ? 4 : 8);
  Records<small> geometry;  // position, smoothing length
  Records<small> motion;    // velocity, volume
  Records<large> traction;  // tensor T, weight w: what the momentum sum reads
  Records<4> medium;        // sound speed, density, mass
};

/// Far outside any support, yet no power of it that a kernel forms overflows.
inline constexpr double padding_distance = 1e30;  // m

}  // namespace anvil
