// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/terms/wall_penalty.hpp"

#include "anvil/terms/nominal_momentum.hpp"
#include "unit/terms/term_cloud.hpp"
#include "unit/total_lagrangian/frozen_block.hpp"

namespace anvil {
namespace {

constexpr double stiffness = 1e14;  // Pa/m

/// A block whose lowest particles, across the first axis, have a face each: at the particle, or half a spacing below.
template <int D>
struct BlockOnWall : FrozenBlock<D> {
  explicit BlockOnWall(bool filled)
      : offset(filled ? Vec<D>(-0.5 * this->spacing * Vec<D>::Unit(0)) : Vec<D>::Zero()) {}

  std::unique_ptr<WallPenalty<D>> wall_at(double height) {
    std::vector<SurfacePoint<D>> faces;
    for (std::size_t i = 0; i < this->count; ++i)
      if (this->start[i][0] < 0.5 * this->spacing) faces.push_back({static_cast<std::int32_t>(i), offset, area});
    face_count = faces.size();
    return std::make_unique<WallPenalty<D>>(height * Vec<D>::Unit(0), Vec<D>::Unit(0), stiffness, std::move(faces),
                                            this->fields, this->deformation);
  }
  /// By the wall alone: stresses of the material are zero.
  std::vector<Vec<D>> accelerations(const WallPenalty<D>& wall) {
    const NominalMomentum<D> momentum(this->fields, this->deformation, nullptr);
    momentum.pack(this->all(), this->records);
    wall.pack(this->all(), this->records);
    std::vector<Vec<D>> acceleration(this->count, Vec<D>::Zero());
    std::vector<double> loss(this->count, 0.0);
    momentum.accumulate(this->tile(), this->records, acceleration[0].data(), loss.data());
    wall.accumulate(this->tile(), this->records, acceleration[0].data(), loss.data());
    for (const double one : loss) EXPECT_EQ(one, 0.0);  // what it takes it stores
    return acceleration;
  }
  /// The mean of start and end gives the work of a step to second order.
  double work_of(const std::vector<Vec<D>>& accelerations, double time_step) {
    double work = 0.0;
    for (std::size_t i = 0; i < this->count; ++i)
      work += time_step * this->fields.scalar(field::mass)[i] * accelerations[i].dot(this->velocity()[i]);
    return work;
  }

  static constexpr double area = 2.5e-7;
  Vec<D> offset;
  std::size_t face_count = 0;
};

template <class T>
class WallPenaltyIn : public InEachDimension<T> {};
TYPED_TEST_SUITE(WallPenaltyIn, Dimensions);

TYPED_TEST(WallPenaltyIn, DoesNothingWhileFacesAreInFront) {
  constexpr int D = TypeParam::value;
  for (const bool filled : {false, true}) {
    BlockOnWall<D> block(filled);
    const auto wall = block.wall_at(block.offset[0] - 1e-9);
    for (const auto& acceleration : block.accelerations(*wall)) EXPECT_EQ(acceleration.norm(), 0.0);
    EXPECT_EQ(wall->force().norm(), 0.0);
    EXPECT_EQ(wall->energy(), 0.0);
  }
}

TYPED_TEST(WallPenaltyIn, PushesWithTheDepthOfItsFaces) {
  constexpr int D = TypeParam::value;
  constexpr double depth = 1e-5;
  for (const bool filled : {false, true}) {
    BlockOnWall<D> block(filled);
    const auto wall = block.wall_at(block.offset[0] + depth);
    const auto accelerations = block.accelerations(*wall);
    const double force = stiffness * BlockOnWall<D>::area * depth * static_cast<double>(block.face_count);
    EXPECT_NEAR(wall->force()[0], force, 1e-12 * force);
    EXPECT_NEAR(wall->energy(), 0.5 * force * depth, 1e-12 * force * depth);
    // All that the block feels: what acts through the deformation gradient cancels within it.
    Vec<D> sum = Vec<D>::Zero();
    for (std::size_t i = 0; i < block.count; ++i) sum += block.fields.scalar(field::mass)[i] * accelerations[i];
    EXPECT_NEAR((sum - wall->force()).norm(), 0.0, 1e-12 * force) << "filled " << filled;
    EXPECT_TRUE(filled || accelerations[0][0] > 0.0);
  }
}

// The force is what the energy gives back, also through the tilt and stretch of cells: with the other sign of either
// part this fails.
TYPED_TEST(WallPenaltyIn, TakesFromTheMotionWhatItStores) {
  constexpr int D = TypeParam::value;
  for (const bool filled : {false, true}) {
    BlockOnWall<D> block(filled);
    block.move_at_random(1e-7, 100.0);
    const auto wall = block.wall_at(block.offset[0] + 4e-5);  // deeper than anything has moved
    constexpr double time_step = 1e-9;
    const auto before = block.accelerations(*wall);
    const double stored = wall->energy();
    (void)block.move(time_step);
    const auto after = block.accelerations(*wall);
    const double work = 0.5 * (block.work_of(before, time_step) + block.work_of(after, time_step));
    EXPECT_GT(std::abs(work), 1e-5 * stored);
    EXPECT_NEAR(wall->energy() - stored, -work, 1e-9 * stored) << "filled " << filled;
  }
}

}  // namespace
}  // namespace anvil
