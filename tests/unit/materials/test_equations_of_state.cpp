// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "anvil/core/error.hpp"
#include "anvil/materials/material_tables.hpp"
#include "unit/materials/specimens.hpp"
#include "unit/models_page.hpp"

namespace anvil {
namespace {

constexpr double reference_density = 8000.0;

template <class Law>
class EveryEquationOfState : public testing::Test {
 protected:
  const Law law_{testing_support::specimen(Law::kind(), false), reference_density};
};
TYPED_TEST_SUITE(EveryEquationOfState, testing_support::AlternativesOf<Eos>::Types);

TYPED_TEST(EveryEquationOfState, HasNoPressureAtRest) { EXPECT_EQ(this->law_.pressure(reference_density, 0.0), 0.0); }

TYPED_TEST(EveryEquationOfState, PressureRisesWithCompression) {
  EXPECT_GT(this->law_.pressure(1.01 * reference_density, 0.0), 0.0);
  EXPECT_LT(this->law_.pressure(0.99 * reference_density, 0.0), 0.0);
}

// Along the isentrope de = p / rho^2 drho.
TYPED_TEST(EveryEquationOfState, SoundSpeedIsTheSlopeOfTheIsentrope) {
  for (const double compression : {0.95, 1.0, 1.05, 1.2}) {
    for (const double energy : {0.0, 1e5}) {
      const double density = compression * reference_density;
      const double step = 1e-5 * density;
      const double energy_step = this->law_.pressure(density, energy) / (density * density) * step;
      const double slope = (this->law_.pressure(density + step, energy + energy_step) -
                            this->law_.pressure(density - step, energy - energy_step)) /
                           (2.0 * step);
      const double squared = this->law_.bulk_sound_speed_squared(density, energy);
      EXPECT_GT(squared, 0.0);
      // Truncation is of the order of the relative step squared; round-off 1e-16 / 1e-5 times p / (rho c^2).
      EXPECT_NEAR(squared, slope, 1e-8 * squared) << "rho / rho0 = " << compression << ", e = " << energy;
    }
  }
}

TYPED_TEST(EveryEquationOfState, EnergyDerivativeIsTheSlopeAtConstantDensity) {
  if constexpr (HasEnergyDerivative<TypeParam>) {
    for (const double compression : {0.95, 1.0, 1.2}) {
      const double density = compression * reference_density;
      const double slope =
          (this->law_.pressure(density, 1.5e5) - this->law_.pressure(density, 0.5e5)) / 1e5;  // laws linear in energy
      EXPECT_NEAR(this->law_.energy_derivative(density, 1e5), slope, 1e-9 * slope) << "rho / rho0 = " << compression;
    }
  } else {
    EXPECT_FALSE(TypeParam::uses_energy) << "the energy equation needs the derivative";
  }
}

TYPED_TEST(EveryEquationOfState, ColdEnergyIsTheWorkOfCompression) {
  if constexpr (HasColdEnergy<TypeParam>) {
    EXPECT_EQ(this->law_.cold_energy(reference_density), 0.0);
    for (const double compression : {0.9, 0.999, 1.001, 1.3}) {
      const double density = compression * reference_density;
      const double step = 1e-5 * density;
      const double slope =
          (this->law_.cold_energy(density + step) - this->law_.cold_energy(density - step)) / (2.0 * step);
      const double expected = this->law_.pressure(density, 0.0) / (density * density);
      // Truncation is (step / strain)^2 or less: 1e-4 at a strain of 0.001 where the energy is a parabola, which a
      // central difference follows exactly; what remains is of order 1e-8.
      EXPECT_NEAR(slope, expected, 1e-7 * std::abs(expected)) << "rho / rho0 = " << compression;
    }
  } else {
    EXPECT_TRUE(TypeParam::uses_energy) << "a law of density alone stores its energy: offer cold_energy";
  }
}

TYPED_TEST(EveryEquationOfState, IsMadeByItsName) {
  const EntryKind kind = TypeParam::kind();
  const Eos made = make_eos({std::string(kind.type), testing_support::specimen(kind, false)}, reference_density);
  ASSERT_TRUE(std::holds_alternative<TypeParam>(made));
  EXPECT_EQ(std::get<TypeParam>(made).pressure(8100.0, 1.0), this->law_.pressure(8100.0, 1.0));
}

TYPED_TEST(EveryEquationOfState, HasARowInTheModelsPage) {
  EXPECT_TRUE(testing_support::models_page_has_row("Equations of state", TypeParam::kind().type));
}

TEST(EosTable, AnUnknownNameIsAnsweredWithTheKnownOnes) {
  try {
    make_eos({"linnear", {}}, 1.0);
    FAIL() << "no error";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("'linnear'"), std::string::npos) << message;
    for (const EntryKind& kind : eos_kinds()) EXPECT_NE(message.find(kind.type), std::string::npos) << message;
  }
}

TEST(LinearEos, HasThePressureAndStoredEnergyOfItsFormula) {
  Parameters parameters;
  parameters.set("bulk_modulus", 130e9);
  const LinearEos copper(parameters, 8930.0);
  EXPECT_DOUBLE_EQ(copper.pressure(1.1 * 8930.0, 0.0), 13e9);
  // A small strain stores K e^2 / 2 per volume; the next term of the series is smaller by the strain.
  const double strain = 1e-6;
  EXPECT_NEAR(8930.0 * copper.cold_energy(8930.0 * (1.0 + strain)), 0.5 * 130e9 * strain * strain, 0.5 * 130e9 * 2e-18);
}

/// Beyond the limit the liquid opens: its tension stays, and the energy is the work of that.
TEST(TaitEos, OpensAtItsTensionLimit) {
  Parameters parameters;
  parameters.set("stiffness", 1e6);
  parameters.set("exponent", 7.0);
  const TaitEos endless(parameters, 1000.0);
  parameters.set("tension_limit", 1e4);
  const TaitEos limited(parameters, 1000.0);
  EXPECT_EQ(limited.pressure(999.0, 0.0), endless.pressure(999.0, 0.0));  // -7 kPa
  EXPECT_EQ(limited.cold_energy(999.0), endless.cold_energy(999.0));
  EXPECT_EQ(limited.pressure(500.0, 0.0), -1e4);
  EXPECT_NEAR(endless.pressure(500.0, 0.0), -1e6 * (1.0 - std::pow(0.5, 7.0)), 1e-6);
  EXPECT_NEAR(limited.cold_energy(400.0) - limited.cold_energy(500.0), 1e4 * (1.0 / 400.0 - 1.0 / 500.0), 1e-12);
  const double opening = 1000.0 * std::pow(0.99, 1.0 / 7.0);
  EXPECT_NEAR(limited.cold_energy(opening * (1.0 - 1e-9)), endless.cold_energy(opening), 1e-7);
  EXPECT_EQ(limited.bulk_sound_speed_squared(500.0, 0.0), endless.bulk_sound_speed_squared(500.0, 0.0));
}

TEST(StiffenedGas, HasThePressureOfItsFormula) {
  Parameters parameters;
  parameters.set("sound_speed", 5380.0);
  parameters.set("gamma", 2.67);
  const StiffenedGas aluminium(parameters, 2700.0);
  EXPECT_NEAR(aluminium.pressure(2800.0, 1e5), 5380.0 * 5380.0 * 100.0 + 1.67 * 2800.0 * 1e5, 1e-3);
}

/// On the Hugoniot of particle speed u the shock runs at a0 + s u: pressure rho0 U u, energy u^2 / 2.
TEST(MieGrueneisen, HasItsHugoniot) {
  Parameters parameters;
  parameters.set("sound_speed", 5328.0);
  parameters.set("slope", 1.338);
  parameters.set("grueneisen", 2.0);
  const MieGrueneisen aluminium(parameters, 2785.0);
  for (const double u : {10.0, 400.0, 1500.0}) {
    const double shock_speed = 5328.0 + 1.338 * u, density = 2785.0 * shock_speed / (shock_speed - u);
    const double pressure = 2785.0 * shock_speed * u;
    EXPECT_NEAR(aluminium.pressure(density, 0.5 * u * u), pressure, 1e-9 * pressure);
  }
}

}  // namespace
}  // namespace anvil
