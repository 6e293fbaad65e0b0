// SPDX-License-Identifier: BSD-3-Clause
// A rod far from any wall that moves as a rigid body.
#include <algorithm>
#include <cmath>

#include "verification/simulate.hpp"

namespace anvil {
namespace {

constexpr double spacing = 0.8e-3;           // m
constexpr double shear_modulus = 130e9 / 3;  // Pa

std::unique_ptr<Simulation> free_rod(const std::string& velocity, const std::string& form) {
  return simulation_of("rod_square", {"body.rod.velocity=" + velocity, "boundary.anvil.point=[0, 0, -1]",
                                      "stabiliser.smoothing_form=" + form});
}

// All velocity differences are zero to the last bit, and so is everything that follows from them.
TEST(RigidMotion, TranslationLeavesStressAndVelocityUntouched) {
  for (const std::string form : {"plain", "pairwise"}) {
    const auto rod = free_rod("[100.1, -50.2, 227.3]", form);
    const Frame before = rod->frame();
    run_steps(*rod, 100);
    const Frame after = rod->frame();
    for (const double stress : array_of(after, "stress")) ASSERT_EQ(stress, 0.0);
    EXPECT_EQ(array_of(after, "velocity"), array_of(before, "velocity"));
    EXPECT_EQ(array_of(after, "density"), array_of(before, "density"));
    EXPECT_EQ(audited(*rod, "list_builds"), 1.0) << "the list is made anew although nothing has approached";
    // 100 roundings of positions of some millimetres.
    for (std::size_t i = 0; i < after.particle_count(); ++i)
      ASSERT_NEAR(after.positions[3 * i + 2] - before.positions[3 * i + 2], 227.3 * after.time, 1e-15);
  }
}

/// Largest component of the stress over particles of the initial lattice that lie deeper than `depth` below the faces,
/// and over the others.
struct InnerAndOuter {
  double inner = 0.0, outer = 0.0;
};

InnerAndOuter greatest_stress(const Frame& frame, double depth) {
  const auto place = array_of(frame, "initial_position"), stress = array_of(frame, "stress");
  InnerAndOuter greatest;
  for (std::size_t i = 0; i < frame.particle_count(); ++i) {
    const double x = place[3 * i], y = place[3 * i + 1], z = place[3 * i + 2];
    const bool deep = std::max(std::abs(x), std::abs(y)) < 3.2e-3 - depth && z > depth && z < 32e-3 - depth;
    for (std::size_t c = 0; c < 6; ++c) {
      double& kept = deep ? greatest.inner : greatest.outer;
      kept = std::max(kept, std::abs(stress[6 * i + c]));
    }
  }
  return greatest;
}

// In the first step every particle still sees the lattice, merely turned. Where the support is full, the sums over it
// are isotropic, and the velocity gradient is the spin up to the error of a step: taken at the end of a step that moved
// particles along chords, it holds an expansion of spin^2 dt. Near faces uncorrected gradients see a rotation as a
// strain: the method's known defect, of the order of the spin itself.
TEST(RigidMotion, RotationStrainsOnlyWhereTheSupportIsCut) {
  const auto rod = simulation_of("rod_square", {"body.rod.velocity=[0, 0, 0]", "boundary.anvil.point=[0, 0, -1]",
                                                "stabiliser.conservative_smoothing=0"});
  const double spin = 1000.0;  // 1/s, about y
  State state = rod->state();
  const auto& position = std::get<std::vector<double>>(state.at("field/position").values);
  auto& velocity = std::get<std::vector<double>>(state.at("field/velocity").values);
  for (std::size_t i = 0; i < rod->particle_count(); ++i) {
    velocity[3 * i] = spin * (position[3 * i + 2] - 16e-3);
    velocity[3 * i + 2] = -spin * position[3 * i];
  }
  rod->restore(state);
  rod->advance(1.0);
  const double scale = 2.0 * shear_modulus * spin * rod->last_time_step();
  const auto greatest = greatest_stress(rod->frame(), 2.0 * spacing + 0.1 * spacing);
  // K / G = 3, and two directions expand: 3 + 1/3 times spin dt. Neighbours sum to the identity to a per cent only.
  EXPECT_LT(greatest.inner, 4.0 * spin * rod->last_time_step() * scale);
  EXPECT_GT(greatest.outer, 1e-3 * scale) << "gradients are corrected: say so here";
  EXPECT_LT(greatest.outer, scale);
}

}  // namespace
}  // namespace anvil
