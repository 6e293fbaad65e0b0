// SPDX-License-Identifier: BSD-3-Clause
// Walls by themselves: water at rest, flow along them, a particle shot at them, bits.
#include "anvil/exact/poiseuille.hpp"
#include "verification/walls/flow.hpp"

namespace anvil {
namespace {

/// Water in a container drawn by `path` that fills `shape`, at rest under its own weight. The walls are to be seen, so
/// nothing else must err by as much: a kernel that keeps its particles apart, and whose gradient is 0.3 % off on the
/// lattice at this smoothing length (at 1.3 spacings 2.7 %, all of it error of the pressure), and density diffusion,
/// without which the pressures of particles in turn from a slope inwards alternate.
Scene still_water(const std::string& path, const std::string& shape) {
  return read_scene_text(R"(
[domain]
dimension = 2
gravity = [0, -9.81]
[discretisation]
kernel = "wendland_c2"
smoothing_ratio = 1.5
spacing = 0.05
variable_smoothing_length = false
momentum_form = "density_squared"
[shock]
method = "artificial_viscosity"
linear_coefficient = 1.0
quadratic_coefficient = 0
softening = 0.01
[stabiliser]
density_diffusion = 0.1
[time]
end = 10
cfl = 0.25
[[body]]
name = "water"
material = "water"
hydrostatic = true
shape = )" + shape + R"(
[material.water]
density = 1000
eos = { type = "tait", stiffness = 2.8e5 }
[[boundary]]
name = "wall"
type = "long_range_wall"
range = 0.55
path = )" + path + "\n",
                         "still");
}

constexpr double sound = 44.27;  // m/s, sqrt(7 B / rho0)

/// Largest deviation of the pressure from rho g depth, over the pressure at the bottom, but for the free surface, where
/// one spacing of depth is the resolution; depth is counted from half a spacing above the highest particle.
double pressure_error(const Frame& frame, double spacing) {
  const double top = largest_of_bodies(frame, [](const Frame& f, std::size_t i) { return f.positions[3 * i + 1]; });
  const double bottom =
      -largest_of_bodies(frame, [](const Frame& f, std::size_t i) { return -f.positions[3 * i + 1]; });
  const auto pressure = array_of(frame, "pressure");
  return largest_of_bodies(frame, [&](const Frame& f, std::size_t i) {
    const double depth = top + 0.5 * spacing - f.positions[3 * i + 1];
    return std::abs(pressure[i] - 1000.0 * 9.81 * depth) / (1000.0 * 9.81 * (top + 0.5 * spacing - bottom));
  });
}

TEST(StillWater, StaysAtRestInABox) {
  const auto water = make_simulation(
      still_water("[[0, 1.2], [0, 0], [1, 0], [1, 1.2]]", "{ type = \"box\", min = [0, 0], max = [1, 1] }"));
  run_to(*water, 4.0);
  const Frame frame = water->frame();
  EXPECT_LT(largest_of_bodies(frame, speed_of), 1e-4 * sound);
  EXPECT_LT(pressure_error(frame, 0.05), 0.02);
  EXPECT_EQ(audited(*water, "penetrations"), 0.0);
}

// 400 particles of 25 cm2 fill the wedge up to y = 1 m, no more and no less: the innermost diagonal of the lattice lies
// half a diagonal's distance from the slopes. Where a lattice leaves gaps there, of a few percent of the volume, the
// water spreads into them, and its pressure errs by some seven times as much (docs/walls.md).
TEST(StillWater, StaysAtRestInAWedge) {
  const auto water = make_simulation(still_water("[[-1.2, 1.2], [0, 0], [1.2, 1.2]]",
                                                 "{ type = \"polygon\", points = [[0, 0], [0.975, 1], [-0.975, 1]] }"));
  run_to(*water, 4.0);
  const Frame frame = water->frame();
  EXPECT_LT(pressure_error(frame, 0.05), 0.02);
  EXPECT_LT(largest_of_bodies(frame, speed_of), 1e-4 * sound);
  EXPECT_EQ(audited(*water, "penetrations"), 0.0);
}

TEST(Poiseuille, SeriesGivesThePrintedValues) {
  const PoiseuilleFlow flow{1e-4, 1e-6, 1e-3};
  const std::pair<double, double> printed[] = {{0.01, 0.07999}, {0.1, 0.61535}, {0.2, 0.85664}, {1.0, 0.99995}};
  for (const auto& [time, value] : printed) EXPECT_NEAR(flow.velocity(0.5e-3, time) / 1.25e-5, value, 1e-5);
}

/// Largest error of the profile over the largest velocity of the series.
double profile_error(const Simulation& simulation) {
  const PoiseuilleFlow flow{1e-4, 1e-6, 1e-3};
  const double time = simulation.time() - 0.5 * simulation.last_time_step();  // velocities lie half a step behind
  return largest_of_bodies(simulation.frame(),
                           [&](const Frame& f, std::size_t i) {
                             const double velocity = f.find("velocity")->values[3 * i];
                             return std::abs(velocity - flow.velocity(f.positions[3 * i + 1], time));
                           }) /
         flow.velocity(0.5e-3, time);
}

TEST(Poiseuille, FollowsTheSeries) {
  const auto flow = simulation_of("poiseuille");
  const std::pair<double, double> bounds[] = {{0.01, 0.008}, {0.1, 0.003}, {0.2, 0.004}, {1.0, 0.005}};
  for (const auto& [time, bound] : bounds) {
    run_to(*flow, time);
    EXPECT_LT(profile_error(*flow), bound) << "at " << time << " s";
  }
  EXPECT_EQ(audited(*flow, "penetrations"), 0.0);
}

/// A block whose particles all move alike comes nearer to the wall alone: the list of neighbours must see that.
TEST(LongRangeWall, StopsABlockThatComesFromAfar) {
  const auto block = make_simulation(read_scene_text(R"(
[domain]
dimension = 2
[discretisation]
spacing = 0.01
variable_smoothing_length = false
momentum_form = "density_squared"
[shock]
method = "artificial_viscosity"
[time]
end = 0.05
[[body]]
name = "block"
shape = { type = "box", min = [0.05, 0.1], max = [0.15, 0.2] }
material = "water"
velocity = [0, -5]
[material.water]
density = 1000
eos = { type = "tait", stiffness = 2.8e5 }
[[boundary]]
name = "wall"
type = "long_range_wall"
path = [[-0.2, 0], [0.4, 0]]
)",
                                                     "block"));
  run_to(*block, 0.03);  // it would be 50 mm below
  EXPECT_GT(-largest_of_bodies(block->frame(), [](const Frame& f, std::size_t i) { return -f.positions[3 * i + 1]; }),
            0.0);
  EXPECT_EQ(audited(*block, "penetrations"), 0.0);
}

