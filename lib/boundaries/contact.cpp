// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/boundaries/contact.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <limits>

#include "anvil/core/field_keys.hpp"

namespace anvil {
namespace {

namespace geometry = boost::geometry;
template <int D>
using Point = geometry::model::point<double, D, geometry::cs::cartesian>;
template <int D>
using Box = geometry::model::box<Point<D>>;

template <int D, int Axis = 0>
void set_point(Point<D>& point, const Vec<D>& place) {
  geometry::set<Axis>(point, place[Axis]);
  if constexpr (Axis + 1 < D) set_point<D, Axis + 1>(point, place);
}

template <int D>
Box<D> box_between(const Vec<D>& low, const Vec<D>& high) {
  Box<D> box;
  set_point<D>(box.min_corner(), low);
  set_point<D>(box.max_corner(), high);
  return box;
}

/// Barycentric weights of the point of a triangle that is closest to `place` (Ericson 2005, chapter 5.1.5).
std::array<double, 3> closest_in_triangle(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, const Vec<3>& place) {
  const Vec<3> ab = b - a, ac = c - a, ap = place - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};
  const Vec<3> bp = place - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};
  const double of_c = d1 * d4 - d3 * d2;
  if (of_c <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {1.0 - d1 / (d1 - d3), d1 / (d1 - d3), 0.0};
  const Vec<3> cp = place - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};
  const double of_b = d5 * d2 - d1 * d6;
  if (of_b <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {1.0 - d2 / (d2 - d6), 0.0, d2 / (d2 - d6)};
  const double of_a = d3 * d6 - d5 * d4;
  if (of_a <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double part = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0.0, 1.0 - part, part};
  }
  const double sum = of_a + of_b + of_c;
  return {of_a / sum, of_b / sum, of_c / sum};
}

}  // namespace

template <int D>
Contact<D>::Contact(std::vector<Surface<D>> surfaces, FieldStore& fields, double spacing)
    : surfaces_(std::move(surfaces)),
      position_(fields.vector<D>(field::position)),
      velocity_(fields.vector<D>(field::velocity)),
      mass_(fields.scalar(field::mass)),
      reach_(0.5 * spacing),
      skin_(0.5 * spacing),
      side_tolerance_(0.05 * spacing) {}

template <int D>
Vec<D> Contact<D>::normal_of(const BodyFacet<D>& facet) const {
  const auto at = [&](std::size_t corner) { return Vec<D>(position_[static_cast<std::size_t>(facet[corner])]); };
  if constexpr (D == 3) return (at(2) - at(0)).cross(at(3) - at(1)).normalized();
  if constexpr (D == 2) {
    const Vec<2> along = at(1) - at(0);
    return Vec<2>(along[1], -along[0]).normalized();
  }
  if constexpr (D == 1) return Vec<1>(static_cast<double>(facet[1]));
}

/// A quadrilateral is taken as the four triangles around the mean of its corners: no diagonal is preferred.
template <int D>
typename Contact<D>::Closest Contact<D>::closest_on(const BodyFacet<D>& facet, const Vec<D>& place) const {
  const auto at = [&](std::size_t corner) { return Vec<D>(position_[static_cast<std::size_t>(facet[corner])]); };
  Closest closest{};
  if constexpr (D == 1) {
    closest = {at(0), {1.0, 0.0}};
  } else if constexpr (D == 2) {
    const Vec<2> along = at(1) - at(0);
    const double part = std::clamp((place - at(0)).dot(along) / along.squaredNorm(), 0.0, 1.0);
    closest = {at(0) + part * along, {1.0 - part, part}};
  } else {
    const Vec<3> middle = 0.25 * (at(0) + at(1) + at(2) + at(3));
    double least = std::numeric_limits<double>::max();
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t next = (k + 1) % 4;
      const auto weight = closest_in_triangle(at(k), at(next), middle, place);
      const Vec<3> point = weight[0] * at(k) + weight[1] * at(next) + weight[2] * middle;
      if ((point - place).squaredNorm() >= least) continue;
      least = (point - place).squaredNorm();
      closest.point = point;
      closest.weight.fill(0.25 * weight[2]);
      closest.weight[k] += weight[0];
      closest.weight[next] += weight[1];
    }
  }
  return closest;
}

