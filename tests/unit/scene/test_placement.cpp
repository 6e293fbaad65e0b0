// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/placement.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

constexpr double pi = std::numbers::pi;
using Keys = std::map<std::string, Value>;

BodyDescription body_of(const std::string& type, const Keys& keys) {
  BodyDescription body{.name = "body",
                       .shape = {type, {}},
                       .lattice = "cubic",
                       .rotation = {},
                       .jitter = 0.0,
                       .material = "copper",
                       .velocity = {},
                       .hydrostatic = false,
                       .radial_velocity = 0.0,
                       .deviatoric_stress = {}};
  for (const auto& [key, value] : keys) body.shape.parameters.set(key, value);
  return body;
}

BodyDescription box(const std::vector<double>& min, const std::vector<double>& max) {
  return body_of("box", {{"min", min}, {"max", max}});
}
BodyDescription interval(double min, double max) { return body_of("interval", {{"min", min}, {"max", max}}); }
BodyDescription ring(const std::vector<double>& centre, double inner, double outer) {
  return body_of("ring", {{"centre", centre},
                          {"inner_radius", inner},
                          {"outer_radius", outer},
                          {"sector", std::string("full")},
                          {"opening", 0.0},
                          {"angle", 0.0}});
}
BodyDescription shell(const std::string& lattice, const std::string& sector, double angle = 0.0) {
  BodyDescription body = ring({0.3, -0.2}, 80e-3, 100e-3);
  body.lattice = lattice;
  body.shape.parameters.set("sector", sector);
  body.shape.parameters.set("angle", angle);
  return body;
}
BodyDescription cylinder(const std::vector<double>& base, const std::string& axis, double radius, double length) {
  return body_of("cylinder", {{"base", base}, {"axis", axis}, {"radius", radius}, {"length", length}});
}

template <int D>
double total_volume(const PlacedBody<D>& placed) {
  return std::accumulate(placed.volumes.begin(), placed.volumes.end(), 0.0);
}

/// All volumes are the same double; their sum carries one rounding per particle at most.
template <int D>
void expect_exact_volume(const BodyDescription& body, double spacing, double exact) {
  const auto placed = place_body<D>(body, spacing);
  ASSERT_EQ(placed.positions.size(), placed.volumes.size());
  const double rounding = 1e-16 * static_cast<double>(placed.volumes.size()) + 1e-15;
  EXPECT_NEAR(total_volume(placed) / exact, 1.0, rounding) << body.shape.type << " at " << spacing;
}

/// Mirrors the body at its middle, axis by axis, and expects the same particles; `middle` is zero, so that no position
/// is rounded and the mirror image is exact.
template <int D>
void expect_mirror_symmetry(const BodyDescription& body, double spacing) {
  const auto placed = place_body<D>(body, spacing);
  const auto sorted = [](std::vector<Vec<D>> positions) {
    std::sort(positions.begin(), positions.end(), [](const auto& a, const auto& b) {
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    });
    return positions;
  };
  for (int axis = 0; axis < D; ++axis) {
    auto mirrored = placed.positions;
    for (auto& position : mirrored) position[axis] = 0.0 - position[axis];
    EXPECT_EQ(sorted(mirrored), sorted(placed.positions)) << body.shape.type << " along axis " << axis;
  }
}

TEST(Placement, VolumeIsExactForEveryShapeAndSpacing) {
  for (const double spacing : {0.8e-3, 0.4e-3, 0.533333e-3, 0.37e-3}) {
    expect_exact_volume<3>(box({-3.2e-3, -3.2e-3, 0}, {3.2e-3, 3.2e-3, 32e-3}), spacing, 6.4e-3 * 6.4e-3 * 32e-3);
    expect_exact_volume<2>(box({0, 0}, {4e-3, 6e-3}), spacing, 24e-6);
    expect_exact_volume<1>(interval(-1e-3, 7e-3), spacing, 8e-3);
    expect_exact_volume<2>(ring({0.1, 0}, 4e-3, 5e-3), spacing, pi * 9e-6);
    expect_exact_volume<2>(ring({0, 0}, 0.0, 5e-3), spacing, pi * 25e-6);
    for (const auto* axis : {"x", "y", "z"})
      expect_exact_volume<3>(cylinder({0, 0, 0}, axis, 3.2e-3, 32e-3), spacing, pi * 3.2e-3 * 3.2e-3 * 32e-3);
  }
}

