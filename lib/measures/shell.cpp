// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/shell.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

Vec<2> point_of(const std::vector<double>& positions, std::size_t particle) {
  return {positions[3 * particle], positions[3 * particle + 1]};
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// How far the middle of all particles has moved.
Vec<2> drift(const Frame& frame, const std::vector<double>& initial) {
  Vec<2> sum = Vec<2>::Zero();
  for (std::size_t i = 0; i < frame.particle_count(); ++i) sum += point_of(frame.positions, i) - point_of(initial, i);
  return sum / static_cast<double>(frame.particle_count());
}

/// Particles of a sector move towards its corner: only those of a whole ring have a middle that stays the ring's.
bool is_full(const std::vector<double>& initial, const ShellShape& shape) {
  double left = 0.0, below = 0.0;
  for (std::size_t i = 0; 3 * i < initial.size(); ++i) {
    const Vec<2> arm = point_of(initial, i) - shape.centre;
    left = std::min(left, arm[0]);
    below = std::min(below, arm[1]);
  }
  return left < -shape.inner_radius && below < -shape.inner_radius;
}

}  // namespace

ShellShape shell_shape(const Scene& scene) {
  if (scene.bodies.empty() || scene.bodies.front().shape.type != "ring")
    throw InputError("a shell is measured in a scene whose first body is a ring");
  const Parameters& ring = scene.bodies.front().shape.parameters;
  return {scene.discretisation.spacing, Vec<2>(ring.numbers("centre").data()), ring.number("inner_radius"),
          ring.number("outer_radius")};
}

Shell::Shell(const Frame& frame, const ShellShape& shape) {
  const FrameArray* array = frame.find("initial_position");
  if (array == nullptr) throw InputError(fmt::format("frame {} has no array 'initial_position'", frame.index));
  const std::vector<double>& initial = array->values;
  Vec<2> centre = shape.centre;
  if (is_full(initial, shape)) centre += drift(frame, initial);
  for (std::size_t i = 0; i < frame.particle_count(); ++i) {
    const double before = (point_of(initial, i) - shape.centre).squaredNorm();
    const double now = (point_of(frame.positions, i) - centre).squaredNorm();
    const auto face_of = [&](double face) { return std::sqrt(std::max(0.0, now - (before - face * face))); };
    if (std::sqrt(before) < shape.inner_radius + shape.spacing) inner_.push_back(face_of(shape.inner_radius));
    if (std::sqrt(before) > shape.outer_radius - shape.spacing) outer_.push_back(face_of(shape.outer_radius));
  }
  if (inner_.empty() || outer_.empty()) throw InputError("no particle of the shell started within a spacing of a face");
}

double Shell::inner_radius() const { return mean_of(inner_); }
double Shell::outer_radius() const { return mean_of(outer_); }

double Shell::circularity() const {
  const auto [least, greatest] = std::minmax_element(inner_.begin(), inner_.end());
  return (*greatest - *least) / mean_of(inner_);
}

}  // namespace anvil
