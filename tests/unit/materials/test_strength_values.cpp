// SPDX-License-Identifier: BSD-3-Clause
// Strength laws against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "anvil/materials/strength/elastic.hpp"
#include "anvil/materials/strength/j2.hpp"
#include "anvil/materials/strength/no_strength.hpp"
#include "anvil/materials/strength/voce.hpp"
#include "anvil/materials/stress_update.hpp"

namespace anvil {
namespace {

constexpr double shear_modulus = 43.33e9;
constexpr double yield_stress = 400e6;
constexpr double hardening = 2e9;

J2 make_j2(double yield, double isotropic_fraction) {
  Parameters parameters;
  parameters.set("shear_modulus", shear_modulus);
  parameters.set("yield_stress", yield);
  parameters.set("hardening_modulus", hardening);
  parameters.set("isotropic_fraction", isotropic_fraction);
  return J2(parameters);
}

/// One bar pulled without change of volume: the axial stress over axial strain, whose elastic slope is 3 G.
template <class Law>
class StretchedBar {
 public:
  explicit StretchedBar(const Law& law) : law_(law) {}

  /// Stretches by `strain` more, in `steps` steps; returns the axial stress in uniaxial stress, 3/2 s_xx.
  double stretch(double strain, int steps) {
    const Tensor gradient = strain / steps * Vec<3>(1.0, -0.5, -0.5).asDiagonal().toDenseMatrix();
    for (int step = 0; step < steps; ++step) update_deviator(law_, deviator_, history_, gradient, 1.0);
    return 1.5 * deviator_(0, 0);
  }
  [[nodiscard]] const StrengthHistory& history() const { return history_; }

