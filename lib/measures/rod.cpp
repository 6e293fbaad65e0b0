// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/rod.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

const FrameArray* required_array(const Frame& frame, const std::string& name) {
  const FrameArray* array = frame.find(name);
  if (array == nullptr) throw InputError(fmt::format("frame {} has no array '{}'", frame.index, name));
  return array;
}

/// A point of a curve, and the height at which its particle started.
struct Sample {
  double initial_height;
  double x;
  double y;
};

/// One point per layer of particles: the mean of its samples, from the foot up.
Curve mean_by_layer(std::vector<Sample> samples, double same_height) {
  std::sort(samples.begin(), samples.end(),
            [](const Sample& a, const Sample& b) { return a.initial_height < b.initial_height; });
  Curve curve;
  for (std::size_t first = 0; first < samples.size();) {
    std::size_t last = first;
    double x = 0.0;
    double y = 0.0;
    while (last < samples.size() && samples[last].initial_height - samples[first].initial_height < same_height) {
      x += samples[last].x;
      y += samples[last].y;
      ++last;
    }
    const auto count = static_cast<double>(last - first);
    curve.x.push_back(x / count);
    curve.y.push_back(y / count);
    first = last;
  }
  return curve;
}

/// Start positions of a layer differ by rounding only, those of two layers by a spacing.
double same_place(const RodShape& shape) { return 0.25 * shape.spacing; }

}  // namespace

Rod::Rod(const Frame& frame, const RodShape& shape)
    : frame_(frame),
      shape_(shape),
      initial_position_(required_array(frame, "initial_position")),
      plastic_strain_(required_array(frame, "plastic_strain")) {
  if (frame.dimension != 3 || frame.particle_count() == 0)
    throw InputError("a rod is measured in a three-dimensional frame with particles");
}

double Rod::initial(std::size_t particle, int axis) const {
  return initial_position_->values[3 * particle + static_cast<std::size_t>(axis)];
}

double Rod::present(std::size_t particle, int axis) const {
  return frame_.positions[3 * particle + static_cast<std::size_t>(axis)];
}

double Rod::reach(int axis, double sign) const {
  double farthest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < frame_.particle_count(); ++i) farthest = std::max(farthest, sign * initial(i, axis));
  return farthest;
}

std::vector<Rod::Side> Rod::sides() const {
  std::vector<Side> found;
  for (const int axis : {0, 1})
    for (const double sign : {1.0, -1.0})
      // A symmetry plane through the axis stands where the other half of the bar would begin.
      if (reach(axis, sign) > same_place(shape_)) found.push_back({axis, sign});
  return found;
}

std::vector<std::size_t> Rod::middle_of(const Side& side) const {
  const int along = 1 - side.axis;
  const double face = reach(side.axis, side.sign) - same_place(shape_);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < frame_.particle_count(); ++i) nearest = std::min(nearest, std::abs(initial(i, along)));
  std::vector<std::size_t> particles;
  for (std::size_t i = 0; i < frame_.particle_count(); ++i)
    if (side.sign * initial(i, side.axis) > face && std::abs(initial(i, along)) < nearest + same_place(shape_))
      particles.push_back(i);
  return particles;
}

double Rod::length() const {
  double top = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < frame_.particle_count(); ++i) top = std::max(top, present(i, 2));
  return top + shape_.length - reach(2, 1.0);
}

double Rod::foot_half_width_side() const { return half_width().y.front(); }

double Rod::foot_half_width_corner() const {
  const double edge = reach(0, 1.0) - same_place(shape_);
  const double gap = shape_.half_width - reach(0, 1.0);
  const double foot = -reach(2, -1.0) + same_place(shape_);
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < frame_.particle_count(); ++i) {
    if (std::abs(initial(i, 0)) < edge || std::abs(initial(i, 1)) < edge || initial(i, 2) > foot) continue;
    sum += (std::abs(present(i, 0)) + std::abs(present(i, 1)) + 2.0 * gap) / std::numbers::sqrt2;
    count += 1.0;
  }
  return sum / count;
}

double Rod::foot_radius() const {
  const double foot = -reach(2, -1.0) + same_place(shape_);
  constexpr std::size_t sectors = 32;
  std::array<double, sectors> before{}, now{};
  for (std::size_t i = 0; i < frame_.particle_count(); ++i) {
    if (initial(i, 2) > foot) continue;
    const double turns = std::atan2(initial(i, 1), initial(i, 0)) / (2.0 * std::numbers::pi) + 1.0;
    const auto sector = static_cast<std::size_t>(std::lround(turns * sectors)) % sectors;
    before[sector] = std::max(before[sector], std::hypot(initial(i, 0), initial(i, 1)));
    now[sector] = std::max(now[sector], std::hypot(present(i, 0), present(i, 1)));
  }
  // Of the sectors that the scene has: a quarter model has a fourth of them.
  const auto mean_square = [](const std::array<double, sectors>& radii) {
    const auto filled = std::count_if(radii.begin(), radii.end(), [](double radius) { return radius > 0.0; });
    return std::inner_product(radii.begin(), radii.end(), radii.begin(), 0.0) / static_cast<double>(filled);
  };
  return std::sqrt(mean_square(now)) + shape_.half_width - std::sqrt(mean_square(before));
}

Curve Rod::half_width() const {
  std::vector<Sample> samples;
  for (const Side& side : sides()) {
    const double gap = shape_.half_width - reach(side.axis, side.sign);
    for (const std::size_t i : middle_of(side))
      samples.push_back({initial(i, 2), present(i, 2), side.sign * present(i, side.axis) + gap});
  }
  return mean_by_layer(std::move(samples), same_place(shape_));
}

Curve Rod::axis_plastic_strain() const {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < frame_.particle_count(); ++i)
    nearest = std::min(nearest, std::hypot(initial(i, 0), initial(i, 1)));
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < frame_.particle_count(); ++i)
    if (std::hypot(initial(i, 0), initial(i, 1)) < nearest + same_place(shape_))
      samples.push_back({initial(i, 2), initial(i, 2), plastic_strain_->values[i]});
  return mean_by_layer(std::move(samples), same_place(shape_));
}

}  // namespace anvil
