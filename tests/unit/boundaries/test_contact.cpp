// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/boundaries/contact.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "unit/pairs/cloud.hpp"

namespace anvil {
namespace {

constexpr double spacing = 1e-3;  // m, of the particles; a contact reaches half of it
constexpr double time_step = 1e-7;
constexpr double lower_mass = 2.0, upper_mass = 3.0;  // kg, of each particle

/// Two facets face to face across the last axis, a gap apart: of the lower body first, then of the upper one, which may
/// be shifted along the facet.
template <int D>
struct FacingFacets {
  static constexpr std::size_t corners = std::size_t{1} << (D - 1);

  explicit FacingFacets(double gap, double shift = 0.0) : fields(2 * corners) {
    for (const FieldKey* key : {&field::position, &field::velocity}) fields.require(*key, D);
    fields.require(field::mass);
    for (std::size_t i = 0; i < 2 * corners; ++i) {
      const bool upper = i >= corners;
      // Counterclockwise seen from above, as if one looked down the last axis.
      constexpr int across[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
      Vec<D> place = Vec<D>::Zero();
      for (int axis = 0; axis + 1 < D; ++axis)
        place[axis] = spacing * across[i % corners][axis] + (upper ? shift : 0.0);
      place[D - 1] = upper ? gap : 0.0;
      position()[i] = place;
      velocity()[i].setZero();
      fields.scalar(field::mass)[i] = upper ? upper_mass : lower_mass;
    }
  }
  VectorView<D> position() { return fields.template vector<D>(field::position); }
  VectorView<D> velocity() { return fields.template vector<D>(field::velocity); }

  Contact<D> contact() {
    std::vector<Surface<D>> surfaces(2);
    for (std::size_t b = 0; b < 2; ++b) {
      BodyFacet<D> facet{};
      for (std::size_t k = 0; k < corners; ++k) {
        // Outside is above the lower facet and below the upper one; in 2D on the right of the segment.
        const bool reversed = D == 3 ? b == 1 : b == 0;
        facet[k] = static_cast<std::int32_t>(b * corners + (reversed ? corners - 1 - k : k));
        surfaces[b].particles.push_back(static_cast<std::int32_t>(b * corners + k));
      }
      if constexpr (D == 1) facet[1] = b == 0 ? 1 : -1;
      surfaces[b].facets.push_back(facet);
    }
    return Contact<D>(surfaces, fields, spacing);
  }

  /// Speeds along the last axis: of the lower body and of the upper one.
  void approach(double lower, double upper) {
    for (std::size_t i = 0; i < 2 * corners; ++i) velocity()[i][D - 1] = i < corners ? lower : upper;
  }
  std::vector<Vec<D>> velocities() {
    std::vector<Vec<D>> all;
    for (std::size_t i = 0; i < 2 * corners; ++i) all.emplace_back(velocity()[i]);
    return all;
  }
  Vec<D> momentum() {
    Vec<D> sum = Vec<D>::Zero();
    for (std::size_t i = 0; i < 2 * corners; ++i) sum += fields.scalar(field::mass)[i] * velocity()[i];
    return sum;
  }
  /// About the origin, in two or three dimensions.
  Vec<3> angular_momentum() {
    Vec<3> sum = Vec<3>::Zero();
    for (std::size_t i = 0; i < 2 * corners; ++i) {
      Vec<3> arm = Vec<3>::Zero(), motion = Vec<3>::Zero();
      arm.head(D) = position()[i];
      motion.head(D) = velocity()[i];
      sum += fields.scalar(field::mass)[i] * arm.cross(motion);
    }
    return sum;
  }
  double kinetic_energy() {
    double sum = 0.0;
    for (std::size_t i = 0; i < 2 * corners; ++i)
      sum += 0.5 * fields.scalar(field::mass)[i] * velocity()[i].squaredNorm();
    return sum;
  }

  FieldStore fields;
};

template <class T>
class ContactIn : public InEachDimension<T> {};
TYPED_TEST_SUITE(ContactIn, Dimensions);

TYPED_TEST(ContactIn, BringsFacesThatTouchToOneVelocity) {
  constexpr int D = TypeParam::value;
  FacingFacets<D> bodies(0.0);
  bodies.approach(10.0, -20.0);
  auto contact = bodies.contact();
  contact.correct_velocities(time_step);
  const double common = (lower_mass * 10.0 - upper_mass * 20.0) / (lower_mass + upper_mass);
  for (const auto& velocity : bodies.velocities()) EXPECT_NEAR(velocity[D - 1], common, 1e-10);
}

// Half of the step's way is left, and both sides give by their masses: the lower one is pushed down, the upper one up.
TYPED_TEST(ContactIn, LeavesTheApproachThatClosesTheGap) {
  constexpr int D = TypeParam::value;
  const double closing = 30.0, gap = 0.5 * closing * time_step;
  FacingFacets<D> bodies(gap);
  bodies.approach(10.0, 10.0 - closing);
  auto contact = bodies.contact();
  contact.correct_velocities(time_step);
  const auto after = bodies.velocities();
  EXPECT_NEAR(after.front()[D - 1] - after.back()[D - 1], gap / time_step, 1e-9);
  EXPECT_LT(after.front()[D - 1], 10.0);
  EXPECT_GT(after.back()[D - 1], 10.0 - closing);
  EXPECT_NEAR(lower_mass * (10.0 - after.front()[D - 1]), upper_mass * (after.back()[D - 1] - 10.0 + closing), 1e-9);
}

TYPED_TEST(ContactIn, TouchesNothingThatPartsOrDoesNotArriveOrIsOutOfReach) {
  constexpr int D = TypeParam::value;
  struct Case {
    double gap, lower, upper;
  };
  for (const Case& one : {Case{0.0, -1.0, 1.0}, Case{-0.1 * spacing, -1.0, 1.0}, Case{4e-6, 10.0, -20.0},
                          Case{0.51 * spacing, 1e5, -1e5}, Case{-0.51 * spacing, 10.0, -20.0}}) {
    FacingFacets<D> bodies(one.gap);
    bodies.approach(one.lower, one.upper);
    const auto before = bodies.velocities();
    auto contact = bodies.contact();
    contact.correct_velocities(time_step);
    EXPECT_EQ(bodies.velocities(), before) << "gap " << one.gap;
    EXPECT_EQ(contact.loss(before[0].data(), D), 0.0);
  }
}

// With faces beside each other some corners meet the inside of a facet, others nothing; all velocities differ.
TYPED_TEST(ContactIn, KeepsMomentaAndCountsWhatTheMotionLoses) {
  constexpr int D = TypeParam::value;
  for (const double shift : {0.0, 0.3 * spacing}) {
    FacingFacets<D> bodies(-0.01 * spacing, shift);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    bodies.approach(50.0, -50.0);
    for (std::size_t i = 0; i < 2 * FacingFacets<D>::corners; ++i)
      for (int axis = 0; axis < D; ++axis) bodies.velocity()[i][axis] += 10.0 * unit(random);
    const auto before = bodies.velocities();
    const double energy = bodies.kinetic_energy();
    const Vec<D> momentum = bodies.momentum();
    const Vec<3> angular = bodies.angular_momentum();
    auto contact = bodies.contact();
    contact.correct_velocities(time_step);
    EXPECT_LT((bodies.momentum() - momentum).norm(), 1e-13 * lower_mass * 50.0);
    // The pushes are along the normals at the closest points: of bodies a hundredth of a spacing into each other.
    EXPECT_LT((bodies.angular_momentum() - angular).norm(), 1e-13 * lower_mass * 50.0 * spacing);
    EXPECT_GT(energy - bodies.kinetic_energy(), 0.1 * energy);
    EXPECT_NEAR(contact.loss(before[0].data(), D), energy - bodies.kinetic_energy(), 1e-12 * energy);
    for (std::size_t i = 0; i < before.size(); ++i)  // without friction
      for (int axis = 0; axis + 1 < D; ++axis) EXPECT_NEAR(bodies.velocities()[i][axis], before[i][axis], 1e-12);
  }
}

TYPED_TEST(ContactIn, SaysHowDeepItIs) {
  constexpr int D = TypeParam::value;
  FacingFacets<D> apart(0.1 * spacing), deep(-0.02 * spacing);
  EXPECT_EQ(apart.contact().deepest_penetration(), 0.0);
  EXPECT_NEAR(deep.contact().deepest_penetration(), 0.02 * spacing, 1e-12 * spacing);
}

TEST(Contact, DoesNotReachBesideAFacet) {
  FacingFacets<2> bodies(0.0, 1.06 * spacing);
  bodies.approach(10.0, -20.0);
  const auto before = bodies.velocities();
  bodies.contact().correct_velocities(time_step);
  EXPECT_EQ(bodies.velocities(), before);
}

// A list of candidates made far away does not hide who arrives.
TEST(Contact, FindsWhoHasComeSinceTheLastStep) {
  FacingFacets<3> bodies(3.0 * spacing);
  bodies.approach(10.0, -20.0);
  auto contact = bodies.contact();
  contact.correct_velocities(time_step);
  EXPECT_EQ(bodies.velocities().front()[2], 10.0);
  for (std::size_t i = 4; i < 8; ++i) bodies.position()[i][2] = 0.0;
  contact.correct_velocities(time_step);
  EXPECT_NEAR(bodies.velocities().front()[2], -8.0, 1e-10);
}

}  // namespace
}  // namespace anvil
