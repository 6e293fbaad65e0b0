// SPDX-License-Identifier: BSD-3-Clause
// Elastic-plastic waves: figures worked out by hand, conservation, and limits in which answers are known.
#include <gtest/gtest.h>

#include <cmath>

#include "anvil/exact/front_tracking.hpp"
#include "unit/exact/plates.hpp"

namespace anvil {
namespace {

WaveProfile profile_at(const PlateProblem& problem, double time, const TrackingAccuracy& accuracy = {}) {
  FrontTracking fronts(problem, time, accuracy);
  fronts.advance_to(time);
  return fronts.profile();
}

struct Plateau {
  double begin, end;  // mm
  double stress;      // GPa
};

/// Every plateau begins, ends and stands as given; positions to a hundredth of a millimetre.
void expect_plateaus(const WaveProfile& profile, const std::vector<Plateau>& plateaus, double stress_digits) {
  for (const Plateau& plateau : plateaus) {
    for (const double position : {plateau.begin + 0.006, 0.5 * (plateau.begin + plateau.end), plateau.end - 0.006})
      EXPECT_NEAR(profile.zone_at(position * mm).state.stress / gpa, plateau.stress, 0.5 * stress_digits) << position;
  }
}

TEST(FrontTracking, SolvesThePerfectlyPlasticPlate) {
  const PlateProblem problem = perfect_plate(steel());
  expect_plateaus(
      profile_at(problem, 8.0 * us),
      {{0.0, 16.02, 0.0}, {16.03, 19.69, -1.0582}, {19.70, 42.72, -5.0}, {42.73, 52.52, -1.9709}, {52.53, 80.0, 0.0}},
      1e-4);
  expect_plateaus(profile_at(problem, 14.0 * us),
                  {{48.07, 59.09, -1.058}, {59.09, 68.08, -5.0}, {68.09, 74.77, -3.232}, {74.78, 75.46, -1.971}}, 1e-3);
}

TEST(FrontTracking, SpeedsAndVelocitiesOfThePerfectlyPlasticPlate) {
  EXPECT_NEAR(steel().elastic_limit() / gpa, 1.9709, 5e-5);
  EXPECT_NEAR(steel().elastic_wave_speed(), 6565.6, 0.05);
  EXPECT_NEAR(steel().plastic_wave_speed(), 5340.9, 0.05);
  EXPECT_NEAR(steel(hardening_steel()).plastic_wave_speed(), 5462.0, 1.0);
  EXPECT_NEAR(hardening_steel().hardening_modulus / gpa, 25.28, 5e-3);
  const WaveProfile profile = profile_at(perfect_plate(steel()), 4.0 * us);
  EXPECT_NEAR(profile.zone_at(24.0 * mm).state.velocity, 38.49, 5e-3);
  EXPECT_NEAR(profile.zone_at(10.0 * mm).state.velocity, 111.20, 5e-3);
}

TEST(FrontTracking, SolvesTheSymmetricImpact) {
  const WaveProfile profile = profile_at(two_plates(steel(), steel(), 100.0), 15.0 * us);
  for (const double side : {-1.0, 1.0}) {
    EXPECT_NEAR(profile.zone_at(side * 98.47 * mm).state.stress / gpa, -1.9709, 5e-5);
    EXPECT_NEAR(profile.zone_at(side * 98.49 * mm).state.stress, 0.0, 1.0);
    EXPECT_NEAR(profile.zone_at(side * 80.12 * mm).state.stress / gpa, -1.9709, 5e-5);
    EXPECT_NEAR(profile.zone_at(side * 80.10 * mm).state.stress / gpa, -2.4506, 5e-5);
    EXPECT_NEAR(profile.zone_at(side * 1.0 * mm).state.velocity, 50.0, 1e-6);
  }
}

/// Rankine-Hugoniot: s [J] = -[v], rho0 s [v] = -[sigma], rho0 s [e + v^2 / 2] = -[sigma v].
void expect_jump_conditions(const WaveZone& left, const WaveZone& right, double speed) {
  const WaveState& a = left.state;
  const WaveState& b = right.state;
  const double momentum_flow = left.reference_density * speed;
  EXPECT_NEAR(speed * (b.strain - a.strain), -(b.velocity - a.velocity), 1e-9 * std::abs(a.velocity + b.velocity));
  EXPECT_NEAR(momentum_flow * (b.velocity - a.velocity), -(b.stress - a.stress), 1e-9 * gpa);
  const auto energy = [](const WaveState& state) { return state.energy + 0.5 * state.velocity * state.velocity; };
  EXPECT_NEAR(momentum_flow * (energy(b) - energy(a)), -(b.stress * b.velocity - a.stress * a.velocity),
              1e-9 * gpa * 100.0);
}

TEST(FrontTracking, FrontsOfAnUnsymmetricImpactKeepMassMomentumAndEnergy) {
  const WaveMaterial aluminium = WaveMaterial::finite_strain(2710.0, PressureLinearInDensity{66.67 * gpa},
                                                             {.shear_modulus = 25.0 * gpa, .yield_stress = 0.5 * gpa});
  for (const WaveMaterial& target : {steel(), dense_steel(), logarithmic_steel(hardening_steel())}) {
    const double time = 10.0 * us;
    const WaveProfile profile = profile_at(two_plates(aluminium, target, 400.0), time);
    ASSERT_EQ(profile.zones.size(), 6U);  // two fronts on either side of the contact
    for (std::size_t i = 0; i + 1 < profile.zones.size(); ++i) {
      // All fronts started together at the contact, x = 0.
      const double speed = profile.zones[i].end / time;
      expect_jump_conditions(profile.zones[i], profile.zones[i + 1], speed);
    }
  }
}

TEST(FrontTracking, ImpactStressFollowsFromTheImpedances) {
  // Both sides yield: HEL plus plastic jump on either side, in small strain.
  const WaveMaterial aluminium =
      WaveMaterial::small_strain(2710.0, 66.67 * gpa, {.shear_modulus = 25.0 * gpa, .yield_stress = 0.5 * gpa});
  const double velocity = 400.0;
  const WaveProfile profile = profile_at(two_plates(aluminium, steel(), velocity), 1.0 * us);
  const auto velocity_jump = [](const WaveMaterial& material, double pressure) {
    const double limit = material.elastic_limit();
    return limit / (material.density() * material.elastic_wave_speed()) +
           (pressure - limit) / (material.density() * material.plastic_wave_speed());
  };
  const double pressure = -profile.zone_at(0.0).state.stress;
  EXPECT_GT(pressure, steel().elastic_limit());
  EXPECT_NEAR(velocity_jump(aluminium, pressure) + velocity_jump(steel(), pressure), velocity, 1e-9 * velocity);
}

TEST(FrontTracking, KeepsMomentumAndEnergy) {
  for (const WaveMaterial& material : {steel(), logarithmic_steel(), dense_steel(), steel(hardening_steel())}) {
    FrontTracking fronts(perfect_plate(material), 14.0 * us, {.step = 1.0 / 64.0, .smallest = 1e-6});
    for (const double time : {4.0, 8.0, 12.0, 14.0}) {
      fronts.advance_to(time * us);
      const WaveProfile profile = fronts.profile();
      // Fronts lose nothing; some hundred waves below 1e-6 of the load are not followed.
      EXPECT_NEAR(profile.momentum() / fronts.impulse(), 1.0, 1e-5) << time;
      EXPECT_NEAR(profile.energy() / fronts.work(), 1.0, 1e-4) << time;
    }
  }
}

TEST(FrontTracking, ElasticPlateKeepsItsEnergyThroughManyReflections) {
  const PlateProblem problem = two_layer_plate();
  FrontTracking fronts(problem, 200.0 * us, {});
  fronts.advance_to(200.0 * us);
  EXPECT_NEAR(fronts.profile().energy() / fronts.work(), 1.0, 1e-7);
  EXPECT_NEAR(fronts.profile().momentum() / fronts.impulse(), 1.0, 1e-7);
}

TEST(FrontTracking, ReverseYieldDependsOnTheKindOfHardening) {
  // Loaded to 5 GPa and let go: the elastic unloading spans 2 HEL, more when isotropic hardening widened the range.
  const auto shelf = [](double isotropic_fraction) {
    ElasticPlasticConstants constants = hardening_steel();
    constants.isotropic_fraction = isotropic_fraction;
    const WaveProfile profile = profile_at(perfect_plate(steel(constants)), 6.0 * us);
    const double head = steel().elastic_wave_speed() * 1.0 * us;
    return profile.zone_at(head - 0.1 * mm).state.stress;
  };
  const double limit = steel().elastic_limit();
  const WaveMaterial material = steel(hardening_steel());
  // Share of the plastic stress by which the deviator's limit grows, and what that is worth in axial stress.
  const double deviator_share = (material.plastic_modulus() - steel_bulk_modulus) / material.plastic_modulus();
  const double deviator_growth = (5.0 * gpa - limit) * deviator_share;
  const double per_deviator = material.elastic_modulus() / (material.elastic_modulus() - steel_bulk_modulus);
  EXPECT_NEAR(shelf(0.0), -5.0 * gpa + 2.0 * limit, 1e-6 * gpa);
  EXPECT_NEAR(shelf(1.0), -5.0 * gpa + 2.0 * limit + 2.0 * deviator_growth * per_deviator, 1e-6 * gpa);
}

TEST(FrontTracking, FiniteStrainTendsToSmallStrain) {
  // A load of a hundredth: strains of 2e-4, so the laws differ by about that, relative; yield scaled alike.
  ElasticPlasticConstants weak = steel_constants;
  weak.yield_stress *= 0.01;
  const PressureHistory load = PressureHistory::rectangular(0.05 * gpa, 5.0 * us);
  for (const double time : {4.0, 8.0, 14.0}) {
    const WaveProfile small = profile_at(loaded_plate(steel(weak), load), time * us);
    for (const WaveMaterial& material : {logarithmic_steel(weak), dense_steel(weak)}) {
      const WaveProfile finite = profile_at(loaded_plate(material, load), time * us);
      EXPECT_LT(mean_stress_difference(small, finite), 1e-3 * mean_stress(small)) << time;
    }
  }
}

TEST(FrontTracking, CurrentPositionsFollowTheVelocity) {
  const PlateProblem problem = two_plates(dense_steel(), dense_steel(), 100.0);
  const WaveProfile profile = profile_at(problem, 10.0 * us);
  // The contact moves at half the impact velocity from the start, the far ends as they began.
  EXPECT_NEAR(profile.current_position(0.0), 50.0 * 10.0 * us, 1e-12);
  EXPECT_NEAR(profile.current_position(-100.0 * mm), -100.0 * mm + 100.0 * 10.0 * us, 1e-12);
  EXPECT_NEAR(profile.current_position(100.0 * mm), 100.0 * mm, 1e-12);
}

TEST(FrontTracking, SaysWhenWavesGrowTooMany) {
  FrontTracking fronts(perfect_plate(steel()), 40.0 * us, {.smallest = 1e-6, .most_events = 1000});
  EXPECT_THROW(fronts.advance_to(40.0 * us), TooManyFronts);
}

TEST(FrontTracking, RefusesARodThatYieldsWithoutHardening) {
  EXPECT_THROW(WaveMaterial::uniaxial_stress(7800.0, 210.0 * gpa, {.yield_stress = 1.0 * gpa}), InputError);
}

}  // namespace
}  // namespace anvil
