// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/boundaries/face_ghosts.hpp"

#include <numeric>

#include "anvil/terms/momentum.hpp"
#include "unit/pairs/cloud.hpp"

namespace anvil {
namespace {

/// An even line of particles with a stress of its own each, its images, and the sum of m a by stress differences.
struct LoadedLine {
  explicit LoadedLine(double smoothing_ratio, const std::vector<Vec<1>>& positions) : cloud(CubicSpline(), positions) {
    for (std::size_t i = 0; i < cloud.count; ++i) {
      cloud.fields.scalar(field::smoothing_length)[i] = smoothing_ratio * Cloud<1>::spacing;
      cloud.fields.scalar(field::density)[i] = 8000.0;
      cloud.fields.scalar(field::mass)[i] = 8000.0 * Cloud<1>::spacing;
    }
    cloud.list.build(cloud.position(), cloud.fields.scalar(field::smoothing_length), cloud.support(), skin,
                     pair_loops<1>());
    cloud.records.resize(cloud.count, {.medium = true});
    cloud.pack();
    std::vector<std::int32_t> order(cloud.count);
    std::iota(order.begin(), order.end(), 0);
    ghosts = std::make_unique<FaceGhosts>(cloud.fields, order, cloud.support());
    ghosts->list(cloud.list, cloud.records, skin);
  }

  double total_force(double left_stress) {
    const Momentum<1> term(cloud.fields, MomentumForm::difference);
    term.pack({0, static_cast<std::int32_t>(cloud.count)}, cloud.records);
    const std::vector<PressureLoad> loads = {{0, 1.0, nullptr}};
    ghosts->show(cloud.records, loads, std::vector<double>{left_stress});
    PairTile<1> tile = cloud.tile();
    EXPECT_EQ(pair_loops<1>().correct_gradients(tile, cloud.records), 0);
    std::vector<double> acceleration(cloud.count, 0.0), loss(cloud.count, 0.0);
    term.accumulate(tile, cloud.records, acceleration.data(), loss.data());
    double force = 0.0;
    for (std::size_t i = 0; i < cloud.count; ++i) force += cloud.scalar(field::mass, i) * acceleration[i];
    return force;
  }

  static constexpr double skin = 0.3 * Cloud<1>::spacing;
  Cloud<1> cloud;
  std::unique_ptr<FaceGhosts> ghosts;
};

/// m a summed over the line is what pulls at its faces, whatever the stresses inside and however far kernels reach.
TEST(FaceGhosts, GiveTheLineTheForcesAtItsFaces) {
  for (const double ratio : {0.8, 1.0, 1.2, 1.5}) {
    LoadedLine line(ratio, jittered_lattice<1>(40, Cloud<1>::spacing, 0.0));
    const double pressure = 3e9;
    // The stresses of the line are some GPa: round-off of their sum.
    EXPECT_NEAR(line.total_force(-pressure), pressure, 1e-12 * 40 * 2e9) << ratio;
    EXPECT_NEAR(line.total_force(0.0), 0.0, 1e-12 * 40 * 2e9) << ratio;
  }
}

/// A gap wider than the reach has two free faces; particles in reach are one line without a face between them.
TEST(FaceGhosts, OpenAtGapsOnly) {
  auto positions = jittered_lattice<1>(40, Cloud<1>::spacing, 0.0);
  LoadedLine whole(1.0, positions);
  for (std::size_t i = 20; i < positions.size(); ++i) positions[i][0] += 3.0 * Cloud<1>::spacing;
  LoadedLine parted(1.0, positions);
  const auto images_of = [](const LoadedLine& line) {
    return line.cloud.records.geometry.count() - line.cloud.count - 1;
  };
  EXPECT_EQ(images_of(parted), 2 * images_of(whole));
  EXPECT_NEAR(parted.total_force(0.0), 0.0, 1e-12 * 40 * 2e9);
}

TEST(FaceGhosts, HiddenAddNothingToTheVelocityGradient) {
  LoadedLine line(1.0, jittered_lattice<1>(40, Cloud<1>::spacing, 0.0));
  for (std::size_t i = 0; i < line.cloud.count; ++i)
    line.cloud.records.motion[i][0] = 5.0 * line.cloud.position()[i][0];
  line.ghosts->hide(line.cloud.records);
  const PairTile<1> tile = line.cloud.tile();
  (void)pair_loops<1>().correct_gradients(tile, line.cloud.records);
  std::vector<double> gradient(line.cloud.count);
  pair_loops<1>().velocity_gradient(tile, line.cloud.records, gradient.data());
  for (const double number : gradient) EXPECT_NEAR(number, 5.0, 1e-12);  // round-off of two or four terms
}

}  // namespace
}  // namespace anvil