TEST(Placement, LatticeIsMirrorSymmetric) {
  for (const double spacing : {0.8e-3, 0.7e-3, 0.37e-3}) {  // even and odd numbers of cells
    expect_mirror_symmetry<3>(box({-3.2e-3, -3.2e-3, -4e-3}, {3.2e-3, 3.2e-3, 4e-3}), spacing);
    expect_mirror_symmetry<3>(cylinder({0, -4e-3, 0}, "y", 3.2e-3, 8e-3), spacing);
    expect_mirror_symmetry<2>(ring({0, 0}, 2e-3, 5e-3), spacing);
    expect_mirror_symmetry<1>(interval(-4e-3, 4e-3), spacing);
  }
}

TEST(Placement, ParticlesFillTheBar) {
  const auto placed = place_body<3>(box({-3.2e-3, -3.2e-3, 0}, {3.2e-3, 3.2e-3, 32e-3}), 0.8e-3);
  EXPECT_EQ(placed.positions.size(), 2560u);
  Vec<3> lowest = placed.positions.front();
  Vec<3> highest = lowest;
  for (const auto& position : placed.positions) {
    lowest = lowest.cwiseMin(position);
    highest = highest.cwiseMax(position);
  }
  // Half a spacing inside every face, to the rounding of the coordinates.
  EXPECT_TRUE(lowest.isApprox(Vec<3>(-2.8e-3, -2.8e-3, 0.4e-3), 1e-14));
  EXPECT_TRUE(highest.isApprox(Vec<3>(2.8e-3, 2.8e-3, 31.6e-3), 1e-14));
  // 0.8e-3^3 m3 each
  EXPECT_NEAR(placed.volumes.front(), 5.12e-10, 1e-23);
}

TEST(Placement, NeighboursAreOneSpacingApart) {
  const auto placed = place_body<1>(interval(0.0, 8e-3), 0.1e-3);
  ASSERT_EQ(placed.positions.size(), 80u);
  for (std::size_t i = 1; i < placed.positions.size(); ++i)
    EXPECT_NEAR(placed.positions[i][0] - placed.positions[i - 1][0], 0.1e-3, 1e-17);  // rounding of 8e-3
}

TEST(Placement, RingLeavesTheHoleFree) {
  const auto placed = place_body<2>(ring({1.0, 2.0}, 80e-3, 100e-3), 2e-3);
  for (const auto& position : placed.positions) {
    const double distance = (position - Vec<2>(1.0, 2.0)).norm();
    EXPECT_GT(distance, 80e-3 - 1e-12);
    EXPECT_LT(distance, 100e-3 + 1e-12);
  }
  // The number of cells in a region approaches its area in cells; 2 % is the share of the cells cut by the two circles.
  EXPECT_NEAR(static_cast<double>(placed.positions.size()), pi * (1e4 - 6.4e3) / 4.0, 0.02 * pi * 3.6e3 / 4.0);
}

TEST(Placement, RefusesMoreParticlesThanFit) {
  EXPECT_THROW(place_body<3>(box({0, 0, 0}, {1, 1, 1}), 1e-9), InputError);
  EXPECT_THROW(place_body<3>(box({0, 0, 0}, {1e300, 1e300, 1e300}), 1e-300), InputError);
}

TEST(Placement, RefusesBodiesWithoutParticles) {
  EXPECT_THROW(place_body<2>(ring({0, 0}, 9.9e-3, 10e-3), 9e-3), InputError);
}

TEST(Placement, RefusesShapesOfAnotherDimension) {
  EXPECT_THROW(place_body<2>(interval(0.0, 1.0), 0.1), InputError);
  EXPECT_THROW(place_body<3>(ring({0, 0}, 0.0, 1.0), 0.1), InputError);
}

/// The farthest point of a shape in a direction, against the particles of a fine lattice.
TEST(Shape, ReachEnclosesItsParticles) {
  const auto body = cylinder({1e-3, 2e-3, 3e-3}, "x", 2e-3, 5e-3);
  const auto shape = make_shape<3>(body.shape);
  const double spacing = 0.1e-3;
  const auto placed = place_body<3>(body, spacing);
  for (const Vec<3>& direction : {Vec<3>(1, 0, 0), Vec<3>(0, 1, 0), Vec<3>(0, 0, -1), Vec<3>(0.6, 0.0, 0.8)}) {
    double farthest = 0.0;
    for (const auto& position : placed.positions)
      farthest = std::max(farthest, direction.dot(position - shape->centre()));
    EXPECT_GE(shape->reach(direction), farthest);
    EXPECT_LE(shape->reach(direction), farthest + 2.0 * spacing);  // centres stay up to two half diagonals inside
  }
}

