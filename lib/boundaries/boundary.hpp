// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "anvil/core/fields.hpp"
#include "anvil/core/particle_range.hpp"

namespace anvil {

/// Acts on velocities after kick and filters, before the particles move.
template <int D>
class Boundary {
 public:
  /// `scene_name` is what the scene calls it.
  explicit Boundary(std::string scene_name) : scene_name_(std::move(scene_name)) {}
  Boundary(const Boundary&) = delete;
  Boundary& operator=(const Boundary&) = delete;
  virtual ~Boundary() = default;

  [[nodiscard]] const std::string& scene_name() const { return scene_name_; }
  [[nodiscard]] virtual std::string_view name() const = 0;  // of the kind
  [[nodiscard]] virtual std::string_view purpose() const = 0;
  /// Changes the velocities of the range (m/s) so that a move of time_step (s) respects the boundary, with the faces of
  /// the body face_distance (m) beyond its outermost particles. What it changes is the boundary's impulse: the solver
  /// keeps the account.
  virtual void correct_velocities(ParticleRange range, VectorView<D> positions, VectorView<D> velocities,
                                  double face_distance, double time_step) const = 0;
  /// True for a position that no particle may take.
  [[nodiscard]] virtual bool forbids(const Vec<D>& position) const = 0;
  /// True where the boundary carries particles along without strain.
  [[nodiscard]] virtual bool holds(const Vec<D>& /*position*/) const { return false; }

 private:
  std::string scene_name_;
};

}  // namespace anvil
