// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/shape.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "anvil/core/error.hpp"
#include "anvil/scene/cut.hpp"
#include "anvil/scene/ring.hpp"

namespace anvil {
namespace {

constexpr double pi = std::numbers::pi;

template <int D>
Vec<D> to_vector(const std::vector<double>& numbers) {
  if (numbers.size() != static_cast<std::size_t>(D))
    throw InputError("a shape in " + std::to_string(D) + " dimensions was given a vector of " +
                     std::to_string(numbers.size()));
  return Vec<D>(numbers.data());
}

/// A box along the axes, or its half in front of a cut through its middle; in one dimension an interval.
template <int D>
class Box final : public Shape<D> {
 public:
  Box(const Vec<D>& lower, const Vec<D>& upper, const std::optional<Cut<D>>& cut = std::nullopt)
      : centre_(0.5 * (lower + upper)), size_(upper - lower), cut_(cut) {
    if (!(size_.minCoeff() > 0.0)) throw InputError("every component of max must be larger than that of min");
  }
  [[nodiscard]] Vec<D> centre() const override { return centre_; }
  [[nodiscard]] Vec<D> size() const override { return size_; }
  [[nodiscard]] bool ends_in_planes(int) const override { return true; }
  [[nodiscard]] bool contains(const Vec<D>& offset) const override {
    if (cut_ && cut_->height(offset) < -1e-12 * size_.norm()) return false;
    return (offset.array().abs() <= 0.5 * size_.array()).all();
  }
  [[nodiscard]] double volume() const override { return cut_ ? 0.5 * size_.prod() : size_.prod(); }
  [[nodiscard]] double reach(const Vec<D>& direction) const override {
    if (!cut_) return 0.5 * direction.cwiseAbs().dot(size_);
    double farthest = 0.0;  // the middle is part of either half
    for (unsigned at = 0; at < 1U << D; ++at) {
      const Vec<D> corner = corner_at(at);
      const double height = cut_->height(corner);
      if (height >= 0.0) farthest = std::max(farthest, direction.dot(corner));
      for (int axis = 0; axis < D; ++axis) {
        const Vec<D> other = corner_at(at ^ (1U << axis));
        if (height >= 0.0 || cut_->height(other) <= 0.0) continue;
        const double part = height / (height - cut_->height(other));
        farthest = std::max(farthest, direction.dot(corner + part * (other - corner)));
      }
    }
    return farthest;
  }

 private:
  /// A bit per axis: on its upper side.
  [[nodiscard]] Vec<D> corner_at(unsigned sides) const {
    Vec<D> corner = 0.5 * size_;
    for (int axis = 0; axis < D; ++axis)
      if ((sides >> axis & 1U) == 0) corner[axis] = -corner[axis];
    return corner;
  }

  Vec<D> centre_;
  Vec<D> size_;
  std::optional<Cut<D>> cut_;
};

/// A round bar along one of the axes.
class Cylinder final : public Shape<3> {
 public:
  explicit Cylinder(const Parameters& keys)
      : axis_(keys.text("axis")[0] - 'x'), radius_(keys.number("radius")), length_(keys.number("length")) {
    centre_ = to_vector<3>(keys.numbers("base"));
    centre_[axis_] += 0.5 * length_;
  }
  [[nodiscard]] Vec<3> centre() const override { return centre_; }
  [[nodiscard]] Vec<3> size() const override {
    Vec<3> size = Vec<3>::Constant(2.0 * radius_);
    size[axis_] = length_;
    return size;
  }
  [[nodiscard]] bool ends_in_planes(int axis) const override { return axis == axis_; }
  [[nodiscard]] bool contains(const Vec<3>& offset) const override {
    return std::abs(offset[axis_]) <= 0.5 * length_ && across(offset) <= radius_;
  }
  [[nodiscard]] double volume() const override { return pi * radius_ * radius_ * length_; }
  [[nodiscard]] double reach(const Vec<3>& direction) const override {
    return 0.5 * length_ * std::abs(direction[axis_]) + radius_ * across(direction);
  }

