// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/boundaries/wall_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

/// To the right of a direction: where the wall is.
Vec<2> right_of(const Vec<2>& direction) { return Vec<2>(direction[1], -direction[0]).normalized(); }

/// A path and the wall to the right of it; closed paths repeat no vertex.
class Path {
 public:
  Path(const std::vector<Vec<2>>& vertices, bool closed) : vertices_(vertices), closed_(closed) {}

  [[nodiscard]] std::size_t count() const { return vertices_.size(); }
  [[nodiscard]] Vec<2> edge(std::size_t i) const { return at(i + 1) - at(i); }
  [[nodiscard]] const Vec<2>& at(std::size_t i) const { return vertices_[i % count()]; }
  [[nodiscard]] bool is_end(std::size_t i) const { return !closed_ && (i == 0 || i + 1 == count()); }
  [[nodiscard]] Vec<2> right_after(std::size_t i) const {
    return right_of(!closed_ && i + 1 == count() ? edge(i - 1) : edge(i));
  }
  [[nodiscard]] Vec<2> right_before(std::size_t i) const {
    return right_of(!closed_ && i == 0 ? edge(0) : edge((i + count() - 1) % count()));
  }
  /// Whether rows are cut into pieces there: the path turns by more than 30 degrees. Rows run on through gentler turns.
  [[nodiscard]] bool is_corner(std::size_t i) const {
    return !is_end(i) && right_before(i).dot(right_after(i)) < std::cos(std::numbers::pi / 6.0);
  }
  /// The vertex moved into the wall so that the edges beside it keep their distance.
  [[nodiscard]] Vec<2> moved(std::size_t i, double distance) const {
    const Vec<2> before = right_before(i), after = right_after(i);
    const double cosine = std::max(before.dot(after), -0.9);  // a needle's row would end far away
    return at(i) + distance / (1.0 + cosine) * (before + after);
  }

 private:
  const std::vector<Vec<2>>& vertices_;
  bool closed_;
};

/// Points along a row between two corners, each of which holds one point, or ends, which lie half a spacing beyond the
/// last point. The point of the corner at the end is left to the row that begins there. Ascending.
std::vector<double> distances_along(double length, bool from_corner, bool to_corner, double spacing) {
  std::vector<double> places;
  if (from_corner == to_corner) {
    const double parts = std::max(1.0, std::round(length / spacing)), first = from_corner ? 0.0 : 0.5;
    for (double m = 0.0; m < parts; m += 1.0) places.push_back((m + first) * length / parts);
    return places;
  }
  const double end = length - (0.5 - 1e-6) * spacing;
  for (double m = from_corner ? 0.0 : 1.0; m * spacing <= end; m += 1.0)
    places.push_back(from_corner ? m * spacing : length - m * spacing);
  if (!from_corner) std::reverse(places.begin(), places.end());
  return places;
}

/// The part of a path between two corners or ends, moved into the wall by `distance`.
void add_piece(const Path& path, std::size_t begin, std::size_t end, double distance, double spacing, int row,
               std::vector<WallPoint<2>>& points) {
  std::vector<Vec<2>> line;
  for (std::size_t i = begin; i <= end; ++i) line.push_back(path.moved(i % path.count(), distance));
  double length = 0.0;
  for (std::size_t k = 1; k < line.size(); ++k) length += (line[k] - line[k - 1]).norm();
  std::size_t k = 1;
  double passed = 0.0;
  for (const double place :
       distances_along(length, path.is_corner(begin % path.count()), path.is_corner(end % path.count()), spacing)) {
    while (k + 1 < line.size() && passed + (line[k] - line[k - 1]).norm() < place)
      passed += (line[k] - line[k - 1]).norm(), ++k;
    const double part = (line[k] - line[k - 1]).norm();
    const Vec<2> position = line[k - 1] + (part > 0.0 ? (place - passed) / part : 0.0) * (line[k] - line[k - 1]);
    const Vec<2> normal = -right_of(path.edge((begin + k - 1) % path.count()));
    points.push_back({position, normal, row});
  }
}

void add_path_row(const Path& path, bool closed, double distance, double spacing, int row,
                  std::vector<WallPoint<2>>& points) {
  std::vector<std::size_t> cuts;
  for (std::size_t i = 0; i < path.count(); ++i)
    if (path.is_corner(i) || path.is_end(i)) cuts.push_back(i);
  if (closed && cuts.empty()) cuts.push_back(0);  // round: one piece that meets itself
  for (std::size_t c = 0; c + 1 < cuts.size(); ++c)
    add_piece(path, cuts[c], cuts[c + 1], distance, spacing, row, points);
  if (closed) add_piece(path, cuts.back(), cuts.front() + path.count(), distance, spacing, row, points);
}

/// Leaves out points nearer than half a spacing to one before them.
template <int D>
std::vector<WallPoint<D>> without_crowding(const std::vector<WallPoint<D>>& points, double spacing) {
  std::vector<WallPoint<D>> kept;
  std::vector<std::pair<double, std::size_t>> by_x;  // of the kept ones
  const double limit = 0.5 * spacing;
  for (const auto& point : points) {
    const double x = point.position[0];
    auto near = std::lower_bound(by_x.begin(), by_x.end(), std::pair(x - limit, std::size_t{0}));
    bool crowded = false;
    for (; near != by_x.end() && near->first <= x + limit && !crowded; ++near)
      crowded = (kept[near->second].position - point.position).norm() < limit;
    if (crowded) continue;
    by_x.insert(std::upper_bound(by_x.begin(), by_x.end(), std::pair(x, kept.size())), {x, kept.size()});
    kept.push_back(point);
  }
  return kept;
}

