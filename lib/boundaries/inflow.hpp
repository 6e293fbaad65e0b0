// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/boundaries/boundary.hpp"

namespace anvil {

/// A source that moves: particles behind a plane are pushed through it at a given velocity, unstrained, as by a piston;
/// in front of it they are free. The body that waits behind the plane is what can flow in.
template <int D>
class Inflow final : public Boundary<D> {
 public:
  /// `point` on the plane (m), `normal` of unit length in the direction of the flow, `velocity` along it (m/s).
  Inflow(std::string scene_name, const Vec<D>& point, const Vec<D>& normal, double velocity)
      : Boundary<D>(std::move(scene_name)), point_(point), normal_(normal), velocity_(velocity * normal) {}

  [[nodiscard]] std::string_view name() const override { return "inflow"; }
  [[nodiscard]] std::string_view purpose() const override { return "pushes what waits behind a plane through it"; }

  void correct_velocities(ParticleRange range, VectorView<D> positions, VectorView<D> velocities,
                          double /*face_distance*/, double /*time_step*/) const override {
    for (std::size_t i = range.first(); i < range.last(); ++i)
      if (holds(positions[i])) velocities[i] = velocity_;
  }
  [[nodiscard]] bool forbids(const Vec<D>& /*position*/) const override { return false; }
  [[nodiscard]] bool holds(const Vec<D>& position) const override { return normal_.dot(position - point_) < 0.0; }

 private:
  Vec<D> point_, normal_, velocity_;
};

}  // namespace anvil
