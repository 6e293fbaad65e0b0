// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "anvil/core/fields.hpp"
#include "anvil/pairs/neighbour_list.hpp"
#include "anvil/pairs/records.hpp"
#include "anvil/pairs/transform.hpp"

namespace anvil {

/// A plane that reflects: particles stand on the side its unit normal points to. With `reverses_velocity` images move
/// against their particles, as behind a wall without slip; otherwise they are reflected like the positions.
template <int D>
struct MirrorPlane {
  Vec<D> point, normal;
  bool reverses_velocity = false;
};

/// A direction in which the scene repeats: what leaves at one end enters at the other.
struct Period {
  int axis;
  double minimum, maximum;  // m
};

/// Images of particles behind mirror planes and beyond the ends of periods. An image is a source particle and a
/// transform; its records stand behind the padding record and are filled from those of its source after each packing,
/// so that sums over pairs see it as any neighbour. Planes may meet, at angles that divide 180 degrees: transforms are
/// all products of reflections and shifts that bring a particle within reach.
///
/// A particle exactly on a plane coincides with its image: with half its volume it stands for a whole particle, half of
/// which lies on the other side. Their pair has no distance and so no gradient.
template <int D>
class Images {
 public:
  Images() = default;
  Images(std::vector<MirrorPlane<D>> planes, std::vector<Period> periods);

  /// Whether the scene has planes or periods at all.
  [[nodiscard]] bool possible() const { return !generators_.empty(); }
  [[nodiscard]] bool reflect() const { return !planes_.empty(); }
  [[nodiscard]] std::size_t count() const { return source_.size(); }
  [[nodiscard]] std::size_t source(std::size_t image) const { return static_cast<std::size_t>(source_[image]); }
  [[nodiscard]] const Transform<D>& transform(std::size_t image) const {
    return transforms_[static_cast<std::size_t>(transform_of_[image])];
  }
  /// Projects on the directions in which the planes can push: the span of their normals.
  [[nodiscard]] const Mat<D>& push_directions() const { return push_directions_; }

  /// The place of a position in the period it left.
  [[nodiscard]] Vec<D> wrapped(Vec<D> position) const;
  [[nodiscard]] bool wraps() const { return !periods_.empty(); }

  /// Finds the images that can come within `reach` (m, skin included) of a particle. Positions are wrapped.
  void find(VectorView<D> positions, std::span<const double> smoothing_length, double reach);
  /// Where the images stand, for the search: only their places and smoothing lengths.
  [[nodiscard]] const ImageSites<D>& sites() const { return sites_; }

  // Fill the images' records from those of their sources. `first` is the record of the first image.
  void fill_geometry(PairRecords<D>& records, std::size_t first) const;
  void fill_motion(PairRecords<D>& records, std::size_t first) const;
  void fill_traction(PairRecords<D>& records, std::size_t first) const;
  void fill_nominal(PairRecords<D>& records, std::size_t first) const;
  void fill_medium(PairRecords<D>& records, std::size_t first) const;
  /// Response, slope and correction, those that are there.
  void fill_responses(PairRecords<D>& records, std::size_t first) const;

  /// Widens the box of the particles' displacements to that of particles and images.
  void widen(Vec<D>& least, Vec<D>& greatest) const;

 private:
  [[nodiscard]] bool near_border(const Vec<D>& position, double reach) const;
  [[nodiscard]] bool near_inside(const Vec<D>& position, double reach) const;
  [[nodiscard]] bool known(const Transform<D>& transform) const;
  template <class Fill>
  void for_each_image(Fill&& fill) const;

  std::vector<MirrorPlane<D>> planes_;
  std::vector<Period> periods_;
  std::vector<Transform<D>> generators_;  // one reflection per plane, two shifts per period
  Mat<D> push_directions_ = Mat<D>::Zero();
  double scale_ = 0.0;  // m, largest coordinate of planes and periods: what equal shifts are measured by
  std::vector<Transform<D>> transforms_;
  std::vector<std::int32_t> source_, transform_of_;
  ImageSites<D> sites_;
};

}  // namespace anvil