 private:
  /// Length of the part of a vector that is normal to the axis.
  [[nodiscard]] double across(Vec<3> vector) const {
    vector[axis_] = 0.0;
    return vector.norm();
  }
  int axis_;
  double radius_;
  double length_;
  Vec<3> centre_;
};

/// The region between two circles, or the half of it above their centre, or the quarter above and to the right, or the
/// wedge of an opening that begins at the x axis; with an inner radius of zero a disc.
class Ring final : public Shape<2> {
 public:
  explicit Ring(const Parameters& keys)
      : middle_(to_vector<2>(keys.numbers("centre"))),
        inner_(keys.number("inner_radius")),
        outer_(keys.number("outer_radius")),
        turn_(keys.number("angle")),
        opening_(ring_opening(keys)) {
    if (!(outer_ > inner_)) throw InputError("outer_radius must be larger than inner_radius");
    if (!is_full() && turn_ != 0.0) throw InputError("only a full ring can be turned by an angle");
    begin_ = {opening_ > 0.5 * pi ? -outer_ : 0.0, is_full() ? -outer_ : 0.0};
  }
  [[nodiscard]] Vec<2> centre() const override { return middle_ + 0.5 * (begin_ + Vec<2>::Constant(outer_)); }
  [[nodiscard]] Vec<2> size() const override { return Vec<2>::Constant(outer_) - begin_; }
  [[nodiscard]] bool ends_in_planes(int) const override { return false; }
  [[nodiscard]] bool contains(const Vec<2>& offset) const override {
    const Vec<2> arm = offset + (centre() - middle_);
    const Vec<2> along(std::cos(opening_), std::sin(opening_));  // the wedge's second edge
    if (!is_full() && (arm[1] < 0.0 || arm[1] * along[0] > arm[0] * along[1] + 1e-12 * outer_)) return false;
    return arm.norm() >= inner_ && arm.norm() <= outer_;
  }
  [[nodiscard]] Vec<2> turned(const Vec<2>& offset) const override {
    if (turn_ == 0.0) return offset;
    const double cosine = std::cos(turn_), sine = std::sin(turn_);
    return {cosine * offset[0] - sine * offset[1], sine * offset[0] + cosine * offset[1]};
  }
  [[nodiscard]] double volume() const override { return 0.5 * opening_ * (outer_ - inner_) * (outer_ + inner_); }
  [[nodiscard]] double reach(const Vec<2>& direction) const override {
    const double all_round = outer_ * direction.norm();
    if (is_full()) return all_round;
    double angle = std::atan2(direction[1], direction[0]);
    if (angle < 0.0) angle += 2.0 * pi;
    double farthest = angle <= opening_ ? all_round : -all_round;  // on the outer arc, or at a corner
    for (const double edge : {0.0, opening_})
      for (const double radius : {inner_, outer_})
        farthest = std::max(farthest, radius * direction.dot(Vec<2>(std::cos(edge), std::sin(edge))));
    return farthest - direction.dot(centre() - middle_);
  }

 private:
  [[nodiscard]] bool is_full() const { return opening_ > pi; }

  Vec<2> middle_;
  double inner_;
  double outer_;
  double turn_;     // rad
  double opening_;  // rad
  Vec<2> begin_;    // lowest corner of the box around it, from the middle
};

/// The inside of a closed path; what its boundary holds belongs to it up to rounding.
class Polygon final : public Shape<2> {
 public:
  explicit Polygon(const Parameters& keys) {
    for (const auto& point : keys.points("points")) vertices_.push_back(to_vector<2>(point));
    if (vertices_.size() < 3) throw InputError("a polygon needs three points or more");
    least_ = greatest_ = vertices_[0];
    for (const auto& vertex : vertices_) {
      least_ = least_.cwiseMin(vertex);
      greatest_ = greatest_.cwiseMax(vertex);
    }
    for_each_edge([&](const Vec<2>& from, const Vec<2>& to) { area_ += 0.5 * (from[0] * to[1] - from[1] * to[0]); });
    area_ = std::abs(area_);
    if (!(area_ > 0.0)) throw InputError("the polygon has no area");
  }
  [[nodiscard]] Vec<2> centre() const override { return 0.5 * (least_ + greatest_); }
  [[nodiscard]] Vec<2> size() const override { return greatest_ - least_; }
  [[nodiscard]] bool ends_in_planes(int) const override { return false; }
  /// An odd number of edges lies to the right of an inner point.
  [[nodiscard]] bool contains(const Vec<2>& offset) const override {
    const Vec<2> place = centre() + offset;
    bool inside = false;
    for_each_edge([&](const Vec<2>& from, const Vec<2>& to) {
      if ((from[1] > place[1]) != (to[1] > place[1]) &&
          place[0] < from[0] + (place[1] - from[1]) / (to[1] - from[1]) * (to[0] - from[0]))
        inside = !inside;
    });
    return inside;
  }
  [[nodiscard]] double volume() const override { return area_; }
  [[nodiscard]] double reach(const Vec<2>& direction) const override {
    double furthest = std::numeric_limits<double>::lowest();
    for (const auto& vertex : vertices_) furthest = std::max(furthest, direction.dot(vertex - centre()));
    return furthest;
  }

 private:
  template <class Visit>
  void for_each_edge(Visit&& visit) const {
    for (std::size_t i = 0; i < vertices_.size(); ++i) visit(vertices_[i], vertices_[(i + 1) % vertices_.size()]);
  }
  std::vector<Vec<2>> vertices_;
  Vec<2> least_, greatest_;
  double area_ = 0.0;
};

template <int D>
std::unique_ptr<Shape<D>> make_box(const Parameters& keys) {
  return std::make_unique<Box<D>>(to_vector<D>(keys.numbers("min")), to_vector<D>(keys.numbers("max")),
                                  cut_of<D>({"box", keys}));
}

std::unique_ptr<Shape<1>> make_interval(const Parameters& keys) {
  return std::make_unique<Box<1>>(Vec<1>(keys.number("min")), Vec<1>(keys.number("max")));
}

/// A kind of shape and what makes it, for the dimensions it exists in.
struct ShapeRow {
  EntryKind kind;
  std::unique_ptr<Shape<1>> (*make_1d)(const Parameters&) = nullptr;
  std::unique_ptr<Shape<2>> (*make_2d)(const Parameters&) = nullptr;
  std::unique_ptr<Shape<3>> (*make_3d)(const Parameters&) = nullptr;

