// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/sample_places.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "anvil/core/error.hpp"
#include "anvil/core/tensor.hpp"

namespace anvil {
namespace {

constexpr int most_nodes = 20000;  // along a side of a plane
constexpr int most_points = 10000000;

Vec<3> vector_of(const Point& point) { return {point[0], point[1], point[2]}; }
Point point_of(const Vec<3>& vector) { return {vector[0], vector[1], vector[2]}; }

/// Two directions at right angles to the normal and to each other.
std::pair<Vec<3>, Vec<3>> directions_of(const Vec<3>& normal) {
  Eigen::Index across = 0;
  if (normal.cwiseAbs().maxCoeff(&across) > 1.0 - 1e-9) {
    const Vec<3> u = across == 0 ? Vec<3>::UnitY() : Vec<3>::UnitX();
    const Vec<3> v = across == 2 ? Vec<3>::UnitY() : Vec<3>::UnitZ();
    return {u, v};
  }
  const Vec<3> u = Vec<3>(Vec<3>::UnitZ().cross(normal)).normalized();
  return {u, Vec<3>(normal.cross(u))};
}

}  // namespace

SampleGrid make_sample_line(const Point& begin, const Point& end, int count) {
  const Vec<3> reach = vector_of(end) - vector_of(begin);
  const double length = reach.norm();
  if (!(length > 0.0)) throw InputError("the two ends of the line are the same point");
  if (count < 2 || count > most_points)
    throw InputError(fmt::format("a line has 2 to {} points, not {}", most_points, count));
  SampleGrid line;
  line.origin = begin;
  line.u = point_of(reach / length);
  line.v = point_of(directions_of(reach / length).first);
  line.step = {length / (count - 1), 1.0};
  line.nodes = {count, 1};
  return line;
}

SampleGrid make_sample_plane(const Plane& plane, const std::array<double, 6>& box, double step) {
  Vec<3> normal = vector_of(plane.normal);
  if (!(normal.norm() > 0.0) || !(step > 0.0)) throw InputError("a plane needs a normal with a length, and a step");
  normal.normalize();
  const Vec<3> origin = vector_of(plane.point);
  const auto [u, v] = directions_of(normal);
  // The rectangle that holds all corners of the box, seen along the normal.
  double low[2] = {std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  double high[2] = {-low[0], -low[1]};
  double nearest = std::numeric_limits<double>::max();
  double farthest = -nearest;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const Vec<3> offset = Vec<3>(box[corner & 1U], box[2 + ((corner >> 1U) & 1U)], box[4 + (corner >> 2U)]) - origin;
    const double along[2] = {offset.dot(u), offset.dot(v)};
    for (int i = 0; i < 2; ++i) {
      low[i] = std::min(low[i], along[i]);
      high[i] = std::max(high[i], along[i]);
    }
    nearest = std::min(nearest, offset.dot(normal));
    farthest = std::max(farthest, offset.dot(normal));
  }
  const double slack = 1e-9 * (farthest - nearest + step);
  if (nearest > slack || farthest < -slack)
    throw InputError(
        fmt::format("the plane does not meet the bodies: they lie {:.4g} to {:.4g} m from it, along its "
                    "normal",
                    nearest, farthest));
  SampleGrid sample;
  sample.u = point_of(u);
  sample.v = point_of(v);
  for (std::size_t i = 0; i < 2; ++i) {
    const double cells = std::ceil((high[i] - low[i]) / step - 1e-9);
    if (cells > most_nodes)
      throw InputError(
          fmt::format("the plane would need {:.3g} points along a side: choose a larger step than {} m, or "
                      "some particles have flown off",
                      cells, step));
    sample.nodes[i] = std::max(2, 1 + static_cast<int>(cells));
    sample.step[i] = (high[i] - low[i]) / (sample.nodes[i] - 1);
  }
  sample.origin = point_of(origin + low[0] * u + low[1] * v);
  return sample;
}

std::vector<double> points_of(const SampleGrid& grid) {
  std::vector<double> points;
  points.reserve(3 * grid.count());
  for (int j = 0; j < grid.nodes[1]; ++j)
    for (int i = 0; i < grid.nodes[0]; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        points.push_back(grid.origin[axis] + i * grid.step[0] * grid.u[axis] + j * grid.step[1] * grid.v[axis]);
  return points;
}

std::array<double, 6> box_around(const std::vector<double>& positions, int dimension, double margin) {
  std::array<double, 6> box{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = std::numeric_limits<double>::max();
    double high = -low;
    for (std::size_t i = axis; i < positions.size(); i += 3) {
      low = std::min(low, positions[i]);
      high = std::max(high, positions[i]);
    }
    const double room = static_cast<int>(axis) < dimension ? margin : 0.0;
    box[2 * axis] = low - room;
    box[2 * axis + 1] = high + room;
  }
  return box;
}

}  // namespace anvil
