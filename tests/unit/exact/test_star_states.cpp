// SPDX-License-Identifier: BSD-3-Clause
// Impacts with equations of state that read the energy: star states worked out apart, by Rankine-Hugoniot.
#include <gtest/gtest.h>

#include <cmath>

#include "anvil/exact/front_tracking.hpp"
#include "unit/exact/plates.hpp"

namespace anvil {
namespace {

WaveMaterial aluminium() {
  return WaveMaterial::finite_strain(2785.0, PressureMieGrueneisen{2785.0, 5328.0, 1.338, 2.0},
                                     {.shear_modulus = 27.6 * gpa, .yield_stress = 0.3 * gpa});
}
WaveMaterial copper() {
  return WaveMaterial::finite_strain(8930.0, PressureMieGrueneisen{8930.0, 3940.0, 1.490, 2.0},
                                     {.shear_modulus = 45.0 * gpa, .yield_stress = 0.09 * gpa});
}
WaveMaterial gas_like_aluminium() {
  return WaveMaterial::finite_strain(2700.0, PressureStiffenedGas{2700.0, 5380.0, 2.67},
                                     {.shear_modulus = 26.5 * gpa, .yield_stress = 0.3 * gpa});
}

WaveProfile profile_at(const PlateProblem& problem, double time) {
  FrontTracking fronts(problem, time, {.step = 1.0 / 64.0, .smallest = 2e-4});
  fronts.advance_to(time);
  return fronts.profile();
}

/// The zones beside the only front that the initial positions `from` and `to` (m) enclose, and where it is now.
struct IsolatedFront {
  const WaveZone* left;
  const WaveZone* right;
  double position;
};
IsolatedFront front_between(const WaveProfile& profile, double from, double to) {
  IsolatedFront found{nullptr, nullptr, 0.0};
  double largest = 0.0;
  for (std::size_t i = 0; i + 1 < profile.zones.size(); ++i) {
    const WaveZone& zone = profile.zones[i];
    const double jump = std::abs(zone.state.stress - profile.zones[i + 1].state.stress);
    if (zone.end <= from || zone.end >= to || jump <= largest) continue;
    largest = jump;
    found = {&zone, &profile.zones[i + 1], profile.current_position(zone.end)};
  }
  return found;
}

PlateProblem wilkins() {
  PlateProblem problem;
  problem.layers = {{5.0 * mm, aluminium(), 800.0}, {45.0 * mm, aluminium()}};
  return problem;
}

TEST(StarStates, OfTheAluminiumFlyer) {
  const WaveProfile profile = profile_at(wilkins(), 0.5 * us);
  const WaveState behind = profile.zone_at(5.0 * mm).state;
  EXPECT_NEAR(behind.velocity, 400.0, 1e-6);
  EXPECT_NEAR(profile.zone_at(5.0 * mm).density(), 2985.629, 5e-4);
  EXPECT_NEAR(behind.pressure() / gpa, 6.435879, 5e-7);
  EXPECT_NEAR(behind.deviator / gpa, -0.2, 1e-9);
  EXPECT_NEAR(behind.energy, 8.1272e4, 0.5);
  const WaveState precursor = profile.zones[profile.zones.size() - 2].state;
  EXPECT_NEAR(precursor.stress / gpa, -0.6359, 5e-5);
  EXPECT_NEAR(precursor.velocity, 35.18, 5e-3);
}

TEST(StarStates, OfTheAluminiumFlyerAfterItsRelease) {
  const WaveProfile profile = profile_at(wilkins(), 5.0 * us);
  const IsolatedFront shock = front_between(profile, 33.5 * mm, 35.5 * mm);
  EXPECT_NEAR(shock.position / mm, 34.543, 5e-4);
  const double start = 5.0 * mm;
  EXPECT_NEAR((shock.position - start) / (5.0 * us), 5909.0, 0.5);
  const IsolatedFront precursor = front_between(profile, 36.0 * mm, 40.0 * mm);
  EXPECT_NEAR(precursor.position / mm, 37.452, 5e-4);
  EXPECT_NEAR((precursor.position - start) / (5.0 * us), 6490.0, 0.5);
  EXPECT_NEAR(profile.current_position(start) / mm, 5.69, 5e-3);
  // The shelf behind the elastic release: the last state before the reverse yield begins to lower the pressure.
  const WaveZone* shelf = nullptr;
  for (const WaveZone& zone : profile.zones)
    if (zone.end < shock.left->end && zone.state.deviator > 0.19 * gpa &&
        (shelf == nullptr || zone.width() > shelf->width()) && zone.state.stress < -5.0 * gpa)
      shelf = &zone;
  ASSERT_NE(shelf, nullptr);
  // Fronts of the fan stand for a smooth release: off by the square of their size.
  EXPECT_NEAR(shelf->state.stress / gpa, -5.113585, 1e-4);
  EXPECT_NEAR(shelf->state.deviator / gpa, 0.2, 1e-6);
}

TEST(StarStates, OfCopperOnAluminium) {
  PlateProblem problem;
  problem.layers = {{25.0 * mm, copper(), 60.0}, {25.0 * mm, aluminium()}};
  const WaveProfile profile = profile_at(problem, 2.0 * us);
  const WaveZone& copper_star = profile.zone_at(24.999 * mm);
  const WaveZone& aluminium_star = profile.zone_at(25.001 * mm);
  for (const WaveZone* star : {&copper_star, &aluminium_star}) {
    EXPECT_NEAR(star->state.velocity, 40.646, 5e-4);
    EXPECT_NEAR(star->state.stress / gpa, -0.7185, 5e-5);
  }
  EXPECT_NEAR(copper_star.state.pressure() / gpa, 0.6585, 5e-5);
  EXPECT_NEAR(copper_star.state.deviator / gpa, -0.060, 5e-7);
  EXPECT_NEAR(copper_star.density(), 8972.0, 0.05);
  EXPECT_NEAR(aluminium_star.state.pressure() / gpa, 0.5185, 5e-5);
  EXPECT_NEAR(aluminium_star.state.deviator / gpa, -0.200, 5e-7);
  EXPECT_NEAR(aluminium_star.density(), 2803.0, 0.05);
  ASSERT_EQ(profile.zones.size(), 6U);
  EXPECT_NEAR(profile.zones[1].state.stress / gpa, -0.1990, 5e-5);
  EXPECT_NEAR(profile.zones[4].state.stress / gpa, -0.6359, 5e-5);
  const double fronts[] = {15.676, 17.168, 25.081, 35.864, 37.981};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(profile.current_position(profile.zones[i].end) / mm, fronts[i], 5e-4);
  EXPECT_NEAR((profile.current_position(profile.zones[0].end) - 25.0 * mm) / (2.0 * us), 60.0 - 4722.0, 0.5);
  EXPECT_NEAR((profile.current_position(profile.zones[3].end) - 25.0 * mm) / (2.0 * us), 5432.0, 0.5);
}

TEST(StarStates, OfStressedAluminiumBlocks) {
  PlateProblem problem;
  problem.left_position = -1.0;
  problem.layers = {{1.0, gas_like_aluminium(), 200.0, -0.2 * gpa}, {1.0, gas_like_aluminium(), -200.0}};
  problem.left_face.pressure = PressureHistory::constant(0.2 * gpa);
  const WaveProfile profile = profile_at(problem, 0.1e-3);
  const WaveZone& left = profile.zone_at(-1e-3);
  const WaveZone& right = profile.zone_at(1e-3);
  EXPECT_NEAR(left.state.velocity, 3.126, 5e-4);
  EXPECT_NEAR(left.state.stress / gpa, -3.163518, 5e-7);
  EXPECT_NEAR(left.state.pressure() / gpa, 2.963518, 5e-7);
  EXPECT_NEAR(left.density(), 2798.835, 5e-4);
  EXPECT_NEAR(right.density(), 2798.895, 5e-4);
  const IsolatedFront left_shock = front_between(profile, -0.99, -0.1);
  EXPECT_NEAR(left_shock.position, -0.53751, 5e-6);
  const IsolatedFront right_shock = front_between(profile, 0.1, 0.6);
  EXPECT_NEAR(right_shock.position, 0.54085, 5e-6);
  EXPECT_NEAR(right_shock.right->state.stress / gpa, -0.646677, 5e-7);
  EXPECT_NEAR(right_shock.right->state.velocity, -163.232, 5e-4);
}

TEST(StarStates, ContactOfEqualStatesIsQuiet) {
  const WaveMaterial material = aluminium();
  ContactSolution solution;
  solve_contact(material, material.rest(10.0), material, material.rest(10.0), {}, solution);
  EXPECT_EQ(solution.stress, 0.0);
  EXPECT_TRUE(solution.left_fan.fronts.empty());
  EXPECT_TRUE(solution.right_fan.fronts.empty());
}

TEST(StarStates, AStrongShockOvertakesItsPrecursor) {
  // At 3000 m/s the plastic shock is faster than an elastic wave: one front.
  const WaveMaterial material = aluminium();
  ContactSolution solution;
  solve_contact(material, material.rest(6000.0), material, material.rest(), {}, solution);
  ASSERT_EQ(solution.right_fan.fronts.size(), 1U);
  EXPECT_GT(solution.right_fan.fronts.front().speed, material.elastic_wave_speed());
  EXPECT_NEAR(solution.right_fan.fronts.front().behind.velocity, 3000.0, 1e-6);
}

}  // namespace
}  // namespace anvil