/// One particle at half a spacing from the drawn surface, that flies at it midway between two dummies.
double deepest_of_shot(double speed_of_sound_parts) {
  const double c = std::sqrt(7.0 * 1.68e5 / 1000.0);
  const auto shot = make_simulation(read_scene_text(R"(
[domain]
dimension = 2
[discretisation]
spacing = 0.01
variable_smoothing_length = false
[time]
end = 1
cfl = 0.02
[[body]]
name = "ball"
shape = { type = "box", min = [0.095, 0.005], max = [0.105, 0.015] }
material = "water"
velocity = [0, )" + std::to_string(-speed_of_sound_parts * c) +
                                                        R"(]
[material.water]
density = 1000
eos = { type = "tait", stiffness = 1.68e5 }
[[boundary]]
name = "wall"
type = "long_range_wall"
path = [[0, 0], [0.2, 0]]
first_row = 0
rows = 1
in_sums = false
)",
                                                    "shot"));
  double deepest = 1.0;
  for (int step = 0; step < 4000; ++step) {
    shot->advance(1.0);
    const double y = shot->frame().positions[1];
    deepest = std::min(deepest, y);
    if (y > 0.02 || y < -0.02) break;
  }
  const double penetrations = audited(*shot, "penetrations");
  EXPECT_EQ(penetrations, deepest < 0.0 ? 1.0 : 0.0);
  return deepest;
}

TEST(ParticleShotAtAWall, PassesBeyondTheBarrierOnly) {
  // 1.79 times the speed of sound is needed (unit test WallLaws).
  EXPECT_GT(deepest_of_shot(0.5), 0.0);
  EXPECT_GT(deepest_of_shot(1.0), 0.0);
  EXPECT_GT(deepest_of_shot(1.77), 0.0);
  EXPECT_LT(deepest_of_shot(1.81), 0.0);
  EXPECT_LT(deepest_of_shot(2.0), 0.0);
}

TEST(DummyRows, KeepTheBitsForAnyNumberOfThreadsAndAfterARestart) {
  const auto column = [] { return simulation_of("soil_collapse", {"discretisation.spacing=2e-3"}); };
  std::unique_ptr<Simulation> one, two;
  State middle;
  {
    const WithThreads threads(1);
    one = column();
    run_steps(*one, 400);
    middle = one->state();
    run_steps(*one, 300);
  }
  {
    const WithThreads threads(2);
    two = column();
    run_steps(*two, 700);
  }
  EXPECT_GE(audited(*one, "list_builds"), 2.0);
  expect_same_bits(*one, *two);
  const auto continued = column();
  run_steps(*continued, 50);
  continued->restore(middle);
  run_steps(*continued, 300);
  expect_same_bits(*one, *continued);
}

}  // namespace
}  // namespace anvil
