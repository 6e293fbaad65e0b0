// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "anvil/boundaries/boundary.hpp"

namespace anvil {

/// What a plane of symmetry asks of velocities: no particle crosses it, and one that lies on it stays there, since its
/// normal velocity is odd about the plane. The images behind the plane (see Images) do the rest.
template <int D>
class SymmetryPlane final : public Boundary<D> {
 public:
  /// `point` on the plane (m), `normal` of unit length towards the bodies, `spacing` of the particles (m).
  SymmetryPlane(std::string scene_name, const Vec<D>& point, const Vec<D>& normal, double spacing)
      : Boundary<D>(std::move(scene_name)), point_(point), normal_(normal), on_plane_(1e-9 * spacing) {}

  [[nodiscard]] std::string_view name() const override { return "symmetry_plane"; }
  [[nodiscard]] std::string_view purpose() const override { return "mirror images behind a plane that none crosses"; }

  void correct_velocities(ParticleRange range, VectorView<D> positions, VectorView<D> velocities,
                          double /*face_distance*/, double time_step) const override {
    for (std::size_t i = range.first(); i < range.last(); ++i) {
      const double gap = normal_.dot(positions[i] - point_);
      const double speed = normal_.dot(velocities[i]);
      if (std::abs(gap) <= on_plane_)
        velocities[i] -= speed * normal_;
      else if (speed < -gap / time_step)
        velocities[i] += (-std::max(gap, 0.0) / time_step - speed) * normal_;
    }
  }

  [[nodiscard]] bool forbids(const Vec<D>& position) const override {
    return normal_.dot(position - point_) < -on_plane_;
  }

 private:
  Vec<D> point_, normal_;
  double on_plane_;  // m: nearer than this a particle lies on the plane
};

}  // namespace anvil
