// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/frame_parts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace anvil {
namespace {

constexpr double spacing = 0.1;

/// Corners of the cells of a box of `cells` cells in each direction.
void add_corners(Frame& frame, std::array<int, 3> cells, double begin, int body) {
  if (frame.arrays.empty())
    frame.arrays = {
        {"body", "", 1, true, {}}, {"initial_position", "m", 3, false, {}}, {"density", "kg/m3", 1, false, {}}};
  for (int k = 0; k <= cells[2]; ++k)
    for (int j = 0; j <= cells[1]; ++j)
      for (int i = 0; i <= cells[0]; ++i) {
        const double place[] = {begin + i * spacing, j * spacing, k * spacing};
        frame.positions.insert(frame.positions.end(), place, place + 3);
        frame.arrays[0].values.push_back(body);
        frame.arrays[1].values.insert(frame.arrays[1].values.end(), place, place + 3);
        frame.arrays[2].values.push_back(2000.0);
      }
}

double mass_of(const Frame& frame) {
  const auto& masses = frame.find("mass")->values;
  return std::accumulate(masses.begin(), masses.end(), 0.0);
}

TEST(FaceLattice, SharesItsCellsAmongTheirCorners) {
  Frame solid;
  add_corners(solid, {4, 3, 2}, -0.2, 0);
  add_corners(solid, {1, 3, 2}, 0.2, 1);  // touches the first: both have particles at x = 0.2
  add_masses_of_face_lattice(solid);
  EXPECT_NEAR(mass_of(solid), 2000.0 * (24 + 6) * 1e-3, 1e-9);
  EXPECT_NEAR(solid.find("mass")->values.front(), 2000.0 * 1e-3 / 8, 1e-12);  // a corner

  Frame flat;
  flat.dimension = 2;
  add_corners(flat, {4, 3, 0}, 0.0, 0);
  add_masses_of_face_lattice(flat);
  EXPECT_NEAR(mass_of(flat), 2000.0 * 12 * 1e-2, 1e-9);
}

TEST(FaceLattice, KeepsMassesThatAreThere) {
  Frame frame;
  add_corners(frame, {1, 1, 1}, 0.0, 0);
  frame.arrays.push_back({"mass", "kg", 1, false, std::vector<double>(frame.particle_count(), 3.0)});
  add_masses_of_face_lattice(frame);
  EXPECT_DOUBLE_EQ(mass_of(frame), 3.0 * 8);
}

TEST(WallParticles, AreTakenOut) {
  Frame frame;
  add_corners(frame, {1, 1, 0}, 0.0, 0);
  add_corners(frame, {2, 0, 0}, 5.0, 1);
  add_corners(frame, {1, 0, 0}, 9.0, 0);
  Frame all = frame;
  EXPECT_TRUE(take_walls_out(all, 2).empty());
  EXPECT_EQ(all.particle_count(), frame.particle_count());

  const auto walls = take_walls_out(frame, 1);
  ASSERT_EQ(walls.size(), 9U);
  EXPECT_DOUBLE_EQ(walls[0], 5.0);
  EXPECT_DOUBLE_EQ(walls[6], 5.2);
  ASSERT_EQ(frame.particle_count(), 6U);
  for (const FrameArray& array : frame.arrays)
    EXPECT_EQ(array.values.size(), static_cast<std::size_t>(6 * array.components)) << array.name;
  EXPECT_DOUBLE_EQ(frame.find("initial_position")->values[12], 9.0);
  EXPECT_DOUBLE_EQ(frame.positions[12], 9.0);
}

}  // namespace
}  // namespace anvil
