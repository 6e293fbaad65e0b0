// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "anvil/measures/curve.hpp"
#include "anvil/output/frame.hpp"

namespace anvil {

/// The bar before the impact: its axis is x = y = 0, its foot stands on the wall at z = 0. Lengths in m.
struct RodShape {
  double spacing = 0.0;     // of the particles
  double half_width = 0.0;  // from the axis to a side
  double length = 0.0;      // from the foot to the rear face
};

/// What is read off a square bar that has struck a rigid wall. Rows of particles are picked by where they were before
/// the impact, so that they stay the same material. Particles that fill a bar lie half a spacing inside its faces: this
/// distance, as it was at the start, is added to every length and width, so that results are faces and do not shift
/// with the spacing. Sides that the scene has (all four, or two of a quarter model) are averaged.
class Rod {
 public:
  /// The frame needs the arrays initial_position and plastic_strain; throws InputError when it lacks them or is not
  /// three-dimensional. Keeps a reference to the frame.
  Rod(const Frame& frame, const RodShape& shape);

  /// From the wall to the rear face, m.
  [[nodiscard]] double length() const;
  /// From the axis to the foot's edge at the middle of a side, m: particles of the lowest layer.
  [[nodiscard]] double foot_half_width_side() const;
  /// From the axis to the foot's corner, along the diagonal, m.
  [[nodiscard]] double foot_half_width_corner() const;
  /// Of a round bar: radius of the circle with the foot's area, m, from the outermost particles of the lowest layer in
  /// each of 32 sectors. What the staircase that they start on is off the circle on average is added.
  [[nodiscard]] double foot_radius() const;
  /// Half-width in m over the present height in m, at the middle of a side, from the foot up.
  [[nodiscard]] Curve half_width() const;
  /// Plastic strain over the height above the foot that the material had at the start, in m, from the particles nearest
  /// to the axis.
  [[nodiscard]] Curve axis_plastic_strain() const;

 private:
  struct Side {
    int axis;
    double sign;
  };
  [[nodiscard]] double initial(std::size_t particle, int axis) const;
  [[nodiscard]] double present(std::size_t particle, int axis) const;
  /// How far the particles reach in a direction at the start.
  [[nodiscard]] double reach(int axis, double sign) const;
  [[nodiscard]] std::vector<Side> sides() const;
  /// Particles that started on a side, in the column or columns next to its middle.
  [[nodiscard]] std::vector<std::size_t> middle_of(const Side& side) const;

  const Frame& frame_;
  RodShape shape_;
  const FrameArray* initial_position_;
  const FrameArray* plastic_strain_;
};

}  // namespace anvil
