// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "anvil/measures/mirror.hpp"

namespace anvil {

using Point = std::array<double, 3>;

/// Points in rows: point (i, j) lies at origin + i step[0] u + j step[1] v. A single row is a line. All in metres.
struct SampleGrid {
  Point origin{};
  Point u{1.0, 0.0, 0.0}, v{0.0, 1.0, 0.0};  // unit vectors, at right angles
  std::array<double, 2> step{1.0, 1.0};
  std::array<int, 2> nodes{2, 2};

  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(nodes[0]) * static_cast<std::size_t>(nodes[1]);
  }
  [[nodiscard]] bool is_line() const { return nodes[1] == 1; }
};

/// Evenly spaced points from `begin` to `end`, both included. Throws InputError for fewer than two points or a line
/// without length.
SampleGrid make_sample_line(const Point& begin, const Point& end, int count);

/// The part of a plane inside a box (x low, x high, y low, ..., m), with steps of about `step`. The directions are
/// axes where the plane is across one: u along x before y, v along z before y. Throws InputError when the plane misses
/// the box, the normal has no length or the step would make too many points.
SampleGrid make_sample_plane(const Plane& plane, const std::array<double, 6>& box, double step);

/// The points, 3 numbers each, row by row.
std::vector<double> points_of(const SampleGrid& grid);

/// The box around positions (3 numbers each), widened by `margin` in the first `dimension` directions.
std::array<double, 6> box_around(const std::vector<double>& positions, int dimension, double margin);

}  // namespace anvil
