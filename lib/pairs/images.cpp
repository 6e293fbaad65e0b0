// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/pairs/images.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "anvil/core/threads.hpp"

namespace anvil {
namespace {

constexpr double same = 1e-9;  // of one, or of the scene's size: transforms that differ by less are one

template <int D>
Transform<D> reflection(const MirrorPlane<D>& plane) {
  Mat<D> turn = Mat<D>::Identity() - 2.0 * plane.normal * plane.normal.transpose();
  // Planes along axes and diagonals swap coordinates to the last bit, although the root of two is not exact.
  constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
  turn = turn.unaryExpr([](double x) { return std::abs(x - std::round(x)) < rounding ? std::round(x) + 0.0 : x; });
  return {turn, 2.0 * plane.normal.dot(plane.point) * plane.normal,
          plane.reverses_velocity ? Mat<D>(-Mat<D>::Identity()) : turn};
}

/// The orthogonal projector on the span of the normals, by Gram and Schmidt.
template <int D>
Mat<D> projector_on(const std::vector<MirrorPlane<D>>& planes) {
  Mat<D> projector = Mat<D>::Zero();
  for (const auto& plane : planes) {
    if (plane.reverses_velocity) return Mat<D>::Identity();  // no slip: it pushes along itself too
    const Vec<D> rest = plane.normal - projector * plane.normal;
    if (rest.norm() > same) projector += rest.normalized() * rest.normalized().transpose();
  }
  return projector;
}

}  // namespace

template <int D>
Images<D>::Images(std::vector<MirrorPlane<D>> planes, std::vector<Period> periods)
    : planes_(std::move(planes)), periods_(std::move(periods)), push_directions_(projector_on(planes_)) {
  for (const auto& plane : planes_) {
    generators_.push_back(reflection(plane));
    scale_ = std::max(scale_, plane.point.cwiseAbs().maxCoeff());
  }
  for (const Period& period : periods_) {
    Transform<D> shift;
    shift.shift[period.axis] = period.maximum - period.minimum;
    generators_.push_back(shift);
    shift.shift = -shift.shift;
    generators_.push_back(shift);
    scale_ = std::max({scale_, std::abs(period.minimum), std::abs(period.maximum)});
  }
}

/// Adds or takes one length at a time, in an order that leaves a wrapped position as it is whatever the rounding.
template <int D>
Vec<D> Images<D>::wrapped(Vec<D> position) const {
  for (const Period& period : periods_) {
    double& x = position[period.axis];
    const double length = period.maximum - period.minimum;
    if (!std::isfinite(x)) continue;
    if (std::abs(x - period.minimum) > 2.0 * length) x -= std::floor((x - period.minimum) / length) * length;
    while (x < period.minimum) x += length;
    while (x >= period.maximum) x -= length;
  }
  return position;
}

template <int D>
bool Images<D>::near_border(const Vec<D>& position, double reach) const {
  for (const auto& plane : planes_)
    if (plane.normal.dot(position - plane.point) < reach) return true;
  for (const Period& period : periods_) {
    const double x = position[period.axis];
    if (x - period.minimum < reach || period.maximum - x < reach) return true;
  }
  return false;
}

template <int D>
bool Images<D>::near_inside(const Vec<D>& position, double reach) const {
  for (const auto& plane : planes_)
    if (plane.normal.dot(position - plane.point) < -reach) return false;
  for (const Period& period : periods_) {
    const double x = position[period.axis];
    if (x < period.minimum - reach || x > period.maximum + reach) return false;
  }
  return true;
}

template <int D>
bool Images<D>::known(const Transform<D>& transform) const {
  return std::any_of(transforms_.begin(), transforms_.end(), [&](const Transform<D>& one) {
    return (one.turn - transform.turn).cwiseAbs().maxCoeff() < same &&
           (one.shift - transform.shift).cwiseAbs().maxCoeff() < same * std::max(scale_, 1e-30);
  });
}

/// Transforms are tried by their number of factors. One that brings no particle near is not multiplied further: the way
/// from inside to a distant chamber leads through nearer ones.
template <int D>
void Images<D>::find(VectorView<D> positions, std::span<const double> smoothing_length, double reach) {
  std::vector<std::int32_t> candidates;
  for (std::size_t i = 0; i < smoothing_length.size(); ++i)
    if (near_border(positions[i], reach)) candidates.push_back(static_cast<std::int32_t>(i));
  transforms_.assign(1, Transform<D>());
  source_.clear();
  transform_of_.clear();
  sites_.position.clear();
  sites_.smoothing_length.clear();
  std::vector<std::size_t> fruitful = {0};
  while (!fruitful.empty()) {
    std::vector<std::size_t> next;
    for (const std::size_t old : fruitful) {
      for (const auto& generator : generators_) {
        const Transform<D> transform = transforms_[old] * generator;
        if (known(transform)) continue;
        const std::size_t before = source_.size(), number = transforms_.size();
        transforms_.push_back(transform);
        for (const std::int32_t i : candidates) {
          const Vec<D> place = transform(positions[static_cast<std::size_t>(i)]);
          if (!near_inside(place, reach)) continue;
          source_.push_back(i);
          transform_of_.push_back(static_cast<std::int32_t>(number));
          sites_.position.push_back(place);
          sites_.smoothing_length.push_back(smoothing_length[static_cast<std::size_t>(i)]);
        }
        if (source_.size() > before) next.push_back(number);
      }
    }
    fruitful = std::move(next);
  }
}

/// fill(image, source, transform); short lists are not worth a second thread.
template <int D>
template <class Fill>
void Images<D>::for_each_image(Fill&& fill) const {
  constexpr std::size_t chunk = 512;
  const auto chunks = static_cast<int>((count() + chunk - 1) / chunk);
  for_each_parallel(chunks, [&](int c, int /*thread*/) {
    const std::size_t begin = static_cast<std::size_t>(c) * chunk;
    for (std::size_t g = begin; g < std::min(begin + chunk, count()); ++g) fill(g, source(g), transform(g));
  });
}

template <int D>
void Images<D>::fill_geometry(PairRecords<D>& records, std::size_t first) const {
  for_each_image([&](std::size_t g, std::size_t from, const Transform<D>& transform) {
    const Vec<D> place = transform(Vec<D>(records.geometry[from]));
    std::copy_n(place.data(), D, records.geometry[first + g]);
    records.geometry[first + g][D] = records.geometry[from][D];
  });
}

template <int D>
void Images<D>::fill_motion(PairRecords<D>& records, std::size_t first) const {
  for_each_image([&](std::size_t g, std::size_t from, const Transform<D>& transform) {
    turn_vector<D>(transform.velocity_turn, records.motion[from], records.motion[first + g]);
    records.motion[first + g][D] = records.motion[from][D];
  });
}

template <int D>
void Images<D>::fill_traction(PairRecords<D>& records, std::size_t first) const {
  constexpr int weight = symmetric_components<D>;
  for_each_image([&](std::size_t g, std::size_t from, const Transform<D>& transform) {
    turn_symmetric<D>(transform.turn, records.traction[from], records.traction[first + g]);
    records.traction[first + g][weight] = records.traction[from][weight];
  });
}

template <int D>
void Images<D>::fill_nominal(PairRecords<D>& records, std::size_t first) const {
  for_each_image([&](std::size_t g, std::size_t from, const Transform<D>& transform) {
    turn_tensor<D>(transform.turn, records.nominal[from], records.nominal[first + g]);
    records.nominal[first + g][D * D] = records.nominal[from][D * D];
  });
}

template <int D>
void Images<D>::fill_medium(PairRecords<D>& records, std::size_t first) const {
  for_each_image([&](std::size_t g, std::size_t from, const Transform<D>&) {
    std::copy_n(records.medium[from], Records<4>::size, records.medium[first + g]);
  });
}

template <int D>
void Images<D>::fill_responses(PairRecords<D>& records, std::size_t first) const {
  if (records.response.count() == 0) return;
  for_each_image([&](std::size_t g, std::size_t from, const Transform<D>& transform) {
    std::copy_n(records.response[from], Records<8>::size, records.response[first + g]);
    if (records.correction.count() != 0)
      turn_symmetric<D>(transform.turn, records.correction[from], records.correction[first + g]);
    if (records.slope.count() == 0) return;
    const double* slope = records.slope[from];
    double* image = records.slope[first + g];
    turn_tensor<D>(transform.turn, slope + SlopeField<D>::velocity, image + SlopeField<D>::velocity);
    turn_vector<D>(transform.turn, slope + SlopeField<D>::stress, image + SlopeField<D>::stress);
    image[SlopeField<D>::body] = slope[SlopeField<D>::body];
  });
}

template <int D>
void Images<D>::widen(Vec<D>& least, Vec<D>& greatest) const {
  const Vec<D> middle = 0.5 * (least + greatest), half = 0.5 * (greatest - least);
  for (const auto& transform : transforms_) {
    const Vec<D> turned = transform.turn * middle, reach = transform.turn.cwiseAbs() * half;
    least = least.cwiseMin(turned - reach);
    greatest = greatest.cwiseMax(turned + reach);
  }
}

template class Images<1>;
template class Images<2>;
template class Images<3>;

}  // namespace anvil
