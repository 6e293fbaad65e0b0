// SPDX-License-Identifier: BSD-3-Clause
// A scene pays only for what it requires.
#include <algorithm>

#include "verification/simulate.hpp"

namespace anvil {
namespace {

bool has_term(const Explanation& explanation, const std::string& name) {
  return std::ranges::any_of(explanation.terms, [&](const ExplainedTerm& term) { return term.name == name; });
}

bool has_field(const Explanation& explanation, const std::string& name) {
  return std::ranges::any_of(explanation.fields, [&](const ExplainedField& field) { return field.name == name; });
}

int bytes_without_list(const Explanation& explanation) {
  int bytes = 0;
  for (const auto& field : explanation.fields) bytes += field.bytes_per_particle;
  return bytes;
}

TEST(Explain, ElasticBarPaysLessThanTheRod) {
  const auto bar = simulation_of("bar_elastic_1d", {"shock.method=none"})->explain();
  const auto rod = coarse_rod()->explain();
  EXPECT_LT(bar.terms.size(), rod.terms.size());
  EXPECT_LT(bar.fields.size(), rod.fields.size());
  EXPECT_LT(bar.bytes_per_particle, rod.bytes_per_particle);
  EXPECT_LT(simulation_of("bar_elastic_1d")->explain().bytes_per_particle, rod.bytes_per_particle);
}

TEST(Explain, ElasticBarWithConstantSmoothingLengthFitsIntoFifteenDoubles) {
  const auto bar =
      simulation_of("bar_elastic_1d", {"shock.method=none", "discretisation.variable_smoothing_length=false"})
          ->explain();
  EXPECT_LE(bytes_without_list(bar), 15 * 8);
  EXPECT_FALSE(has_field(bar, "listed_smoothing_length"));
  EXPECT_FALSE(has_field(bar, "plastic_strain"));
  EXPECT_FALSE(has_field(bar, "back_stress"));
}

TEST(Explain, ListsTheFilterAndItsFieldOnlyWhereThereIsOne) {
  const auto smoothed = coarse_rod()->explain();
  EXPECT_TRUE(has_term(smoothed, "conservative_smoothing"));
  EXPECT_TRUE(has_field(smoothed, "start_velocity"));
  EXPECT_FALSE(has_field(smoothed, "medium record"));  // the plain form reads volumes only
  const auto bare = coarse_rod({"stabiliser.conservative_smoothing=0"})->explain();
  EXPECT_FALSE(has_term(bare, "conservative_smoothing"));
  EXPECT_FALSE(has_field(bare, "start_velocity"));
}

TEST(Explain, ListsViscosityAndItsRecordOnlyWhereThereIsOne) {
  EXPECT_FALSE(has_term(coarse_rod()->explain(), "viscosity"));
  const auto viscous = coarse_rod({"shock.method=artificial_viscosity"})->explain();
  EXPECT_TRUE(has_term(viscous, "viscosity"));
  EXPECT_TRUE(has_field(viscous, "medium record"));
}

TEST(Explain, CarriesABackStressOnlyForKinematicHardening) {
  EXPECT_FALSE(has_field(coarse_rod()->explain(), "back_stress"));
  EXPECT_TRUE(has_field(coarse_rod({"material.copper.strength.isotropic_fraction=0.5"})->explain(), "back_stress"));
}

TEST(Explain, CountsParticlesNeighboursAndSteps) {
  const auto rod = coarse_rod();
  const auto explanation = rod->explain();
  EXPECT_EQ(explanation.particles, rod->particle_count());
  EXPECT_EQ(explanation.particles, 320U);
  // At h = dx the support 2 h of an inner particle holds 3^3 - 1 lattice points nearer than 2 dx; surfaces have fewer.
  EXPECT_GT(explanation.neighbours_per_particle, 10.0);
  EXPECT_LT(explanation.neighbours_per_particle, 32.0);
  EXPECT_GT(explanation.bytes_per_particle, bytes_without_list(explanation));
  rod->advance(1.0);
  EXPECT_EQ(rod->last_time_step(), explanation.first_time_step);
  EXPECT_NEAR(static_cast<double>(explanation.steps_expected) * explanation.first_time_step, 80e-6,
              explanation.first_time_step);
}

}  // namespace
}  // namespace anvil
