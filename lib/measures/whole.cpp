// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/whole.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "anvil/core/tensor.hpp"

namespace anvil {
namespace {

Vec<3> unit_normal(const Plane& plane) { return Vec<3>(plane.normal.data()).normalized(); }

/// Into how many parts a model between the planes divides a half turn.
double parts_between(const Plane& one, const Plane& other) {
  const double cosine = std::clamp(-unit_normal(one).dot(unit_normal(other)), -1.0, 1.0);
  return std::numbers::pi / std::acos(cosine);
}

Plane mirrored(const Plane& plane, const Plane& mirror) {
  const Vec<3> at(mirror.point.data()), normal = unit_normal(mirror), point(plane.point.data());
  const Vec<3> place = point - 2.0 * normal.dot(point - at) * normal;
  const Vec<3> turned = unit_normal(plane) - 2.0 * normal.dot(unit_normal(plane)) * normal;
  return {{place[0], place[1], place[2]}, {turned[0], turned[1], turned[2]}};
}

}  // namespace

/// Each mirroring in one of the planes that bound the model doubles its opening; the last one, of a half turn, is that
/// in the plane it began with.
std::vector<Plane> planes_to_the_whole(const std::vector<Plane>& symmetry_planes) {
  constexpr double rounding = 1e-6;
  std::vector<Plane> planes = symmetry_planes;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      const double doublings = std::log2(parts_between(planes[i], planes[j]));
      if (!(doublings > 1.5) || std::abs(doublings - std::round(doublings)) > rounding) continue;
      std::vector<Plane> whole;
      Plane edge = planes[j];
      for (int k = 0; k < std::lround(doublings); ++k) {
        whole.push_back(edge);
        edge = mirrored(planes[i], edge);
      }
      planes.erase(planes.begin() + static_cast<std::ptrdiff_t>(j));
      planes.insert(planes.begin() + static_cast<std::ptrdiff_t>(i), whole.begin(), whole.end());
      return planes;
    }
  }
  return planes;
}

}  // namespace anvil