TEST(ConcentricLayers, FillARingWithItsExactArea) {
  for (const double spacing : {2e-3, 0.8e-3, 0.37e-3}) {
    const auto placed = place_body<2>(shell("concentric", "full"), spacing);
    const double area = pi * (0.1 * 0.1 - 0.08 * 0.08);
    EXPECT_NEAR(total_volume(placed), area, 1e-12 * area);
    // Cells differ from squares of the spacing by what whole numbers of them ask for.
    for (const double volume : placed.volumes) EXPECT_NEAR(volume, spacing * spacing, 0.02 * spacing * spacing);
    for (const auto& position : placed.positions) {
      const double radius = (position - Vec<2>(0.3, -0.2)).norm();
      EXPECT_GT(radius, 80e-3 + 0.4 * spacing);
      EXPECT_LT(radius, 100e-3 - 0.4 * spacing);
    }
  }
}

TEST(Sectors, HoldTheirPartOfTheRing) {
  for (const std::string lattice : {"cubic", "concentric"}) {
    const auto full = place_body<2>(shell(lattice, "full"), 0.8e-3);
    for (const auto& [sector, parts] : {std::pair<std::string, std::size_t>{"half", 2}, {"quarter", 4}}) {
      const auto part = place_body<2>(shell(lattice, sector), 0.8e-3);
      EXPECT_EQ(parts * part.positions.size(), full.positions.size()) << lattice;
      EXPECT_NEAR(static_cast<double>(parts) * total_volume(part), total_volume(full), 1e-12 * total_volume(full));
      for (const auto& position : part.positions) {
        EXPECT_GT(position[1], -0.2);
        EXPECT_TRUE(parts == 2 || position[0] > 0.3);
        const auto found = std::find_if(full.positions.begin(), full.positions.end(), [&](const auto& other) {
          return (other - position).norm() < 1e-12;  // m: rounding of 0.1 m
        });
        EXPECT_NE(found, full.positions.end()) << lattice << " " << sector;
      }
    }
  }
}

/// A twelfth of a quarter.
TEST(Sectors, OpenAsFarAsAWedgeAsks) {
  const double opening = pi / 24.0;
  for (const std::string lattice : {"cubic", "concentric"}) {
    auto body = shell(lattice, "wedge");
    body.shape.parameters.set("opening", opening);
    const auto wedge = place_body<2>(body, 0.2e-3);
    const double area = 0.5 * opening * (0.1 * 0.1 - 0.08 * 0.08);
    EXPECT_NEAR(total_volume(wedge), area, (lattice == "cubic" ? 0.02 : 1e-12) * area);
    for (const auto& position : wedge.positions) {
      const Vec<2> arm = position - Vec<2>(0.3, -0.2);
      EXPECT_GT(arm[1], 0.0);
      EXPECT_LT(std::atan2(arm[1], arm[0]), opening);
    }
  }
  auto body = shell("concentric", "wedge");
  EXPECT_THROW(place_body<2>(body, 1e-3), InputError);  // of no opening
  body.shape.parameters.set("opening", 2.0);
  EXPECT_THROW(place_body<2>(body, 1e-3), InputError);
  body = shell("concentric", "quarter");
  body.shape.parameters.set("opening", 0.5);
  EXPECT_THROW(place_body<2>(body, 1e-3), InputError);
}

TEST(Rings, AreTurnedByTheirAngle) {
  const double turn = 0.3;
  Mat<2> rotation;
  rotation << std::cos(turn), -std::sin(turn), std::sin(turn), std::cos(turn);
  const Vec<2> centre(0.3, -0.2);
  for (const std::string lattice : {"cubic", "concentric"}) {
    const auto straight = place_body<2>(shell(lattice, "full"), 2e-3);
    const auto turned = place_body<2>(shell(lattice, "full", turn), 2e-3);
    ASSERT_EQ(straight.positions.size(), turned.positions.size());
    for (std::size_t i = 0; i < straight.positions.size(); ++i) {
      const Vec<2> expected = centre + rotation * (straight.positions[i] - centre);
      EXPECT_NEAR((turned.positions[i] - expected).norm(), 0.0, 1e-15);
    }
  }
  EXPECT_THROW(place_body<2>(shell("cubic", "half", turn), 2e-3), InputError);
}

