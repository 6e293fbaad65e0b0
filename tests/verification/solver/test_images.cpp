// SPDX-License-Identifier: BSD-3-Clause
// Symmetry planes and periods in whole simulations. What the images themselves hold is tested in unit/pairs.
#include <cmath>

#include "verification/simulate.hpp"

namespace anvil {
namespace {

const std::string copper = R"(
[material.copper]
density = 8930.0
eos = { type = "linear", bulk_modulus = 130e9 }
strength = { type = "j2", shear_modulus = 43e9, yield_stress = 400e6, hardening_modulus = 100e6 }
)";

/// The square rod of 6 x 6 x 12 particles, or its quarter between two planes of symmetry.
std::unique_ptr<Simulation> rod(bool quarter, const std::string& smoothing_form = "pairwise") {
  std::string text = R"(
[domain]
dimension = 3
[discretisation]
spacing = 1e-3
[shock]
method = "artificial_viscosity"
[time]
end = 40e-6
[stabiliser]
conservative_smoothing = 0.1
smoothing_form = ")" +
                     smoothing_form +
                     R"("
[[body]]
name = "rod"
material = "copper"
velocity = [0, 0, -200]
shape = { type = "box", min = )" +
                     std::string(quarter ? "[0, 0, 0]" : "[-3e-3, -3e-3, 0]") + R"(, max = [3e-3, 3e-3, 12e-3] }
[[boundary]]
name = "wall"
type = "rigid_wall"
normal = [0, 0, 1]
)" + copper;
  const std::string planes = R"(
[[boundary]]
name = "x"
type = "symmetry_plane"
normal = [1, 0, 0]
[[boundary]]
name = "y"
type = "symmetry_plane"
normal = [0, 1, 0]
)";
  return make_simulation(read_scene_text(quarter ? text + planes : text, "rod"));
}

/// A block in the plane between a plane of symmetry below and the ends of a period, sheared and pressed down.
std::unique_ptr<Simulation> pressed_block() {
  return make_simulation(read_scene_text(R"(
[domain]
dimension = 2
[discretisation]
spacing = 1e-3
[shock]
method = "artificial_viscosity"
[time]
end = 40e-6
[[body]]
name = "upper"
shape = { type = "box", min = [0, 8e-3], max = [12e-3, 16e-3] }
material = "copper"
velocity = [300, -200]
[[body]]
name = "lower"
shape = { type = "box", min = [0, 0], max = [12e-3, 8e-3] }
material = "copper"
velocity = [-50, -100]
[[boundary]]
name = "floor"
type = "symmetry_plane"
point = [0, 0]
normal = [0, 1]
[[boundary]]
name = "sides"
type = "periodic"
axis = "x"
min = 0
max = 12e-3
)" + copper,
                                         "block"));
}

TEST(Periodic, UniformMotionStrainsNothing) {
  const auto flow = make_simulation(read_scene_text(R"(
[domain]
dimension = 2
[discretisation]
spacing = 1e-3
[time]
end = 1
[[body]]
name = "all"
shape = { type = "box", min = [0, 0], max = [8e-3, 6e-3] }
material = "copper"
velocity = [700, -300]
[[boundary]]
name = "x"
type = "periodic"
axis = "x"
min = 0
max = 8e-3
[[boundary]]
name = "y"
type = "periodic"
axis = "y"
min = 0
max = 6e-3
)" + copper,
                                                    "flow"));
  run_steps(*flow, 600);
  EXPECT_GT(700.0 * flow->time(), 8e-3) << "too short to leave the box";
  const Frame frame = flow->frame();
  for (const double pressure : array_of(frame, "pressure")) EXPECT_NEAR(pressure, 0.0, 130e9 * 1e-13);
  for (std::size_t i = 0; i < frame.positions.size(); i += 3) {
    EXPECT_GE(frame.positions[i], 0.0);
    EXPECT_LT(frame.positions[i], 8e-3);
    EXPECT_GE(frame.positions[i + 1], 0.0);
    EXPECT_LT(frame.positions[i + 1], 6e-3);
  }
  EXPECT_NEAR(audited(*flow, "momentum_error"), 0.0, 1e-12 * audited(*flow, "momentum_x"));
}

TEST(Images, AQuarterOfTheRodIsAQuarterOfTheRod) {
  const auto quarter = rod(true), whole = rod(false);
  run_steps(*quarter, 150);
  run_steps(*whole, 150);
  EXPECT_EQ(whole->particle_count(), 4 * quarter->particle_count());
  for (const std::string name : {"mass", "kinetic_energy", "elastic_energy", "plastic_work", "viscous_loss",
                                 "smoothing_loss", "wall_loss", "momentum_z", "wall_impulse_z"}) {
    const double part = audited(*quarter, name), all = audited(*whole, name);
    // Round-off of 150 steps of a smooth motion; an image missed for one step shows at 1e-6.
    EXPECT_NEAR(4.0 * part, all, 1e-11 * std::abs(all)) << name;
    EXPECT_NE(part, 0.0) << name;
  }
  EXPECT_NEAR(audited(*quarter, "momentum_error"), 0.0, 1e-12 * std::abs(audited(*quarter, "momentum_z")));
  // The planes press outwards what spreads sideways: their push is the momentum the quarter has gained.
  EXPECT_NEAR(audited(*quarter, "wall_impulse_x") + audited(*quarter, "smoothing_impulse_x"),
              audited(*quarter, "momentum_x"), 1e-12 * std::abs(audited(*quarter, "momentum_z")));
  EXPECT_GT(audited(*quarter, "wall_impulse_x"), 1e-3 * std::abs(audited(*quarter, "momentum_z")));
}

TEST(SymmetryPlane, IsNeverCrossedAndCountsItsImpulse) {
  const auto block = pressed_block();
  const double start_x = audited(*block, "momentum_x"), start_y = audited(*block, "momentum_y");
  run_steps(*block, 400);
  const Frame frame = block->frame();
  for (std::size_t i = 0; i < frame.positions.size(); i += 3) EXPECT_GE(frame.positions[i + 1], 0.0);
  const double scale = std::abs(start_y);
  EXPECT_NEAR(audited(*block, "momentum_x"), start_x, 1e-11 * scale) << "a plane without friction pulls along itself";
  EXPECT_NEAR(audited(*block, "momentum_y"), start_y + audited(*block, "wall_impulse_y"), 1e-11 * scale);
  EXPECT_NEAR(audited(*block, "momentum_error"), 0.0, 1e-11 * scale);
  EXPECT_GT(audited(*block, "wall_impulse_y"), scale) << "the block has bounced";
}

TEST(Images, KeepTheBitsForAnyNumberOfThreadsAndAfterARestart) {
  std::unique_ptr<Simulation> one, two;
  State middle;
  {
    const WithThreads threads(1);
    one = pressed_block();
    run_steps(*one, 110);
    middle = one->state();
    run_steps(*one, 150);
  }
  {
    const WithThreads threads(2);
    two = pressed_block();
    run_steps(*two, 260);
  }
  EXPECT_GT(audited(*one, "list_builds"), 3.0);
  expect_same_bits(*one, *two);
  const auto continued = pressed_block();
  run_steps(*continued, 20);
  continued->restore(middle);
  run_steps(*continued, 150);
  expect_same_bits(*one, *continued);
}

}  // namespace
}  // namespace anvil