 private:
  Law law_;
  Tensor deviator_ = Tensor::Zero();
  StrengthHistory history_;
};

// Linear hardening in proportional loading is followed exactly by any number of steps, also by a single one.
constexpr double round_off = 1e-12 * yield_stress;

constexpr double elastic_limit = yield_stress / (3.0 * shear_modulus);  // a strain
constexpr double plastic_slope =
    3.0 * shear_modulus * hardening / (3.0 * shear_modulus + hardening);  // stress over strain

TEST(J2, HardensAlongItsTangent) {
  for (const double beta : {0.0, 0.3, 1.0}) {
    for (const int steps : {1, 7, 100}) {
      StretchedBar bar(make_j2(yield_stress, beta));
      EXPECT_NEAR(bar.stretch(0.02, steps), yield_stress + plastic_slope * (0.02 - elastic_limit), round_off);
      const double plastic_strain = (3.0 * shear_modulus * 0.02 - yield_stress) / (3.0 * shear_modulus + hardening);
      EXPECT_NEAR(bar.history().plastic_strain, plastic_strain, 1e-14);
      // The area under the curve of stress over plastic strain.
      const double work = (yield_stress + 0.5 * hardening * plastic_strain) * plastic_strain;
      EXPECT_NEAR(bar.history().plastic_work, work, 1e-12 * work);
    }
  }
}

// Back from the peak, the elastic range is 2 sigma_0 plus the isotropic part of the hardening, twice.
TEST(J2, YieldsOnReversalAsItsHardeningSays) {
  for (const double beta : {0.0, 0.3, 1.0}) {
    for (const int steps : {1, 50}) {
      StretchedBar bar(make_j2(yield_stress, beta));
      const double peak = bar.stretch(0.02, steps);
      const double isotropic = beta * hardening * bar.history().plastic_strain;
      const double elastic_range = 2.0 * (yield_stress + isotropic);
      const double at_yield = bar.stretch(-0.999 * elastic_range / (3.0 * shear_modulus), steps);
      EXPECT_NEAR(at_yield, peak - 0.999 * elastic_range, round_off);
      const double end = bar.stretch(-0.02, steps);
      const double beyond = 0.02 - 0.001 * elastic_range / (3.0 * shear_modulus);
      EXPECT_NEAR(end, peak - elastic_range - plastic_slope * beyond, round_off) << "beta " << beta;
    }
  }
}

// A kinematic cycle closes; an isotropic one grows.
TEST(J2, KinematicCyclesRepeatThemselves) {
  StretchedBar kinematic(make_j2(yield_stress, 0.0));
  StretchedBar isotropic(make_j2(yield_stress, 1.0));
  const double first = kinematic.stretch(0.01, 10);
  const double first_isotropic = isotropic.stretch(0.01, 10);
  for (int cycle = 0; cycle < 5; ++cycle) {
    EXPECT_NEAR(kinematic.stretch(-0.02, 10), -first, 10.0 * round_off);
    EXPECT_NEAR(kinematic.stretch(0.02, 10), first, 10.0 * round_off);
    isotropic.stretch(-0.02, 10);
    EXPECT_GT(isotropic.stretch(0.02, 10), 1.1 * first_isotropic);
  }
}

TEST(J2, WithoutYieldStressFlowsAtOnce) {
  StretchedBar bar(make_j2(0.0, 1.0));
  EXPECT_EQ(bar.stretch(0.0, 1), 0.0);
  EXPECT_NEAR(bar.stretch(0.01, 3), plastic_slope * 0.01, round_off);
}

TEST(J2, WithInfiniteYieldStressIsElastic) {
  StretchedBar bar(make_j2(std::numeric_limits<double>::infinity(), 1.0));
  EXPECT_DOUBLE_EQ(bar.stretch(0.1, 1), 3.0 * shear_modulus * 0.1);
  EXPECT_EQ(bar.history().plastic_strain, 0.0);
}

TEST(J2, PassesOnWhatIsNotANumber) {
  Tensor deviator = Tensor::Constant(std::numeric_limits<double>::quiet_NaN());
  StrengthHistory history;
  make_j2(yield_stress, 1.0).return_to_yield(deviator, history);
  EXPECT_TRUE(std::isnan(deviator(0, 0))) << "the guards of a run must see it";
}

Voce make_voce(double saturation_stress, double saturation_rate) {
  Parameters parameters;
  parameters.set("shear_modulus", shear_modulus);
  parameters.set("yield_stress", yield_stress);
  parameters.set("saturation_stress", saturation_stress);
  parameters.set("saturation_rate", saturation_rate);
  return Voce(parameters);
}

// In proportional loading the stress at the end of any number of steps lies on the same curve: the axial strain is
// sigma / (3 G) + eps_p.
TEST(Voce, FollowsItsSaturationCurve) {
  for (const double rate : {0.0, 5.0, 1000.0}) {
    for (const int steps : {1, 20}) {
      StretchedBar bar(make_voce(300e6, rate));
      const double stress = bar.stretch(0.1, steps);
      const double plastic_strain = bar.history().plastic_strain;
      EXPECT_NEAR(stress, yield_stress + 300e6 * (1.0 - std::exp(-rate * plastic_strain)), round_off);
      EXPECT_NEAR(stress / (3.0 * shear_modulus) + plastic_strain, 0.1, 1e-14);
    }
  }
}

TEST(Voce, PlasticWorkIsTheAreaUnderTheCurve) {
  StretchedBar bar(make_voce(300e6, 10.0));
  bar.stretch(0.2, 1000);
  const double strain = bar.history().plastic_strain;
  const double area = (yield_stress + 300e6) * strain - 300e6 / 10.0 * (1.0 - std::exp(-10.0 * strain));
  EXPECT_NEAR(bar.history().plastic_work, area, 1e-6 * area);  // trapezoids of 2e-4: (c d)^2 / 12
}

TEST(Elastic, NeverYields) {
  Parameters parameters;
  parameters.set("shear_modulus", shear_modulus);
  StretchedBar bar{Elastic(parameters)};
  EXPECT_NEAR(bar.stretch(5.0, 10), 3.0 * shear_modulus * 5.0, 1e-14 * 15.0 * shear_modulus);
}

TEST(NoStrength, HasNoDeviator) {
  StretchedBar bar{NoStrength()};
  EXPECT_EQ(bar.stretch(1.0, 2), 0.0);
}

}  // namespace
}  // namespace anvil
