// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "anvil/boundaries/boundary.hpp"

namespace anvil {

/// An immovable plane without friction that pushes and never pulls. What touches is the face of a body, half a spacing
/// before the particles that fill it or just where they stand on it. A particle keeps as much of its approach as brings
/// the face to the plane within the step, no more; the rest is the wall's impulse.
template <int D>
class RigidWall final : public Boundary<D> {
 public:
  /// `point` on the plane (m), `normal` of unit length towards the bodies, `spacing` of particles (m).
  RigidWall(std::string scene_name, const Vec<D>& point, const Vec<D>& normal, double spacing)
      : Boundary<D>(std::move(scene_name)), point_(point), normal_(normal), tolerance_(1e-6 * spacing) {}

  [[nodiscard]] std::string_view name() const override { return "rigid_wall"; }
  [[nodiscard]] std::string_view purpose() const override { return "plane without friction that pushes, never pulls"; }

  void correct_velocities(ParticleRange range, VectorView<D> positions, VectorView<D> velocities, double face_distance,
                          double time_step) const override {
    for (std::size_t i = range.first(); i < range.last(); ++i) {
      const double gap = normal_.dot(positions[i] - point_) - face_distance;
      const double speed = normal_.dot(velocities[i]);
      const double least = -std::max(gap, 0.0) / time_step;
      if (speed < least) velocities[i] += (least - speed) * normal_;
    }
  }

  [[nodiscard]] bool forbids(const Vec<D>& position) const override {
    return normal_.dot(position - point_) < -tolerance_;
  }

 private:
  Vec<D> point_, normal_;
  double tolerance_;  // m, of rounding: particles may stand on the plane
};

}  // namespace anvil