  template <int D>
  [[nodiscard]] auto make() const {
    if constexpr (D == 1) return make_1d;
    if constexpr (D == 2) return make_2d;
    if constexpr (D == 3) return make_3d;
  }
};

Key corner(std::string_view name, std::string_view help) {
  return {.name = name, .kind = ValueKind::vector, .unit = "m", .help = help};
}

Key length(std::string_view name, std::string_view help, Range range = Range::positive) {
  return {.name = name, .unit = "m", .range = range, .help = help};
}

Key origin(std::string_view name, std::string_view help) {
  return {.name = name, .kind = ValueKind::vector, .unit = "m", .standard = std::vector<double>{0.0}, .help = help};
}

const std::vector<ShapeRow>& shape_rows() {
  static const std::vector<ShapeRow> rows = {
      {.kind = {.type = "box",
                .summary = "A box along the axes, a rectangle in 2D; each side a whole number of spacings",
                .keys = {corner("min", "lowest corner"),
                         corner("max", "highest corner"),
                         {.name = "half",
                          .kind = ValueKind::vector,
                          .help = "leaves the half of the box that this direction points to from its middle, such as "
                                  "[1, -1, 0] where a symmetry plane runs along the diagonal",
                          .optional = true,
                          .derived = "the whole box"}},
                .dimensions = {2, 3}},
       .make_2d = make_box<2>,
       .make_3d = make_box<3>},
      {.kind = {.type = "cylinder",
                .summary = "A round bar along an axis; its length a whole number of spacings",
                .keys = {origin("base", "centre of the end with the lowest coordinate"),
                         {.name = "axis",
                          .kind = ValueKind::choice,
                          .standard = "z",
                          .help = "direction of the bar",
                          .choices = {"x", "y", "z"}},
                         length("radius", "radius"),
                         length("length", "length along the axis")},
                .dimensions = {3}},
       .make_3d = [](const Parameters& keys) -> std::unique_ptr<Shape<3>> { return std::make_unique<Cylinder>(keys); }},
      {.kind = {.type = "interval",
                .summary = "A stretch of the line; a whole number of spacings",
                .keys = {length("min", "lower end", Range::any), length("max", "upper end", Range::any)},
                .dimensions = {1}},
       .make_1d = make_interval},
      {.kind = {.type = "polygon",
                .summary = "The inside of a closed path",
                .keys = {{.name = "points",
                          .kind = ValueKind::points,
                          .unit = "m",
                          .help = "its corners in turn; it ends where it began"}},
                .dimensions = {2}},
       .make_2d = [](const Parameters& keys) -> std::unique_ptr<Shape<2>> { return std::make_unique<Polygon>(keys); }},
      {.kind = {.type = "ring",
                .summary = "The region between two circles, a disc when the inner radius is zero",
                .keys = {origin("centre", "centre of the circles"),
                         length("inner_radius", "radius of the hole", Range::not_negative),
                         length("outer_radius", "radius of the outside"),
                         {.name = "sector",
                          .kind = ValueKind::choice,
                          .standard = "full",
                          .help = "part of the ring: half is the one with y above the centre, quarter the one with x "
                                  "above it too, wedge what lies within the opening from the x axis on; set symmetry "
                                  "planes at the cuts",
                          .choices = {"full", "half", "quarter", "wedge"}},
                         {.name = "opening",
                          .standard = 0.0,
                          .help =
                              "of a wedge, in radians, up to a quarter: whole parts of a turn, 2 pi / n with an even "
                              "n, give the ring's answer between two symmetry planes"},
                         {.name = "angle",
                          .standard = 0.0,
                          .help = "in radians, by which the particles of a full ring are turned about its centre"}},
                .dimensions = {2}},
       .make_2d = [](const Parameters& keys) -> std::unique_ptr<Shape<2>> { return std::make_unique<Ring>(keys); }},
  };
  return rows;
}

}  // namespace

std::span<const EntryKind> shape_kinds() {
  static const std::vector<EntryKind> kinds = [] {
    std::vector<EntryKind> all;
    for (const ShapeRow& row : shape_rows()) all.push_back(row.kind);
    return all;
  }();
  return kinds;
}

template <int D>
std::unique_ptr<Shape<D>> make_shape(const TypedEntry& entry) {
  for (const ShapeRow& row : shape_rows())
    if (row.kind.type == entry.type && row.make<D>() != nullptr) return row.make<D>()(entry.parameters);
  throw InputError("there is no shape '" + entry.type + "' in " + std::to_string(D) + " dimensions");
}

template std::unique_ptr<Shape<1>> make_shape<1>(const TypedEntry& entry);
template std::unique_ptr<Shape<2>> make_shape<2>(const TypedEntry& entry);
template std::unique_ptr<Shape<3>> make_shape<3>(const TypedEntry& entry);

}  // namespace anvil
