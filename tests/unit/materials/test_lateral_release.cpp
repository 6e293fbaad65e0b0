// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/materials/lateral_release.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "anvil/core/field_keys.hpp"
#include "anvil/materials/material_update.hpp"

namespace anvil {
namespace {

constexpr double bulk = 222.5e9, shear = 85.3e9, density = 7800.0;
const double young = 9.0 * bulk * shear / (3.0 * bulk + shear);

/// One particle of a bar, strained step by step as the solver does it.
struct BarPoint {
  explicit BarPoint(const TypedEntry& strength_entry) : fields(1) {
    TypedEntry eos_entry{"linear", {}};
    eos_entry.parameters.set("bulk_modulus", bulk);
    const Strength law = make_strength(strength_entry);
    const Eos pressure_law = make_eos(eos_entry, density);
    strength = make_strength_update<1>(law, fields);
    eos = make_eos_update<1>(pressure_law, fields);
    release = make_lateral_release(law, pressure_law, fields);
    fields.scalar(field::density)[0] = density;
    fields.scalar(field::mass)[0] = 1.0;
  }

  void strain(double rate, double time_step) {
    double lateral_rate = 0.0, sound_speed = 0.0;
    release->find_rates({0, 1}, &rate, time_step, &lateral_rate);
    const double half = 0.5 * time_step * (rate + 2.0 * lateral_rate);
    fields.scalar(field::density)[0] *= (1.0 - half) / (1.0 + half);
    strength->update({0, 1}, &rate, &lateral_rate, time_step);
    eos->update({0, 1}, &sound_speed);
    lateral_strain += lateral_rate * time_step;
  }
  [[nodiscard]] double pressure() const { return fields.scalar(field::pressure)[0]; }
  [[nodiscard]] double deviator() const {
    return fields.has(field::deviatoric_stress) ? fields.scalar(field::deviatoric_stress)[0] : 0.0;
  }
  [[nodiscard]] double axial_stress() const { return deviator() - pressure(); }
  [[nodiscard]] double lateral_stress() const { return -0.5 * deviator() - pressure(); }

  FieldStore fields;
  std::unique_ptr<StrengthUpdate<1>> strength;
  std::unique_ptr<EosUpdate<1>> eos;
  std::unique_ptr<LateralRelease> release;
  double lateral_strain = 0.0;
};

TypedEntry j2(double hardening_modulus) {
  TypedEntry entry{"j2", {}};
  entry.parameters.set("shear_modulus", shear);
  entry.parameters.set("yield_stress", 1e9);
  entry.parameters.set("hardening_modulus", hardening_modulus);
  entry.parameters.set("isotropic_fraction", 1.0);
  return entry;
}

TEST(LateralRelease, AnElasticBarHasYoungsModulusAndPoissonsRatio) {
  TypedEntry elastic{"elastic", {}};
  elastic.parameters.set("shear_modulus", shear);
  BarPoint bar(elastic);
  for (int step = 0; step < 100; ++step) bar.strain(1e5, 1e-10);  // to 1e-3
  // The strain is logarithmic, the pressure linear in the density: equal to first order, 1e-3 apart.
  EXPECT_NEAR(bar.axial_stress(), young * 1e-3, 1e-3 * young * 1e-3);
  EXPECT_NEAR(bar.lateral_strain, -(3.0 * bulk - 2.0 * shear) / (6.0 * bulk + 2.0 * shear) * 1e-3, 1e-3 * 1e-3);
  EXPECT_NEAR(bar.lateral_stress(), 0.0, 1e-13 * bulk);  // the accuracy asked for, in strain
}

TEST(LateralRelease, APerfectlyPlasticBarYieldsAtItsYieldStressBothWays) {
  BarPoint bar(j2(0.0));
  for (int step = 0; step < 200; ++step) bar.strain(1e6, 1e-10);  // to 2 %
  EXPECT_NEAR(bar.axial_stress(), 1e9, 1.0);
  EXPECT_NEAR(bar.lateral_stress(), 0.0, 1e-13 * bulk);
  for (int step = 0; step < 400; ++step) bar.strain(-1e6, 1e-10);
  EXPECT_NEAR(bar.axial_stress(), -1e9, 1.0);
}

TEST(LateralRelease, AHardeningBarFollowsItsTangentModulus) {
  const double hardening = 25e9, strain = 0.01;
  BarPoint bar(j2(hardening));
  for (int step = 0; step < 1000; ++step) bar.strain(1e5, 1e-10);
  const double expected = 1e9 + young * hardening / (young + hardening) * (strain - 1e9 / young);
  // First order in the stress over the bulk modulus, 0.5 %, since the pressure is linear in the density.
  EXPECT_NEAR(bar.axial_stress(), expected, 5e-3 * expected);
}

TEST(LateralRelease, AFluidBarCarriesNothing) {
  BarPoint bar({"none", {}});
  for (int step = 0; step < 100; ++step) bar.strain(1e5, 1e-10);
  EXPECT_NEAR(bar.axial_stress(), 0.0, 1e-13 * bulk);
}

}  // namespace
}  // namespace anvil
