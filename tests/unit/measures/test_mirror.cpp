// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/mirror.hpp"

#include <gtest/gtest.h>

#include "anvil/measures/frame_fields.hpp"
#include "anvil/measures/whole.hpp"

namespace anvil {
namespace {

/// One particle with an array of each kind.
Frame make_particle() {
  Frame frame;
  frame.positions = {1.0, 2.0, 3.0};
  frame.arrays = {{"initial_position", "m", 3, false, {1.5, 2.0, 3.0}},
                  {"velocity", "m/s", 3, false, {10.0, 20.0, 30.0}},
                  {"stress", "Pa", 6, false, {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}},
                  {"density", "kg/m3", 1, false, {8930.0}},
                  {"body", "", 1, true, {2.0}}};
  return frame;
}

std::vector<double> image(const Frame& both, const std::string& name) {
  const auto& values = name == "position" ? both.positions : both.find(name)->values;
  return {values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end()};
}

TEST(Mirror, TurnsPointsVectorsAndTensors) {
  const Frame both = with_mirror_image(make_particle(), {{0.5, 0.0, 0.0}, {-2.0, 0.0, 0.0}});
  EXPECT_EQ(both.particle_count(), 2U);
  EXPECT_EQ(image(both, "position"), (std::vector<double>{0.0, 2.0, 3.0}));
  EXPECT_EQ(image(both, "initial_position"), (std::vector<double>{-0.5, 2.0, 3.0}));
  EXPECT_EQ(image(both, "velocity"), (std::vector<double>{-10.0, 20.0, 30.0}));
  EXPECT_EQ(image(both, "stress"), (std::vector<double>{1.0, 2.0, 3.0, -4.0, 5.0, -6.0}));
  EXPECT_EQ(image(both, "density"), (std::vector<double>{8930.0}));
  EXPECT_EQ(image(both, "body"), (std::vector<double>{2.0}));
}

TEST(Mirror, KeepsInvariantsInAnyPlane) {
  const Frame both = with_mirror_image(make_particle(), {{0.1, 0.2, 0.3}, {1.0, 2.0, -0.5}});
  for (const std::string name : {"velocity", "stress.von_mises", "stress.mean", "stress.principal_1"}) {
    const auto values = field_of(both, name).values;
    EXPECT_NEAR(values[1], values[0], 1e-12 * std::abs(values[0])) << name;
  }
  // Mirrored back it is where it was.
  const Frame four = with_mirror_image(both, {{0.1, 0.2, 0.3}, {1.0, 2.0, -0.5}});
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(four.positions[9 + i], four.positions[i], 1e-14);
}

TEST(Mirror, TakesAParticleOnThePlaneForBothItsHalves) {
  Frame frame = make_particle();
  frame.positions = {1.0, 2.0, 3.0, 0.5, 4.0, 1.0};
  frame.arrays = {{"mass", "kg", 1, false, {0.5, 0.25}}, {"velocity", "m/s", 3, false, {1, 2, 3, 0, 5, 6}}};
  const Frame both = with_mirror_image(frame, {{0.5, 0.0, 0.0}, {1.0, 0.0, 0.0}});
  EXPECT_EQ(both.positions, (std::vector<double>{1.0, 2.0, 3.0, 0.5, 4.0, 1.0, 0.0, 2.0, 3.0}));
  EXPECT_EQ(both.find("mass")->values, (std::vector<double>{0.5, 0.5, 0.5}));
  EXPECT_EQ(both.find("velocity")->values, (std::vector<double>{1, 2, 3, 0, 5, 6, -1, 2, 3}));
}

TEST(Mirror, MakesAnEighthTheWhole) {
  const std::vector<Plane> planes = planes_to_the_whole({{{0, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {1, -1, 0}}});
  Frame frame;
  frame.positions = {2.0, 1.0, 3.0, 2.0, 2.0, 3.0};  // beside the diagonal and on it
  frame.arrays = {{"mass", "kg", 1, false, {1.0, 0.5}}};
  for (const Plane& plane : planes) frame = with_mirror_image(frame, plane);
  double mass = 0.0, sum[2] = {0.0, 0.0};
  for (std::size_t i = 0; i < frame.particle_count(); ++i) {
    mass += frame.find("mass")->values[i];
    for (std::size_t a = 0; a < 2; ++a) sum[a] += frame.positions[3 * i + a];
  }
  EXPECT_EQ(frame.particle_count(), 8U + 4U);
  EXPECT_EQ(mass, 12.0);
  EXPECT_NEAR(sum[0], 0.0, 1e-14);
  EXPECT_NEAR(sum[1], 0.0, 1e-14);
}

TEST(Mirror, TakesPlanesThatMeetAtRightAnglesAsTheyAre) {
  const std::vector<Plane> planes = planes_to_the_whole({{{0, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {1, 0, 0}}});
  ASSERT_EQ(planes.size(), 2U);
  EXPECT_EQ(planes[0].normal[1], 1.0);
}

}  // namespace
}  // namespace anvil
