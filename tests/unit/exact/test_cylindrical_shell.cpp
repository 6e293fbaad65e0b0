// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/exact/cylindrical_shell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace anvil {
namespace {

constexpr double mm = 1e-3, us = 1e-6;

ShellProblem beryllium(double speed = -417.1) {
  return {1845.0, PressureMieGrueneisen{1845.0, 12870.0, 1.124, 2.0}, 151.9e9, 330e6, 80.0 * mm, 100.0 * mm, speed};
}

/// The figures of a converged calculation with these constants made elsewhere.
TEST(CylindricalShell, StopsWhereAnotherConvergedCalculationStops) {
  CylindricalShell shell(beryllium(), 100);
  EXPECT_NEAR(shell.kinetic_energy(), 1.4401e6, 50.0);
  const double start = shell.kinetic_energy();
  double smallest = 1.0, when = 0.0;
  for (int k = 1; k <= 1300; ++k) {
    shell.advance_to(0.1 * us * k);
    if (shell.inner_radius() >= smallest) continue;
    smallest = shell.inner_radius();
    when = shell.time();
  }
  EXPECT_NEAR(shell.inner_radius(), 49.956 * mm, 0.001 * mm);
  EXPECT_NEAR(shell.outer_radius(), 78.079 * mm, 0.001 * mm);
  EXPECT_NEAR(when, 129.10 * us, 0.1 * us);
  EXPECT_NEAR(shell.inner_plastic_strain(), 0.543, 0.003);
  EXPECT_NEAR(shell.outer_plastic_strain(), 0.285, 0.002);
  // 0.015 % rings in elastic waves; the viscosity of the mesh takes a few 1e-6.
  EXPECT_NEAR(shell.plastic_work() / start, 0.99985, 5e-5);
  EXPECT_NEAR((shell.kinetic_energy() + shell.internal_energy()) / start, 1.0, 1e-6);
}

/// Rigid plastic theory: the plastic work Y / sqrt(3) ln(...) of an incompressible ring takes the start energy.
TEST(CylindricalShell, StopsNearTheRadiiOfRigidPlasticTheory) {
  const double speeds[][2] = {{490.3, 40.0}, {454.7, 45.0}, {417.1, 50.0}, {334.1, 60.0}};
  for (const auto& [speed, stop] : speeds) {
    CylindricalShell shell(beryllium(-speed), 50);
    double smallest = 1.0;
    for (int k = 1; k <= 1500; ++k) {
      shell.advance_to(0.1 * us * k);
      smallest = std::min(smallest, shell.inner_radius());
    }
    // Elastic strains of a few 1e-4 are what theory leaves out.
    EXPECT_NEAR(smallest, stop * mm, 0.0015 * stop * mm);
  }
}

/// With the first order, which is the viscosity; the rest is smaller.
TEST(CylindricalShell, ConvergesWithTheCells) {
  std::vector<double> radii;
  for (const std::size_t cells : {10U, 20U, 40U, 80U}) {
    CylindricalShell shell(beryllium(), cells);
    shell.advance_to(100.0 * us);
    radii.push_back(shell.inner_radius());
  }
  for (std::size_t k = 2; k < radii.size(); ++k)
    EXPECT_GT(std::abs(radii[k - 1] - radii[k - 2]), 1.3 * std::abs(radii[k] - radii[k - 1]));
}

TEST(CylindricalShell, StaysAtRest) {
  CylindricalShell shell(beryllium(0.0), 20);
  shell.advance_to(10.0 * us);
  EXPECT_EQ(shell.inner_radius(), 80.0 * mm);
  EXPECT_EQ(shell.kinetic_energy(), 0.0);
}

}  // namespace
}  // namespace anvil
