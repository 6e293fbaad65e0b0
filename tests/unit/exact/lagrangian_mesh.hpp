// SPDX-License-Identifier: BSD-3-Clause
// A second way to the finite-strain answer: cells that move with the material and artificial viscosity (von Neumann and
// Richtmyer 1950), written for perfect plasticity and linear isotropic hardening. Shares nothing with lib/exact but
// loads.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "anvil/exact/load.hpp"

namespace anvil {

struct MeshMaterial {
  double density;
  double shear_modulus;
  double yield_stress;
  double hardening_modulus;
  double sound_speed;
  std::function<double(double)> pressure;  // of rho0 / rho - 1
};

class LagrangianMesh {
 public:
  LagrangianMesh(const MeshMaterial& material, double thickness, int cells, const PressureHistory& load)
      : material_(material),
        load_(load),
        width_(thickness / cells),
        velocity_(static_cast<std::size_t>(cells) + 1, 0.0),
        cells_(static_cast<std::size_t>(cells)) {}

  void advance_to(double time) {
    const double steps = std::ceil((time - time_) / (0.5 * width_ / material_.sound_speed));
    const double step = (time - time_) / steps;
    for (int i = 0; i < static_cast<int>(steps); ++i) advance(step);
  }

  [[nodiscard]] double stress(std::size_t cell) const { return cells_[cell].stress; }
  [[nodiscard]] double position(std::size_t cell) const { return (static_cast<double>(cell) + 0.5) * width_; }
  [[nodiscard]] std::size_t size() const { return cells_.size(); }

 private:
  struct Cell {
    double strain = 0.0;
    double deviator = 0.0;
    double plastic_strain = 0.0;
    double stress = 0.0;
    double viscous_stress = 0.0;
  };

  void advance(double step) {
    for (std::size_t node = 0; node < velocity_.size(); ++node) {
      const double left = node == 0 ? -load_.at(time_ + 0.5 * step) : total_stress(node - 1);
      const double right = node == cells_.size() ? 0.0 : total_stress(node);
      const double mass = material_.density * width_ * (node == 0 || node == cells_.size() ? 0.5 : 1.0);
      velocity_[node] += step * (right - left) / mass;
    }
    for (std::size_t i = 0; i < cells_.size(); ++i) strain_cell(cells_[i], velocity_[i + 1] - velocity_[i], step);
    time_ += step;
  }

  [[nodiscard]] double total_stress(std::size_t cell) const {
    return cells_[cell].stress + cells_[cell].viscous_stress;
  }

  void strain_cell(Cell& cell, double velocity_difference, double step) const {
    const double before = cell.strain;
    cell.strain += step * velocity_difference / width_;
    const double shear = material_.shear_modulus;
    cell.deviator += 4.0 / 3.0 * shear * std::log((1.0 + cell.strain) / (1.0 + before));
    const double excess =
        1.5 * std::abs(cell.deviator) - material_.yield_stress - material_.hardening_modulus * cell.plastic_strain;
    if (excess > 0.0) {
      const double increment = excess / (3.0 * shear + material_.hardening_modulus);
      cell.plastic_strain += increment;
      cell.deviator -= std::copysign(2.0 * shear * increment, cell.deviator);
    }
    cell.stress = cell.deviator - material_.pressure(cell.strain);
    const double closing = std::max(0.0, -velocity_difference);
    cell.viscous_stress = -material_.density * closing * (0.3 * material_.sound_speed + 2.0 * closing);
  }

  MeshMaterial material_;
  PressureHistory load_;
  double width_;
  double time_ = 0.0;
  std::vector<double> velocity_;
  std::vector<Cell> cells_;
};

}  // namespace anvil