template <int D>
Vec<D> outward_normal(const PlacedBody<D>& placed, const BodyFacet<D>& facet) {
  const auto at = [&](std::size_t corner) { return placed.positions[static_cast<std::size_t>(facet[corner])]; };
  if constexpr (D == 3) return (at(2) - at(0)).cross(at(3) - at(1)).normalized();
  if constexpr (D == 2) {
    const Vec<2> along = at(1) - at(0);
    return Vec<2>(along[1], -along[0]).normalized();
  }
}

/// Every facet looks away from the middle of a convex body.
template <int D>
void expect_facets_to_look_outward(const PlacedBody<D>& placed, const Vec<D>& middle) {
  for (const auto& facet : placed.facets) {
    Vec<D> centre = Vec<D>::Zero();
    for (const std::int32_t corner : facet) centre += placed.positions[static_cast<std::size_t>(corner)];
    centre /= static_cast<double>(facet.size());
    EXPECT_GT(outward_normal<D>(placed, facet).dot(centre - middle), 0.0);
  }
}

TEST(Placement, FaceLatticeStandsOnTheFacesAndSharesTheCells) {
  BodyDescription body = box({0.0, 0.0, 0.0}, {2e-3, 3e-3, 4e-3});
  body.lattice = "face_lattice";
  const auto placed = place_body<3>(body, 1e-3);
  EXPECT_EQ(placed.positions.size(), 3U * 4 * 5);
  EXPECT_NEAR(placed.volumes.front(), 1e-9 / 8.0, 1e-21);  // a corner
  double volume = 0.0, area = 0.0;
  for (const double one : placed.volumes) volume += one;
  EXPECT_NEAR(volume, 24e-9, 1e-20);
  EXPECT_EQ(placed.facets.size(), 2U * (2 * 3 + 3 * 4 + 2 * 4));
  for (const auto& point : placed.surface) area += point.area;
  EXPECT_NEAR(area, 52e-6, 1e-15);
  expect_facets_to_look_outward<3>(placed, Vec<3>(1e-3, 1.5e-3, 2e-3));
}

// A staircase that encloses what the cylinder does, for any number of spacings across.
TEST(Placement, FaceLatticeOfACylinderHasItsCrossSection) {
  for (const double spacing : {1e-3, 0.5e-3, 0.4e-3}) {
    BodyDescription body = cylinder({0, 0, 0}, "z", 3.2e-3, 4e-3);
    body.lattice = "face_lattice";
    const auto placed = place_body<3>(body, spacing);
    double area = 0.0;
    for (const auto& facet : placed.facets) {
      std::array<Vec<3>, 4> corner;
      for (std::size_t k = 0; k < 4; ++k) corner[k] = placed.positions[static_cast<std::size_t>(facet[k])];
      const Vec<3> twice = (corner[2] - corner[0]).cross(corner[3] - corner[1]);
      if (twice[2] < 0.0) area -= 0.5 * twice[2];  // of the lower end
    }
    EXPECT_NEAR(area, pi * 3.2e-3 * 3.2e-3, 1e-12) << spacing;
  }
}

TEST(Placement, FaceLatticeInTwoDimensionsHasFacetsAllRound) {
  BodyDescription body = box({0.0, 0.0}, {2e-3, 3e-3});
  body.lattice = "face_lattice";
  const auto placed = place_body<2>(body, 1e-3);
  EXPECT_EQ(placed.positions.size(), 12U);
  EXPECT_EQ(placed.facets.size(), 10U);
  expect_facets_to_look_outward<2>(placed, Vec<2>(1e-3, 1.5e-3));
}

/// The half of a square bar below its diagonal.
BodyDescription half_bar(const std::string& lattice) {
  BodyDescription body = box({0.0, 0.0, 0.0}, {3e-3, 3e-3, 2e-3});
  body.shape.parameters.set("half", std::vector<double>{1.0, -1.0, 0.0});
  body.lattice = lattice;
  return body;
}

