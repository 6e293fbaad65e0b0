// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "anvil/exact/pressure_law.hpp"

namespace anvil {

/// A long circular shell in plane strain, free inside and outside, with the velocity u = speed * inner_radius / r along
/// the radius at the start.
struct ShellProblem {
  double density;  // kg/m3
  PressureLaw law;
  double shear_modulus;  // Pa
  double yield_stress;   // Pa; perfectly plastic
  double inner_radius;   // m
  double outer_radius;   // m
  double speed;          // m/s, outward
};

/// The shell in one dimension: cells that move with the material, pressure and radial stress in the cells, velocity at
/// their faces (Wilkins 1964), with a viscosity against waves that no mesh resolves. The forces are the derivatives of
/// the work of the stresses, so that energy is kept up to the time step. The answer for a number of cells and for twice
/// as many says how good it is: of the beryllium shell's radii 1e-7 m with 200 cells.
class CylindricalShell {
 public:
  CylindricalShell(const ShellProblem& problem, std::size_t cells);

  /// `time` in s, not before the time reached already. Throws NumericalError when the shell closes.
  void advance_to(double time);

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] double inner_radius() const { return radius_.front(); }
  [[nodiscard]] double outer_radius() const { return radius_.back(); }
  [[nodiscard]] double inner_plastic_strain() const { return cells_.front().plastic_strain; }
  [[nodiscard]] double outer_plastic_strain() const { return cells_.back().plastic_strain; }
  // J per metre of the cylinder.
  [[nodiscard]] double kinetic_energy() const;
  [[nodiscard]] double internal_energy() const;
  [[nodiscard]] double plastic_work() const { return plastic_work_; }

 private:
  struct Cell {
    double mass;                                                        // kg per metre and radian
    double strain;                                                      // rho0 / rho - 1
    double energy;                                                      // J/kg
    double radial_deviator, hoop_deviator, viscous_pressure, pressure;  // Pa
    double plastic_strain;
  };
  struct Rates {
    double radial, hoop;  // 1/s
  };
  [[nodiscard]] Rates rates(std::size_t cell) const;
  void kick(double step);
  void strain(std::size_t cell, double step);
  [[nodiscard]] double longest_step() const;

  ShellProblem problem_;
  double sound_speed_;
  double time_ = 0.0, last_step_ = 0.0;
  double plastic_work_ = 0.0;
  std::vector<double> radius_, velocity_, node_mass_;  // velocities at half steps
  std::vector<Cell> cells_;
};

}  // namespace anvil