template <int D>
auto Contact<D>::meeting_of(std::int32_t particle, const BodyFacet<D>& facet) const -> std::optional<Meeting> {
  const Vec<D> place = position_[static_cast<std::size_t>(particle)];
  const Closest closest = closest_on(facet, place);
  const Vec<D> normal = normal_of(facet);
  const Vec<D> apart = place - closest.point;
  const double gap = normal.dot(apart);
  if (std::abs(gap) > reach_ || (apart - gap * normal).norm() > side_tolerance_) return std::nullopt;
  double compliance = 1.0 / mass_[static_cast<std::size_t>(particle)];
  for (std::size_t k = 0; k < facet.size(); ++k)
    if (closest.weight[k] > 0.0)
      compliance += closest.weight[k] * closest.weight[k] / mass_[static_cast<std::size_t>(facet[k])];
  return Meeting{particle, facet, closest.weight, normal, gap, apart.norm(), compliance, 0.0};
}

template <int D>
void Contact<D>::update_outward(std::size_t surface) {
  const std::vector<std::int32_t>& particles = surfaces_[surface].particles;
  outward_[surface].assign(particles.size(), Vec<D>::Zero());
  for (const BodyFacet<D>& facet : surfaces_[surface].facets) {
    const Vec<D> normal = normal_of(facet);
    for (std::size_t k = 0; k < corners; ++k) {
      const auto found = std::lower_bound(particles.begin(), particles.end(), facet[k]);
      outward_[surface][static_cast<std::size_t>(found - particles.begin())] += normal;
    }
  }
}

/// Facets that a particle can meet before one of them moves by half the skin.
template <int D>
void Contact<D>::find_candidates(std::size_t points, std::size_t facets) {
  using Entry = std::pair<Box<D>, std::int32_t>;
  const std::vector<BodyFacet<D>>& others = surfaces_[facets].facets;
  std::vector<Entry> boxes;
  for (std::size_t f = 0; f < others.size(); ++f) {
    Vec<D> low = Vec<D>::Constant(std::numeric_limits<double>::max()), high = -low;
    for (std::size_t k = 0; k < corners; ++k) {
      const Vec<D> corner = position_[static_cast<std::size_t>(others[f][k])];
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
    boxes.emplace_back(box_between<D>(low.array() - (reach_ + skin_), high.array() + (reach_ + skin_)),
                       static_cast<std::int32_t>(f));
  }
  const geometry::index::rtree<Entry, geometry::index::rstar<8>> tree(boxes);
  std::vector<Entry> near;
  Candidates& found = candidates_.emplace_back(Candidates{points, facets, {0}, {}});
  for (const std::int32_t particle : surfaces_[points].particles) {
    const Vec<D> place = position_[static_cast<std::size_t>(particle)];
    near.clear();
    tree.query(geometry::index::intersects(box_between<D>(place, place)), std::back_inserter(near));
    for (const Entry& entry : near) found.facets.push_back(entry.second);
    // By number, so that the first of equal facets does not depend on the tree.
    std::sort(found.facets.begin() + found.end.back(), found.facets.end());
    found.end.push_back(static_cast<std::int32_t>(found.facets.size()));
  }
}

/// Each particle of one surface meets the nearest facet of the other that faces it. Of facets around one edge or corner
/// that are equally near, the one that faces it most: the sides of a bar meet nothing when its end does.
template <int D>
void Contact<D>::meet(const Candidates& candidates) {
  const double same_distance = 1e-9 * reach_;
  const std::vector<std::int32_t>& particles = surfaces_[candidates.points].particles;
  const std::vector<BodyFacet<D>>& others = surfaces_[candidates.surface].facets;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    std::optional<Meeting> nearest;
    double least = std::numeric_limits<double>::max(), most_opposed = 0.0;
    for (std::int32_t k = candidates.end[p]; k < candidates.end[p + 1]; ++k) {
      const auto facet = static_cast<std::size_t>(candidates.facets[static_cast<std::size_t>(k)]);
      const std::optional<Meeting> meeting = meeting_of(particles[p], others[facet]);
      if (!meeting) continue;
      const double opposed = -meeting->normal.dot(outward_[candidates.points][p]);
      const double distance = meeting->distance;
      if (opposed <= 0.0 || distance > least + same_distance) continue;
      if (distance > least - same_distance && opposed <= most_opposed) continue;
      nearest = meeting;
      least = distance;
      most_opposed = opposed;
    }
    if (nearest) meetings_.push_back(*nearest);
  }
}