template <int D>
Vec<D> corner_of(const Parameters& keys, const char* key) {
  return Vec<D>(keys.numbers(key).data());
}

}  // namespace

template <int D>
WallSurface<D>::WallSurface(const Parameters& keys) {
  if constexpr (D == 2) {
    if (!keys.has("path")) throw InputError("a wall in 2D is drawn by its path, a list of points");
    for (const auto& point : keys.points("path")) {
      if (point.size() != 2) throw InputError("each point of path must have two coordinates");
      path_.emplace_back(point[0], point[1]);
    }
    closed_ = keys.flag("closed");
    if (path_.size() < (closed_ ? 3 : 2)) throw InputError("path holds too few points");
    const std::size_t edges = closed_ ? path_.size() : path_.size() - 1;
    for (std::size_t i = 0; i < edges; ++i) {
      const Vec<2> edge = path_[(i + 1) % path_.size()] - path_[i];
      if (edge.norm() == 0.0) throw InputError("path holds the same point twice in a row");
      facets_.push_back({path_[i], -right_of(edge), {edge}});
    }
  } else if constexpr (D == 3) {
    if (!keys.has("min") || !keys.has("max")) throw InputError("a wall in 3D is drawn by min and max of its box");
    least_ = corner_of<3>(keys, "min");
    greatest_ = corner_of<3>(keys, "max");
    if (!((greatest_ - least_).minCoeff() > 0.0))
      throw InputError("every component of max must be larger than that of min");
    outside_ = keys.text("particles") == "outside";
    for (const auto& face : keys.texts("open"))
      open_[static_cast<std::size_t>(face[1] - 'x')][face[0] == '+' ? 1 : 0] = true;
    for (int a = 0; a < 3; ++a) {
      for (int upper = 0; upper < 2; ++upper) {
        if (open_[static_cast<std::size_t>(a)][static_cast<std::size_t>(upper)]) continue;
        Facet<3> facet{least_, Vec<3>::Unit(a) * ((upper == 1) == outside_ ? 1.0 : -1.0), {}};
        if (upper == 1) facet.corner[a] = greatest_[a];
        for (int k = 0; k < 2; ++k) {
          const int along = (a + 1 + k) % 3;
          facet.edges[static_cast<std::size_t>(k)] = Vec<3>::Unit(along) * (greatest_[along] - least_[along]);
        }
        facets_.push_back(facet);
      }
    }
  }
  if (facets_.empty()) throw InputError("a wall of dummy particles needs two or three dimensions and a closed face");
}

template <int D>
bool WallSurface<D>::crossed(const Vec<D>& from, const Vec<D>& to) const {
  return std::any_of(facets_.begin(), facets_.end(), [&](const Facet<D>& facet) {
    const double before = facet.normal.dot(from - facet.corner), after = facet.normal.dot(to - facet.corner);
    if (before < 0.0 || after >= 0.0) return false;
    const Vec<D> place = from + before / (before - after) * (to - from) - facet.corner;
    return std::all_of(facet.edges.begin(), facet.edges.end(), [&](const Vec<D>& edge) {
      const double part = place.dot(edge) / edge.squaredNorm();
      return part >= 0.0 && part <= 1.0;
    });
  });
}

/// In 3D the points of a lattice around the box or inside it, the row given by the face they are nearest to; layers of
/// open faces are left out.
template <int D>
void WallSurface<D>::add_row(double distance, double spacing, int row, std::vector<WallPoint<D>>& points) const {
  if constexpr (D == 2) {
    add_path_row(Path(path_, closed_), closed_, distance, spacing, row, points);
  } else if constexpr (D == 3) {
    const double outward = outside_ ? -distance : distance;
    const Vec<3> low = least_ - Vec<3>::Constant(outward), high = greatest_ + Vec<3>::Constant(outward);
    Vec<3> count, step;
    for (int a = 0; a < 3; ++a) {
      count[a] = std::max(1.0, std::round((high[a] - low[a]) / spacing));
      step[a] = (high[a] - low[a]) / count[a];
    }
    const auto on_face = [&](double index, int a, std::size_t upper) { return index == (upper == 1 ? count[a] : 0.0); };
    for (double i = 0.0; i <= count[0]; i += 1.0) {
      for (double j = 0.0; j <= count[1]; j += 1.0) {
        for (double k = 0.0; k <= count[2]; k += 1.0) {
          const double index[3] = {i, j, k};
          Vec<3> normal = Vec<3>::Zero();
          bool left_out = false;
          for (int a = 0; a < 3; ++a) {
            for (std::size_t upper = 0; upper < 2; ++upper) {
              if (!on_face(index[a], a, upper)) continue;
              if (open_[static_cast<std::size_t>(a)][upper]) left_out = true;
              normal[a] = ((upper == 1) == outside_ ? 1.0 : -1.0);
            }
          }
          if (left_out || normal.isZero()) continue;
          points.push_back({low + Vec<3>(i * step[0], j * step[1], k * step[2]), normal.normalized(), row});
        }
      }
    }
  }
}

template <int D>
std::vector<WallPoint<D>> WallSurface<D>::rows(double spacing, double first_row, int count) const {
  std::vector<WallPoint<D>> points;
  for (int row = 0; row < count; ++row) add_row((first_row + row) * spacing, spacing, row, points);
  return without_crowding(points, spacing);
}

template class WallSurface<1>;
template class WallSurface<2>;
template class WallSurface<3>;

}  // namespace anvil
