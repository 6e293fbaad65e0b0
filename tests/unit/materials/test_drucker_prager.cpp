// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/materials/strength/drucker_prager.hpp"

#include <gtest/gtest.h>

#include "unit/materials/specimens.hpp"

namespace anvil {
namespace {

using testing_support::RandomTensors;

constexpr double bulk_modulus = 8.3e5, shear_modulus = 3.9e5;  // Pa
constexpr double friction_angle = 27.5 * std::numbers::pi / 180.0;

DruckerPrager soil(double cohesion, double dilatancy_angle, const char* flow = "non_associated",
                   const char* opening = "remembered") {
  Parameters keys;
  keys.set("shear_modulus", shear_modulus);
  keys.set("friction_angle", 27.5);
  keys.set("cohesion", cohesion);
  keys.set("dilatancy_angle", dilatancy_angle);
  keys.set("flow", flow);
  keys.set("opening", opening);
  return DruckerPrager(keys);
}

double root_of(const Tensor& deviator) { return std::sqrt(equivalent_stress_squared(deviator) / 3.0); }

TEST(DruckerPrager, ReturnsToTheYieldSurface) {
  RandomTensors random;
  for (const double dilatancy : {0.0, 5.0, 20.0}) {
    const DruckerPrager law = soil(100.0, dilatancy);
    for (int trial = 0; trial < 50; ++trial) {
      Tensor deviator = random.deviator(5e3);
      const Tensor before = deviator;
      double pressure = 1e3, dilation = 0.0;
      StrengthHistory history;
      const PlasticStep step = law.limit(deviator, pressure, dilation, bulk_modulus, history);
      if (root_of(before) <= law.shear_strength(1e3)) {
        EXPECT_EQ(deviator, before);
        EXPECT_EQ(pressure, 1e3);
        continue;
      }
      EXPECT_NEAR(root_of(deviator), law.shear_strength(pressure), 1e-10);  // Pa, of some 1e3
      EXPECT_GT(step.plastic_strain_increment, 0.0);
      // The printed potential dilates by nine times sin(psi): against pressure that takes more than the shear gives.
      if (dilatancy == 0.0) {
        EXPECT_GT(step.plastic_work, 0.0);
      }
      // Dilation presses the soil that cannot widen: p = 1000 + K times the plastic volume strain.
      EXPECT_NEAR(pressure, 1e3 + bulk_modulus * dilation, 1e-9);
      EXPECT_EQ(dilation > 0.0, dilatancy > 0.0);
    }
  }
}

/// Associated flow follows the normal of the yield surface: volume over shear strain is 3 alpha to one.
TEST(DruckerPrager, AssociatedFlowIsNormalToTheYieldSurface) {
  const DruckerPrager law = soil(0.0, 0.0, "associated");
  Tensor deviator = Vec<3>(3e3, -3e3, 0.0).asDiagonal().toDenseMatrix();
  const double trial_root = root_of(deviator);
  double pressure = 2e3, dilation = 0.0;
  StrengthHistory history;
  law.limit(deviator, pressure, dilation, bulk_modulus, history);
  const double multiplier = (trial_root - root_of(deviator)) / shear_modulus;
  const double tangent = std::tan(friction_angle), alpha = tangent / std::sqrt(9.0 + 12.0 * tangent * tangent);
  EXPECT_NEAR(dilation, 3.0 * alpha * multiplier, 1e-12);
}

TEST(DruckerPrager, CarriesNoTensionBeyondTheApex) {
  for (const double cohesion : {0.0, 300.0}) {
    const DruckerPrager law = soil(cohesion, 0.0);
    Tensor deviator = Vec<3>(3e3, -2e3, -1e3).asDiagonal().toDenseMatrix();
    double pressure = -5e3, dilation = 0.0;
    StrengthHistory history;
    law.limit(deviator, pressure, dilation, bulk_modulus, history);
    EXPECT_NEAR(pressure, -cohesion / std::tan(friction_angle), 1e-9);
    EXPECT_NEAR(root_of(deviator), 0.0, 1e-9);
    EXPECT_EQ(dilation, 0.0);
  }
}

/// Drawn out and pressed together again by as much: what remembers its opening is back where it was, what forgets it
/// carries a pressure at its old volume.
TEST(DruckerPrager, RemembersOrForgetsAnOpening) {
  for (const char* opening : {"remembered", "forgotten"}) {
    const DruckerPrager law = soil(0.0, 0.0, "non_associated", opening);
    double dilation = 0.0, pressure = 0.0;
    for (const double volume_strain : {0.0, 1e-3, 2e-3, 1e-3, 0.0}) {
      Tensor deviator = Tensor::Zero();
      StrengthHistory history;
      pressure = -bulk_modulus * volume_strain + bulk_modulus * dilation;
      law.limit(deviator, pressure, dilation, bulk_modulus, history);
    }
    EXPECT_NEAR(pressure, std::string(opening) == "forgotten" ? 2e-3 * bulk_modulus : 0.0, 1e-9);
  }
}

/// Simple shear under constant volume: the work of the stress is stored or plastic.
TEST(DruckerPrager, StressPowerIsStoredOrDissipated) {
  const DruckerPrager law = soil(100.0, 10.0);
  const double step = 1e-6;
  Tensor deviator = Tensor::Zero();
  double pressure = 1e3, dilation = 1e3 / bulk_modulus, supplied = 0.0, dissipated = 0.0;
  const double start = 0.5 * pressure * pressure / bulk_modulus;
  StrengthHistory history;
  for (int k = 0; k < 20000; ++k) {
    const double before = deviator(0, 1);
    deviator(0, 1) = deviator(1, 0) = before + shear_modulus * step;
    dissipated += law.limit(deviator, pressure, dilation, bulk_modulus, history).plastic_work;
    supplied += 0.5 * (before + deviator(0, 1)) * step;
  }
  const double root = root_of(deviator);
  const double stored = 0.5 * pressure * pressure / bulk_modulus + 0.5 * root * root / shear_modulus;
  EXPECT_GT(dilation, 1e-3);
  EXPECT_NEAR(stored + dissipated - start, supplied, 1e-3 * supplied);  // first order in the step
}

}  // namespace
}  // namespace anvil