template <int D>
bool Contact<D>::moved_by_half_the_skin() const {
  std::size_t k = 0;
  for (const Surface<D>& surface : surfaces_)
    for (const std::int32_t particle : surface.particles)
      if ((Vec<D>(position_[static_cast<std::size_t>(particle)]) - searched_[k++]).squaredNorm() > 0.25 * skin_ * skin_)
        return true;
  return false;
}

template <int D>
void Contact<D>::find_meetings() {
  if (searched_.empty() || moved_by_half_the_skin()) {
    searched_.clear();
    for (const Surface<D>& surface : surfaces_)
      for (const std::int32_t particle : surface.particles)
        searched_.emplace_back(position_[static_cast<std::size_t>(particle)]);
    candidates_.clear();
    for (std::size_t a = 0; a < surfaces_.size(); ++a)
      for (std::size_t b = 0; b < surfaces_.size(); ++b)
        if (a != b) find_candidates(a, b);
  }
  meetings_.clear();
  outward_.resize(surfaces_.size());
  for (std::size_t a = 0; a < surfaces_.size(); ++a) update_outward(a);
  for (const Candidates& candidates : candidates_) meet(candidates);
}

template <int D>
double Contact<D>::deepest_penetration() {
  find_meetings();
  double deepest = 0.0;
  for (const Meeting& meeting : meetings_) deepest = std::max(deepest, -meeting.gap);
  return deepest;
}

template <int D>
double Contact<D>::approach(const Meeting& meeting) const {
  Vec<D> relative = velocity_[static_cast<std::size_t>(meeting.particle)];
  for (std::size_t k = 0; k < meeting.facet.size(); ++k)
    if (meeting.weight[k] > 0.0) relative -= meeting.weight[k] * velocity_[static_cast<std::size_t>(meeting.facet[k])];
  return meeting.normal.dot(relative);
}

template <int D>
void Contact<D>::push(const Meeting& meeting, double impulse) {
  const auto give = [&](std::int32_t particle, double part) {
    const auto i = static_cast<std::size_t>(particle);
    velocity_[i] += part / mass_[i] * meeting.normal;
  };
  give(meeting.particle, impulse);
  for (std::size_t k = 0; k < meeting.facet.size(); ++k)
    if (meeting.weight[k] > 0.0) give(meeting.facet[k], -impulse * meeting.weight[k]);
}

template <int D>
void Contact<D>::correct_velocities(double time_step) {
  // Opposite particles meet each other from both sides and are done after one sweep; others settle in a few.
  constexpr int most_sweeps = 20;
  constexpr double settled = 1e-12;  // of the largest impulse
  find_meetings();
  double largest = 0.0;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double change = 0.0;
    for (Meeting& meeting : meetings_) {
      const double least = -std::max(meeting.gap, 0.0) / time_step;
      const double before = meeting.impulse;
      meeting.impulse = std::max(0.0, before + (least - approach(meeting)) / meeting.compliance);
      if (meeting.impulse == before) continue;
      push(meeting, meeting.impulse - before);
      change = std::max(change, std::abs(meeting.impulse - before));
      largest = std::max(largest, meeting.impulse);
    }
    if (change <= settled * largest) break;
  }
}

template <int D>
double Contact<D>::loss(const double* start_velocity, int stride) const {
  double work = 0.0;
  const auto twice_mean = [&](std::int32_t particle) {
    const auto i = static_cast<std::size_t>(particle);
    return Vec<D>(velocity_[i] + Eigen::Map<const Vec<D>>(start_velocity + i * static_cast<std::size_t>(stride)));
  };
  for (const Meeting& meeting : meetings_) {
    if (meeting.impulse == 0.0) continue;
    Vec<D> relative = twice_mean(meeting.particle);
    for (std::size_t k = 0; k < meeting.facet.size(); ++k)
      if (meeting.weight[k] > 0.0) relative -= meeting.weight[k] * twice_mean(meeting.facet[k]);
    work += 0.5 * meeting.impulse * meeting.normal.dot(relative);
  }
  return -work;
}

template <int D>
double Contact<D>::impulse() const {
  double sum = 0.0;
  for (const Meeting& meeting : meetings_) sum += meeting.impulse;
  return sum;
}

template class Contact<1>;
template class Contact<2>;
template class Contact<3>;

}  // namespace anvil
