// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "anvil/boundaries/wall_surface.hpp"
#include "anvil/core/fields.hpp"
#include "anvil/core/particle_range.hpp"
#include "anvil/pairs/images.hpp"

namespace anvil {

/// How dummy particles move in the sums of particles beside them, <v> the mean velocity of those. Moving along with
/// +<v> is not on offer: a wall that follows the flow does work on it without end.
enum class WallVelocity {
  zero,             // at rest
  antisymmetric,    // -<v>: no slip
  reversed_normal,  // <v> with its normal part reversed: free slip
};

/// The dummy particles of one wall: fixed, without equations of their own. They stand behind the particles of the
/// bodies in the fields; density, stress and velocity are interpolated from the particles beside them (see
/// solver/walls.cpp), so that sums over pairs take them for neighbours like any other.
template <int D>
class DummyRows {
 public:
  /// `range` of the points in the fields; the first row comes first. `volume` of one dummy particle, m^D.
  DummyRows(std::string scene_name, WallSurface<D> surface, std::vector<WallPoint<D>> points, ParticleRange range,
            double volume, WallVelocity velocity, bool interpolates)
      : scene_name_(std::move(scene_name)),
        surface_(std::move(surface)),
        points_(std::move(points)),
        range_(range),
        volume_(volume),
        velocity_(velocity),
        interpolates_(interpolates) {}

  [[nodiscard]] const std::string& scene_name() const { return scene_name_; }
  [[nodiscard]] ParticleRange range() const { return range_; }
  [[nodiscard]] double volume() const { return volume_; }
  [[nodiscard]] WallVelocity velocity() const { return velocity_; }
  /// Whether the dummy particles take part in continuity and momentum.
  [[nodiscard]] bool interpolates() const { return interpolates_; }
  [[nodiscard]] const Vec<D>& normal(std::size_t particle) const { return points_[particle - range_.first()].normal; }
  [[nodiscard]] const Vec<D>& position(std::size_t particle) const {
    return points_[particle - range_.first()].position;
  }
  [[nodiscard]] bool in_first_row(std::size_t particle) const { return points_[particle - range_.first()].row == 0; }

  /// Collects the pairs of a particle of a body, of which there are `particles`, and a dummy of the first row.
  void list(const NeighbourList<D>& neighbours, const Images<D>& images, std::size_t first_image,
            std::size_t particles);
  /// Particles with a dummy of the first row in their list, and the records of those.
  [[nodiscard]] const std::vector<std::int32_t>& near_particles() const { return near_; }
  [[nodiscard]] std::size_t listed_particles() const { return first_.size() - 1; }
  [[nodiscard]] std::span<const std::int32_t> dummies_near(std::size_t particle) const {
    return {record_.data() + first_[particle], record_.data() + first_[particle + 1]};
  }
  /// How many of the near particles went through the surface in the step that led to the positions.
  [[nodiscard]] int count_penetrations(VectorView<D> positions, VectorView<D> velocities, double time_step) const;

 private:
  std::string scene_name_;
  WallSurface<D> surface_;
  std::vector<WallPoint<D>> points_;
  ParticleRange range_;
  double volume_;
  WallVelocity velocity_;
  bool interpolates_;
  std::vector<std::int32_t> near_, record_;
  std::vector<std::int64_t> first_ = {0};
};

template <int D>
using Walls = std::vector<std::unique_ptr<DummyRows<D>>>;

}  // namespace anvil
