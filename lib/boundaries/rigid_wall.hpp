// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "anvil/boundaries/boundary.hpp"

namespace anvil {

/// An immovable plane without friction that pushes and never pulls. Particles fill their bodies: the face of a particle
/// lies half a spacing before its centre, and it is the face that touches. A particle keeps as much of its approach as
/// brings the face to the plane within the step, no more; the rest is the wall's impulse.
template <int D>
class RigidWall final : public Boundary<D> {
 public:
  /// `point` on the plane (m), `normal` of unit length towards the bodies, `standoff` of centres from the plane (m).
  RigidWall(std::string scene_name, const Vec<D>& point, const Vec<D>& normal, double standoff)
      : Boundary<D>(std::move(scene_name)), point_(point), normal_(normal), standoff_(standoff) {}

  [[nodiscard]] std::string_view name() const override { return "rigid_wall"; }
  [[nodiscard]] std::string_view purpose() const override { return "plane without friction that pushes, never pulls"; }

  void correct_velocities(ParticleRange range, VectorView<D> positions, VectorView<D> velocities,
                          double time_step) const override {
    for (std::size_t i = range.first(); i < range.last(); ++i) {
      const double gap = normal_.dot(positions[i] - point_) - standoff_;
      const double speed = normal_.dot(velocities[i]);
      const double least = -std::max(gap, 0.0) / time_step;
      if (speed < least) velocities[i] += (least - speed) * normal_;
    }
  }

  [[nodiscard]] bool forbids(const Vec<D>& position) const override { return normal_.dot(position - point_) < 0.0; }

 private:
  Vec<D> point_, normal_;
  double standoff_;
};

}  // namespace anvil
