// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "anvil/core/tensor.hpp"
#include "anvil/output/frame.hpp"
#include "anvil/scene/scene.hpp"

namespace anvil {

/// A ring before it moves, m.
struct ShellShape {
  double spacing = 0.0;  // of the particles
  Vec<2> centre = Vec<2>::Zero();
  double inner_radius = 0.0, outer_radius = 0.0;
};

/// The first body of the scene. Throws InputError when it is no ring.
ShellShape shell_shape(const Scene& scene);

/// The faces of a ring that has collapsed or grown, from the particles that started within a spacing of a face. The
/// area between a particle's circle and the face is that of the start, which plastic flow keeps: so a particle says
/// where its face is, and results do not shift with the spacing. Sectors are measured like the whole. Radii are from
/// the mean of the centres of all particles where the ring is full, which moves with it, else from the centre of the
/// shape.
class Shell {
 public:
  /// The frame needs the array initial_position; throws InputError when it lacks it.
  Shell(const Frame& frame, const ShellShape& shape);

  [[nodiscard]] double inner_radius() const;
  [[nodiscard]] double outer_radius() const;
  /// Largest less smallest radius of the inner face over their mean.
  [[nodiscard]] double circularity() const;

 private:
  std::vector<double> inner_, outer_;  // radii of the faces, one per particle at them
};

}  // namespace anvil
