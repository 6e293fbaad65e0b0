// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <boost/align/aligned_allocator.hpp>
#include <cstddef>
#include <vector>

#include "anvil/pairs/tile.hpp"

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
  [[nodiscard]] std::size_t count() const { return values_.size() / Size; }
  /// Keeps the first `records`; new ones are zero.
  void keep(std::size_t records, std::size_t all) {
    values_.resize(records * Size);
    values_.resize(all * Size, 0.0);
  }
  [[nodiscard]] double* operator[](std::size_t i) { return values_.data() + i * Size; }
  [[nodiscard]] const double* operator[](std::size_t i) const { return values_.data() + i * Size; }
  [[nodiscard]] const double* raw() const { return values_.data(); }

  /// Where the records stand, for loops that write in between: a copy of this needs not be read again after a write.
  struct Rows {
    static constexpr int size = Size;
    const double* values;
    [[nodiscard]] const double* operator[](std::size_t i) const { return values + i * Size; }
    [[nodiscard]] const double* raw() const { return values; }
  };
  [[nodiscard]] Rows rows() const { return {values_.data()}; }

 private:
  std::vector<double, boost::alignment::aligned_allocator<double, 64>> values_;
};

/// Far outside any support, yet no power of it that a kernel forms overflows.
inline constexpr double padding_distance = 1e30;  // m

/// Fields of the response record: what a Riemann problem asks of a material point beside its state.
enum ResponseField : int {
  response_pressure,               // Pa
  response_density,                // kg/m3
  response_elastic_speed,          // m/s
  response_plastic_speed,          // m/s
  response_inverse_elastic_speed,  // s/m
  response_inverse_shear,          // 3 / (4 G), 1/Pa
  response_limit,                  // 2 Y / 3, Pa
};

/// Fields of the slope record: the velocity gradient (D x D, row first), density times acceleration (D), which is the
/// divergence of stress, and the number of the body.
template <int D>
struct SlopeField {
  static constexpr int velocity = 0, stress = D * D, body = D * D + D, size = D == 1 ? 4 : (D == 2 ? 8 : 16);
};

/// The records of a D-dimensional scene; the last four are filled only when a term asks.
template <int D>
struct PairRecords {
  static constexpr int small = D == 1 ? 2 : 4;
  static constexpr int large = D == 1 ? 2 : (D == 2 ? 4 : 8);
  static constexpr int nominal_size = D == 1 ? 2 : (D == 2 ? 8 : 12);
  Records<small> geometry;        // position, smoothing length
  Records<small> motion;          // velocity, volume
  Records<large> traction;        // tensor T, weight w: what the momentum sum reads
  Records<nominal_size> nominal;  // tensor of D x D, weight: what the momentum sum of the reference configuration reads
  Records<4> medium;              // sound speed without shear, density, mass, viscosity
  Records<8> response;            // by ResponseField
  Records<SlopeField<D>::size> slope;
  Records<large> correction;  // symmetric and packed

  /// Room for images of particles (see Images, FaceGhosts) behind the padding record; those of before are gone.
  void set_images(std::size_t images) {
    const std::size_t own = particles_ + 1;
    geometry.keep(own, own + images);
    motion.keep(own, own + images);
    if (nominal.count() > 0)
      nominal.keep(own, own + images);
    else
      traction.keep(own, own + images);
    if (response.count() != 0) response.keep(own, own + images);
    if (slope.count() != 0) slope.keep(own, own + images);
    if (correction.count() != 0) correction.keep(own, own + images);
    if (medium.count() == 0) return;
    medium.keep(own, own + images);
    for (std::size_t g = 0; g < images; ++g) medium[own + g][1] = 1.0;  // a density to divide by; their mass stays zero
  }

  /// The record of the first image.
  [[nodiscard]] std::size_t first_image() const { return particles_ + 1; }

  /// All records zero but those of the padding. Records nobody needs stay empty.
  void resize(std::size_t particles, const PairNeeds& needs);

 private:
  std::size_t particles_ = 0;
};

template <int D>
void PairRecords<D>::resize(std::size_t particles, const PairNeeds& needs) {
  particles_ = particles;
  geometry.resize(particles);
  motion.resize(particles);
  if (needs.nominal)
    nominal.resize(particles);
  else
    traction.resize(particles);
  std::fill_n(geometry[particles], D, padding_distance);
  geometry[particles][D] = 1.0;
  if (needs.slope) slope.resize(particles);
  if (needs.correction) correction.resize(particles);
  if (needs.response) {
    response.resize(particles);
    for (const int field : {response_density, response_elastic_speed, response_plastic_speed})
      response[particles][field] = 1.0;  // to divide by
  }
  if (!needs.medium) return;
  medium.resize(particles);
  medium[particles][1] = 1.0;  // a density to divide by; its mass stays zero
}

}  // namespace anvil
