// SPDX-License-Identifier: BSD-3-Clause
// The two-state function alone, against exact Riemann solutions of lib/exact with the same laws.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "anvil/exact/wave_fan.hpp"
#include "anvil/terms/hllc_star.hpp"

namespace anvil {
namespace {

constexpr double gpa = 1e9;

struct Solid {
  double density;
  PressureLaw law;
  ElasticPlasticConstants constants;
  double bulk_speed_squared;  // at rest, m2/s2

  [[nodiscard]] WaveMaterial exact() const { return WaveMaterial::finite_strain(density, law, constants); }
};

const Solid linear{
    2785.0, PressureLinearInDensity{79e9}, {.shear_modulus = 27.6 * gpa, .yield_stress = 0.3 * gpa}, 79e9 / 2785.0};
const Solid gas{2700.0,
                PressureStiffenedGas{2700.0, 5380.0, 2.67},
                {.shear_modulus = 26.5 * gpa, .yield_stress = 0.3 * gpa},
                5380.0 * 5380.0};
const Solid aluminium{2785.0,
                      PressureMieGrueneisen{2785.0, 5328.0, 1.338, 2.0},
                      {.shear_modulus = 27.6 * gpa, .yield_stress = 0.3 * gpa},
                      5328.0 * 5328.0};
const Solid copper{8930.0,
                   PressureMieGrueneisen{8930.0, 3940.0, 1.490, 2.0},
                   {.shear_modulus = 45.0 * gpa, .yield_stress = 0.09 * gpa},
                   3940.0 * 3940.0};
const Solid elastic{
    2785.0, PressureMieGrueneisen{2785.0, 5328.0, 1.338, 2.0}, {.shear_modulus = 27.6 * gpa}, 5328.0 * 5328.0};
const Solid fluid{1000.0, PressureStiffenedGas{1000.0, 1480.0, 7.0}, {}, 1480.0 * 1480.0};

/// Density, energy and pressure of rest: both sides of all problems here start there, with a deviator of their own.
RiemannSide<double> side_of(const Solid& solid, double velocity, double deviator) {
  const double shear = 4.0 / 3.0 * solid.constants.shear_modulus;
  return {.velocity = velocity,
          .stress = deviator,
          .deviator = deviator,
          .density = solid.density,
          .elastic_speed = std::sqrt(solid.bulk_speed_squared + shear / solid.density),
          .plastic_speed = std::sqrt(solid.bulk_speed_squared),
          .shear = shear,
          .inverse_shear = shear > 0.0 ? 1.0 / shear : 0.0,
          .limit = solid.constants.shear_modulus > 0.0 ? 2.0 / 3.0 * solid.constants.yield_stress : 0.0};
}

struct Stars {
  StarState<double> hllc;
  StarState<double> exact;
};

Stars stars(const Solid& left, double left_velocity, double left_deviator, const Solid& right, double right_velocity,
            double right_deviator) {
  const WaveMaterial left_material = left.exact(), right_material = right.exact();
  const WaveState left_state = left_material.rest(left_velocity, left_deviator);
  const WaveState right_state = right_material.rest(right_velocity, right_deviator);
  ContactSolution solution;
  solve_contact(left_material, left_state, right_material, right_state, {.step = 1e-3 * gpa}, solution);
  return {hllc_star(side_of(left, left_velocity, left_deviator), side_of(right, right_velocity, right_deviator)),
          {solution.left_fan.end(left_state).velocity, solution.stress}};
}

/// Relative difference of the stress, and of the velocity over the velocity difference.
double error_of(const Stars& both, double velocity_difference) {
  return std::max(std::abs(both.hllc.stress / both.exact.stress - 1.0),
                  std::abs(both.hllc.velocity - both.exact.velocity) / std::abs(velocity_difference));
}

struct Pattern {
  std::string name;
  const Solid& left;
  const Solid& right;
  double left_deviator, right_deviator;  // over the yield limit of each side
  double weak_closing;                   // m/s; negative: they part
};

double limit_of(const Solid& solid) {
  return std::isfinite(solid.constants.yield_stress) ? 2.0 / 3.0 * solid.constants.yield_stress : 0.0;
}

class EveryPattern : public testing::TestWithParam<Pattern> {};

/// The acoustic speeds of the two sides are those of weak waves: the relative error falls in proportion to the jump.
TEST_P(EveryPattern, IsExactInTheLimitOfWeakWaves) {
  const Pattern& pattern = GetParam();
  std::vector<double> errors;
  for (const double part : {1.0, 0.5, 0.25}) {
    const double closing = part * pattern.weak_closing;
    const double left_deviator = pattern.left_deviator * limit_of(pattern.left);
    const double right_deviator = pattern.right_deviator * limit_of(pattern.right);
    errors.push_back(error_of(
        stars(pattern.left, 0.5 * closing, left_deviator, pattern.right, -0.5 * closing, right_deviator), closing));
  }
  EXPECT_LT(errors[2], 2e-3);
  EXPECT_GT(std::log2(errors[0] / errors[1]), 0.9) << errors[0] << " " << errors[1];
  EXPECT_GT(std::log2(errors[1] / errors[2]), 0.9) << errors[1] << " " << errors[2];
}

INSTANTIATE_TEST_SUITE_P(Hllc, EveryPattern,
                         testing::Values(Pattern{"fluid_fluid", fluid, fluid, 0, 0, 4.0},
                                         Pattern{"fluid_solid", fluid, elastic, 0, 0, 4.0},
                                         Pattern{"elastic_elastic", aluminium, aluminium, 0, 0, 20.0},
                                         Pattern{"elastic_elastic_linear", linear, linear, 0, 0, 20.0},
                                         Pattern{"elastic_elastic_gas", gas, gas, 0, 0, 20.0},
                                         Pattern{"elastic_rarefactions", aluminium, aluminium, 0, 0, -20.0},
                                         Pattern{"without_yield", elastic, elastic, 0, 0, 40.0}),
                         [](const auto& named) { return named.param.name; });

}  // namespace
}  // namespace anvil
