// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "anvil/materials/eos/linear.hpp"
#include "anvil/materials/strength/elastic.hpp"
#include "anvil/materials/strength/j2.hpp"
#include "anvil/materials/stress_update.hpp"
#include "unit/materials/specimens.hpp"

namespace anvil {
namespace {

using testing_support::RandomTensors;

// Steel of Wang 2002, table 1.
constexpr double density = 7800.0;
constexpr double bulk_modulus = 222.5e9;
constexpr double shear_modulus = 85.3e9;
constexpr double yield_stress = 1.0e9;

Elastic elastic_steel() {
  Parameters parameters;
  parameters.set("shear_modulus", shear_modulus);
  return Elastic(parameters);
}

J2 steel(double hardening, double isotropic_fraction) {
  Parameters parameters;
  parameters.set("shear_modulus", shear_modulus);
  parameters.set("yield_stress", yield_stress);
  parameters.set("hardening_modulus", hardening);
  parameters.set("isotropic_fraction", isotropic_fraction);
  return J2(parameters);
}

/// The largest difference to the exact elastic answer of the Jaumann rate in simple shear up to `shear`: s_xy = G
/// sin(shear), s_xx = -s_yy = G (1 - cos(shear)); in units of G.
double simple_shear_error(double shear, int steps) {
  const Elastic law = elastic_steel();
  Tensor gradient = Tensor::Zero();
  gradient(0, 1) = shear / steps;
  Tensor deviator = Tensor::Zero();
  StrengthHistory history;
  double error = 0.0;
  for (int step = 1; step <= steps; ++step) {
    update_deviator(law, deviator, history, gradient, 1.0);
    const double reached = shear * step / steps;
    Tensor exact = Tensor::Zero();
    exact(0, 0) = 1.0 - std::cos(reached);
    exact(1, 1) = -exact(0, 0);
    exact(0, 1) = exact(1, 0) = std::sin(reached);
    error = std::max(error, (deviator / shear_modulus - exact).cwiseAbs().maxCoeff());
  }
  return error;
}

TEST(StressUpdate, SimpleShearConvergesToTheSineOfTheJaumannRate) {
  const double coarse = simple_shear_error(6.0, 300);
  const double fine = simple_shear_error(6.0, 600);
  // Second order: the rotation of one step lags by w^3 / 12 for a turn w = 0.02, which over the path makes 6 * 0.02^2
  // / 12.
  EXPECT_LT(coarse, 3e-4);
  EXPECT_NEAR(coarse / fine, 4.0, 0.05);
}

TEST(StressUpdate, AgreesWithThePrintedRateToSecondOrder) {
  RandomTensors random;
  const Elastic law = elastic_steel();
  const Tensor start = random.deviator(1e9);
  const Tensor gradient = random.tensor(1.0);
  const Tensor stretching = 0.5 * (gradient + gradient.transpose());
  const Tensor spin = 0.5 * (gradient - gradient.transpose());
  const Tensor rate =
      2.0 * shear_modulus * (stretching - stretching.trace() / 3.0 * Tensor::Identity()) + spin * start - start * spin;
  const auto difference = [&](double dt) {
    Tensor deviator = start;
    StrengthHistory history;
    update_deviator(law, deviator, history, gradient, dt);
    return (deviator - start - dt * rate).norm();
  };
  // Halving the step quarters the difference; the next term is smaller by dt.
  EXPECT_NEAR(difference(2e-3) / difference(1e-3), 4.0, 0.02);
}

TEST(StressUpdate, RotationIsOrthogonalAndTurnsTheRightWay) {
  RandomTensors random;
  for (const double size : {1e-3, 1.0, 100.0}) {
    const Tensor rotation = spin_rotation(random.tensor(size), 1.0);
    EXPECT_LT((rotation * rotation.transpose() - Tensor::Identity()).norm(), 1e-14);  // round-off
    EXPECT_NEAR(rotation.determinant(), 1.0, 1e-14);
  }
  // v = w x r with w along z, by an angle whose half has the tangent w dt / 2.
  Tensor gradient = Tensor::Zero();
  gradient(0, 1) = -0.4;
  gradient(1, 0) = 0.4;
  const Tensor expected = Eigen::AngleAxisd(2.0 * std::atan(0.2), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  EXPECT_LT((spin_rotation(gradient, 1.0) - expected).norm(), 1e-15 * 10.0);
}

TEST(StressUpdate, StressAndBackStressTurnWithTheMaterial) {
  RandomTensors random;
  const J2 law = steel(1e9, 0.0);
  const Tensor start = random.deviator(0.4e9);
  Tensor deviator = start;
  StrengthHistory history;
  history.back_stress = random.deviator(0.1e9);
  const Tensor back_stress = history.back_stress;
  Tensor gradient = Tensor::Zero();  // about x, by 0.3 in each of 5 steps
  gradient(2, 1) = 2.0 * std::tan(0.15);
  gradient(1, 2) = -gradient(2, 1);
  for (int step = 0; step < 5; ++step) update_deviator(law, deviator, history, gradient, 1.0);
  const Tensor turn = Eigen::AngleAxisd(1.5, Eigen::Vector3d::UnitX()).toRotationMatrix();
  EXPECT_LT((deviator - turn * start * turn.transpose()).norm(), 1e-14 * start.norm());  // round-off of five steps
  EXPECT_LT((history.back_stress - turn * back_stress * turn.transpose()).norm(), 1e-14 * back_stress.norm());
}

TEST(StressUpdate, AHundredTurnsLeaveTheStressAsItWas) {
  RandomTensors random;
  for (const int steps_per_turn : {40, 1000}) {
    const J2 law = steel(1e9, 0.0);
    const Tensor start = random.deviator(0.4e9);
    Tensor deviator = start;
    StrengthHistory history;
    history.back_stress = random.deviator(0.1e9);
    const Tensor back_stress = history.back_stress;
    // The speed at which the angle of one step is a whole part of a turn, about a tilted axis.
    const double speed = 2.0 * std::tan(std::numbers::pi / steps_per_turn);
    const Vec<3> axis = speed * Vec<3>(1.0, 2.0, -2.0) / 3.0;
    Tensor gradient;
    gradient << 0.0, -axis(2), axis(1), axis(2), 0.0, -axis(0), -axis(1), axis(0), 0.0;
    for (int step = 0; step < 100 * steps_per_turn; ++step) update_deviator(law, deviator, history, gradient, 1.0);
    // Round-off of 1e5 steps adds up at worst linearly: 1e5 * 1e-16.
    EXPECT_LT((deviator - start).norm(), 1e-10 * start.norm());
    EXPECT_LT((history.back_stress - back_stress).norm(), 1e-10 * back_stress.norm());
    EXPECT_EQ(history.plastic_strain, 0.0);
  }
}

// Uniaxial strain of steel: the Hugoniot elastic limit, and the plastic branch behind it.
TEST(StressUpdate, UniaxialStrainYieldsAtTheHugoniotElasticLimit) {
  const J2 law = steel(0.0, 1.0);
  Parameters volume;
  volume.set("bulk_modulus", bulk_modulus);
  const LinearEos eos(volume, density);
  const double strain_step = 1e-6;
  Tensor gradient = Tensor::Zero();
  gradient(0, 0) = -strain_step;
  Tensor deviator = Tensor::Zero();
  StrengthHistory history;
  int steps = 0;
  while (history.plastic_strain == 0.0 && steps < 100000) {
    update_deviator(law, deviator, history, gradient, 1.0);
    ++steps;
  }
  const double limit_strain = yield_stress / (2.0 * shear_modulus);
  EXPECT_NEAR(steps * strain_step, limit_strain, strain_step);
  const double pressure = eos.pressure(density * std::exp(steps * strain_step), 0.0);
  const double small_strain_limit = (bulk_modulus + 4.0 / 3.0 * shear_modulus) * limit_strain;
  EXPECT_NEAR(small_strain_limit, 1.9709e9, 1e5);  // the value in Wang 2002's table, corrected
  // Logarithmic against small strain: half the strain of 0.0059, relative, on the pressure.
  EXPECT_NEAR(pressure - deviator(0, 0), small_strain_limit, 0.004 * small_strain_limit);

  const double end_strain = 0.05;
  for (; steps < 50000; ++steps) update_deviator(law, deviator, history, gradient, 1.0);
  EXPECT_NEAR(deviator(0, 0), -2.0 / 3.0 * yield_stress, 1e-12 * yield_stress);
  EXPECT_NEAR(deviator(1, 1), 1.0 / 3.0 * yield_stress, 1e-12 * yield_stress);
  EXPECT_NEAR(deviator(2, 2), 1.0 / 3.0 * yield_stress, 1e-12 * yield_stress);
  // All shear strain beyond the limit is plastic: 2/3 of the axial strain there. Round-off of 5e4 steps.
  const double plastic_strain = 2.0 / 3.0 * (end_strain - limit_strain);
  EXPECT_NEAR(history.plastic_strain, plastic_strain, 1e-10 * plastic_strain);
  EXPECT_NEAR(history.plastic_work, yield_stress * plastic_strain, 1e-10 * yield_stress * plastic_strain);
}

// Without strain out of the plane there is still stress: minus the mean strain of the other two, here 0.5e-3.
TEST(StressUpdate, PlaneStrainKeepsTheStressOutOfPlane) {
  Tensor gradient = Tensor::Zero();
  gradient(0, 0) = 2e-3;
  gradient(1, 1) = -0.5e-3;
  gradient(0, 1) = 1e-3;
  gradient(1, 0) = 1e-3;
  Tensor deviator = Tensor::Zero();
  StrengthHistory history;
  update_deviator(elastic_steel(), deviator, history, gradient, 1.0);
  EXPECT_DOUBLE_EQ(deviator(2, 2), -2.0 * shear_modulus * 0.5e-3);
  EXPECT_EQ(deviator(0, 2), 0.0);
  EXPECT_EQ(deviator(1, 2), 0.0);

  // After yield it is scaled like every other component.
  const Tensor elastic = deviator * 10.0;
  deviator.setZero();
  update_deviator(steel(0.0, 1.0), deviator, history, 10.0 * gradient, 1.0);
  const double scale = yield_stress / std::sqrt(equivalent_stress_squared(elastic));
  EXPECT_LT(scale, 1.0);
  EXPECT_NEAR(deviator(2, 2), scale * elastic(2, 2), 1e-12 * yield_stress);
}

}  // namespace
}  // namespace anvil
