// SPDX-License-Identifier: BSD-3-Clause
// Properties of every strength law of the table.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "anvil/core/error.hpp"
#include "anvil/materials/material_tables.hpp"
#include "anvil/materials/stress_update.hpp"
#include "unit/materials/specimens.hpp"
#include "unit/models_page.hpp"

namespace anvil {
namespace {

using testing_support::RandomTensors;
using testing_support::specimens;

double equivalent_stress(const Tensor& deviator) { return std::sqrt(equivalent_stress_squared(deviator)); }

template <class Law>
class EveryStrengthLaw : public testing::Test {
 protected:
  RandomTensors random_;

  /// A state on the way: some plastic strain, and a back stress where the law has one.
  StrengthHistory used_history(const Law& law) {
    StrengthHistory history;
    history.plastic_strain = Law::has_plastic_strain ? 0.1 : 0.0;
    if (law.has_back_stress()) history.back_stress = random_.deviator(50e6);
    return history;
  }
};
TYPED_TEST_SUITE(EveryStrengthLaw, testing_support::AlternativesOf<Strength>::Types);

// Laws that limit pressure yield when it is known: tested by themselves.
TYPED_TEST(EveryStrengthLaw, ReturnsToTheYieldSurface) {
  if constexpr (TypeParam::has_plastic_strain && !LimitsPressure<TypeParam>) {
    for (const TypeParam& law : specimens<TypeParam>()) {
      for (const double size : {1e9, 1e10, 1e15}) {  // the last a million times the yield stress: must stay finite
        StrengthHistory history = this->used_history(law);
        Tensor deviator = this->random_.deviator(size);
        law.return_to_yield(deviator, history);
        // Round-off of the trial stress remains in the relative stress and in the strain that hardens it.
        const double yield = law.yield_stress(history.plastic_strain);
        EXPECT_NEAR(equivalent_stress(deviator - history.back_stress), yield, 1e-12 * yield + 1e-14 * size) << size;
      }
    }
  }
}

TYPED_TEST(EveryStrengthLaw, LeavesStressBelowYieldAlone) {
  if constexpr (TypeParam::resists_shear) {
    for (const TypeParam& law : specimens<TypeParam>()) {
      StrengthHistory history = this->used_history(law);
      const StrengthHistory before = history;
      const Tensor trial = history.back_stress + this->random_.deviator(20e6);
      Tensor deviator = trial;
      const PlasticStep step = law.return_to_yield(deviator, history);
      EXPECT_EQ(deviator, trial);
      EXPECT_EQ(step.plastic_strain_increment, 0.0);
      EXPECT_EQ(step.plastic_work, 0.0);
      EXPECT_EQ(history.plastic_strain, before.plastic_strain);
      EXPECT_EQ(history.back_stress, before.back_stress);
    }
  }
}

TYPED_TEST(EveryStrengthLaw, IsTheSameInAnyFrame) {
  const double dt = 1e-7;
  for (const TypeParam& law : specimens<TypeParam>()) {
    for (int trial = 0; trial < 20; ++trial) {
      const Tensor rotation = this->random_.rotation();
      const auto turned = [&](const Tensor& tensor) -> Tensor { return rotation * tensor * rotation.transpose(); };
      StrengthHistory history = this->used_history(law);
      StrengthHistory turned_history = history;
      turned_history.back_stress = turned(history.back_stress);
      const Tensor gradient = this->random_.tensor(1e5);
      Tensor deviator = this->random_.deviator(200e6);
      Tensor turned_deviator = turned(deviator);

      const PlasticStep step = update_deviator(law, deviator, history, gradient, dt);
      const PlasticStep turned_step = update_deviator(law, turned_deviator, turned_history, turned(gradient), dt);

      const double round_off = 1e-13 * 1e9;  // of trial stresses up to 1 GPa
      EXPECT_LT((turned(deviator) - turned_deviator).norm(), round_off);
      EXPECT_LT((turned(history.back_stress) - turned_history.back_stress).norm(), round_off);
      EXPECT_NEAR(step.plastic_strain_increment, turned_step.plastic_strain_increment, 1e-14);
      EXPECT_NEAR(step.plastic_work, turned_step.plastic_work, 1e-14 * 1e9);
    }
  }
}

TYPED_TEST(EveryStrengthLaw, KeepsTheDeviatorSymmetricAndTraceless) {
  for (const TypeParam& law : specimens<TypeParam>()) {
    StrengthHistory history;
    Tensor deviator = Tensor::Zero();
    for (int step = 0; step < 200; ++step) {
      update_deviator(law, deviator, history, this->random_.tensor(1e5), 1e-7);
      EXPECT_EQ(deviator, deviator.transpose());
      EXPECT_NEAR(deviator.trace(), 0.0, 1e-13 * 1e9);  // round-off of 200 steps at up to 1 GPa
    }
  }
}

TYPED_TEST(EveryStrengthLaw, PlasticWorkAndStrainNeverDecrease) {
  for (const TypeParam& law : specimens<TypeParam>()) {
    StrengthHistory history;
    Tensor deviator = Tensor::Zero();
    double work = 0.0;
    double strain = 0.0;
    for (int step = 0; step < 500; ++step) {
      const PlasticStep done = update_deviator(law, deviator, history, this->random_.tensor(1e5), 1e-7);
      EXPECT_GE(done.plastic_work, 0.0);
      EXPECT_GE(done.plastic_strain_increment, 0.0);
      work += done.plastic_work;
      strain += done.plastic_strain_increment;
    }
    EXPECT_EQ(history.plastic_work, work);
    EXPECT_EQ(history.plastic_strain, strain);
    EXPECT_EQ(strain > 0.0, TypeParam::has_plastic_strain && !LimitsPressure<TypeParam>)
        << "the path has to reach yield";
  }
}

// Stress power is elastic energy gained plus plastic work, whatever the path.
TYPED_TEST(EveryStrengthLaw, StressPowerIsStoredOrDissipated) {
  if constexpr (TypeParam::resists_shear) {
    for (const TypeParam& law : specimens<TypeParam>()) {
      const double dt = 2e-10;
      StrengthHistory history;
      Tensor deviator = Tensor::Zero();
      Tensor gradient = this->random_.deviator(1e5);  // without spin: its rotation adds second-order terms
      double supplied = 0.0;
      for (int step = 0; step < 1000; ++step) {
        if (step % 250 == 0) gradient = -1.3 * gradient + this->random_.deviator(1e4);
        const Tensor before = deviator;
        update_deviator(law, deviator, history, gradient, dt);
        supplied += 0.5 * (before + deviator).cwiseProduct(gradient).sum() * dt;
      }
      const double stored = deviator.squaredNorm() / (4.0 * law.shear_modulus());
      EXPECT_GT(supplied, 0.0);
      // Each of the few steps that meet the yield surface or turn on it errs by (dt / duration)^2 = 1e-6 at most.
      EXPECT_NEAR(stored + history.plastic_work, supplied, 1e-3 * supplied);
    }
  }
}

TYPED_TEST(EveryStrengthLaw, IsMadeByItsName) {
  const EntryKind kind = TypeParam::kind();
  const Strength made = make_strength({std::string(kind.type), testing_support::specimen(kind, true)});
  ASSERT_TRUE(std::holds_alternative<TypeParam>(made));
  EXPECT_EQ(std::get<TypeParam>(made).shear_modulus(), specimens<TypeParam>()[1].shear_modulus());
}

TYPED_TEST(EveryStrengthLaw, HasARowInTheModelsPage) {
  EXPECT_TRUE(testing_support::models_page_has_row("Strength laws", TypeParam::kind().type));
}

TEST(StrengthTable, AnUnknownNameIsAnsweredWithTheKnownOnes) {
  try {
    make_strength({"mises", {}});
    FAIL() << "no error";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("'mises'"), std::string::npos) << message;
    for (const EntryKind& kind : strength_kinds()) EXPECT_NE(message.find(kind.type), std::string::npos) << message;
  }
}

TEST(StrengthTable, AMissingKeyIsAnInputError) { EXPECT_THROW(make_strength({"elastic", {}}), InputError); }

}  // namespace
}  // namespace anvil