// Twice what is beside the diagonal and twice the halves on it are the whole bar, particle by particle.
TEST(Placement, HalfABoxHoldsHalfOfWhatStandsOnTheCut) {
  for (const std::string lattice : {"cubic", "face_lattice"}) {
    BodyDescription whole_body = box({0.0, 0.0, 0.0}, {3e-3, 3e-3, 2e-3});
    whole_body.lattice = lattice;
    const auto whole = place_body<3>(whole_body, 1e-3);
    const auto half = place_body<3>(half_bar(lattice), 1e-3);
    std::size_t next = 0;
    for (std::size_t i = 0; i < whole.positions.size(); ++i) {
      const Vec<3>& place = whole.positions[i];
      if (place[0] < place[1] - 1e-9) continue;
      ASSERT_LT(next, half.positions.size());
      EXPECT_EQ(half.positions[next], place) << lattice;
      EXPECT_NEAR(half.volumes[next], (place[0] > place[1] + 1e-9 ? 1.0 : 0.5) * whole.volumes[i], 1e-24) << lattice;
      ++next;
    }
    EXPECT_EQ(next, half.positions.size()) << lattice;
    double area = 0.0;
    for (const auto& point : half.surface) area += point.area;
    EXPECT_NEAR(area, 0.5 * (4 * 6e-6 + 2 * 9e-6), 1e-15) << lattice;  // of the box, without the cut
    const auto shape = make_shape<3>(half_bar(lattice).shape);
    EXPECT_NEAR(shape->volume(), 9e-9, 1e-21);
    EXPECT_NEAR(shape->reach(Vec<3>(-1.0, 1.0, 0.0)), 0.0, 1e-18);  // up to the cut
    EXPECT_NEAR(shape->reach(Vec<3>(0.0, 1.0, 0.0)), 1.5e-3, 1e-15);
    EXPECT_NEAR(shape->reach(Vec<3>(-1.0, -1.0, 0.0)), 3e-3, 1e-15);
  }
}

TEST(Placement, AWedgeOf45DegreesHoldsHalfOfWhatStandsOnItsSecondEdge) {
  auto body = shell("face_lattice", "wedge");
  body.shape.parameters.set("opening", 0.25 * pi);
  const auto wedge = place_body<2>(body, 2e-3), quarter = place_body<2>(shell("face_lattice", "quarter"), 2e-3);
  double on_edge = 0.0, beside = 0.0;
  for (std::size_t i = 0; i < wedge.positions.size(); ++i) {
    const Vec<2> arm = wedge.positions[i] - Vec<2>(0.3, -0.2);
    EXPECT_GT(arm[0], arm[1] - 1e-9);
    (arm[0] < arm[1] + 1e-9 ? on_edge : beside) += wedge.volumes[i];
  }
  double on_diagonal = 0.0;
  for (std::size_t i = 0; i < quarter.positions.size(); ++i) {
    const Vec<2> arm = quarter.positions[i] - Vec<2>(0.3, -0.2);
    if (std::abs(arm[0] - arm[1]) < 1e-9) on_diagonal += quarter.volumes[i];
  }
  EXPECT_GT(on_edge, 0.0);
  EXPECT_NEAR(2.0 * on_edge, on_diagonal, 1e-12 * on_diagonal);
  EXPECT_NEAR(2.0 * (on_edge + beside), total_volume(quarter), 1e-12 * total_volume(quarter));
}

TEST(Placement, FilledCellsKnowTheirOpenSides) {
  const auto placed = place_body<3>(box({0.0, 0.0, 0.0}, {2e-3, 3e-3, 4e-3}), 1e-3);
  double area = 0.0;
  for (const auto& point : placed.surface) {
    EXPECT_NEAR(point.offset.norm(), 0.5e-3, 1e-15);
    area += point.area;
  }
  EXPECT_NEAR(area, 52e-6, 1e-15);
}

TEST(Placement, RotationTurnsTheBodyAboutTheOrigin) {
  BodyDescription body = box({1e-3, 0.0, 0.0}, {3e-3, 1e-3, 1e-3});
  body.rotation = {0.0, 0.0, 0.5 * pi};
  const auto placed = place_body<3>(body, 1e-3);
  ASSERT_EQ(placed.positions.size(), 2U);
  EXPECT_NEAR((placed.positions[0] - Vec<3>(-0.5e-3, 1.5e-3, 0.5e-3)).norm(), 0.0, 1e-15);
}

}  // namespace
}  // namespace anvil
