// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/exact/cylindrical_shell.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

constexpr double per_metre = 2.0 * std::numbers::pi;  // from one radian to the whole circle

// Linear and quadratic coefficients of the viscosity: it ends the ringing of a wave within some cells, and takes less
// than 1e-4 of the energy where the shell merely flows.
constexpr double linear_viscosity = 0.1, quadratic_viscosity = 1.5;
constexpr double courant = 0.25;

double half_square_difference(double outer, double inner) { return 0.5 * (outer - inner) * (outer + inner); }

}  // namespace

CylindricalShell::CylindricalShell(const ShellProblem& problem, std::size_t cells) : problem_(problem) {
  const double stiffness =
      std::visit([](const auto& law) { return law.bulk_stiffness(); }, problem.law) + 4.0 / 3.0 * problem.shear_modulus;
  sound_speed_ = std::sqrt(stiffness / problem.density);
  const double width = (problem.outer_radius - problem.inner_radius) / static_cast<double>(cells);
  for (std::size_t k = 0; k <= cells; ++k) {
    radius_.push_back(problem.inner_radius + width * static_cast<double>(k));
    velocity_.push_back(problem.speed * problem.inner_radius / radius_.back());
  }
  node_mass_.assign(cells + 1, 0.0);
  for (std::size_t k = 0; k < cells; ++k) {
    const double mass = problem.density * half_square_difference(radius_[k + 1], radius_[k]);
    cells_.push_back({mass, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
    node_mass_[k] += 0.5 * mass;
    node_mass_[k + 1] += 0.5 * mass;
  }
}

/// Radial rate from the faces' velocities; the hoop's is what the change of area leaves.
CylindricalShell::Rates CylindricalShell::rates(std::size_t cell) const {
  const double inner = radius_[cell], outer = radius_[cell + 1];
  const double radial = (velocity_[cell + 1] - velocity_[cell]) / (outer - inner);
  const double expansion =
      (outer * velocity_[cell + 1] - inner * velocity_[cell]) / half_square_difference(outer, inner);
  return {radial, expansion - radial};
}

void CylindricalShell::kick(double step) {
  std::vector<double> force(radius_.size(), 0.0);
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    const Cell& cell = cells_[k];
    const double pressure = cell.pressure + cell.viscous_pressure;
    const double radial = cell.radial_deviator - pressure, hoop = cell.hoop_deviator - pressure;
    const double area = half_square_difference(radius_[k + 1], radius_[k]), width = radius_[k + 1] - radius_[k];
    force[k] += area * (radial - hoop) / width + hoop * radius_[k];
    force[k + 1] -= area * (radial - hoop) / width + hoop * radius_[k + 1];
  }
  for (std::size_t k = 0; k < force.size(); ++k) velocity_[k] += step * force[k] / node_mass_[k];
}

void CylindricalShell::strain(std::size_t k, double step) {
  Cell& cell = cells_[k];
  const Rates rate = rates(k);
  const double mean = (rate.radial + rate.hoop) / 3.0, shear = problem_.shear_modulus;
  const double before_strain = cell.strain;
  const double area =
      half_square_difference(radius_[k + 1] + 0.5 * step * velocity_[k + 1], radius_[k] + 0.5 * step * velocity_[k]);
  cell.strain = problem_.density * area / cell.mass - 1.0;
  const double specific_volume = (1.0 + 0.5 * (cell.strain + before_strain)) / problem_.density;

  double radial = cell.radial_deviator + 2.0 * shear * step * (rate.radial - mean);
  double hoop = cell.hoop_deviator + 2.0 * shear * step * (rate.hoop - mean);
  const double equivalent = std::sqrt(3.0 * (radial * radial + radial * hoop + hoop * hoop));
  if (equivalent > problem_.yield_stress) {
    const double increment = (equivalent - problem_.yield_stress) / (3.0 * shear);
    cell.plastic_strain += increment;
    plastic_work_ += per_metre * cell.mass * specific_volume * increment * problem_.yield_stress;
    radial *= problem_.yield_stress / equivalent;
    hoop *= problem_.yield_stress / equivalent;
  }
  const double power = 0.5 * ((cell.radial_deviator + radial) * rate.radial + (cell.hoop_deviator + hoop) * rate.hoop);
  cell.radial_deviator = radial;
  cell.hoop_deviator = hoop;

  const double expansion = (cell.strain - before_strain) / problem_.density;  // of the specific volume
  const double closing = std::max(0.0, -(rate.radial + rate.hoop)) * (radius_[k + 1] - radius_[k]);
  cell.viscous_pressure = closing / specific_volume * (linear_viscosity * sound_speed_ + quadratic_viscosity * closing);
  const double energy =
      cell.energy + step * specific_volume * power - expansion * (0.5 * cell.pressure + cell.viscous_pressure);
  const auto [cold, thermal] = std::visit(
      [&](const auto& law) { return std::pair(law.cold(cell.strain), law.thermal(cell.strain)); }, problem_.law);
  // The energy loses half of the work of the pressure it leads to, in which both laws are linear.
  cell.pressure = (cold + thermal * energy) / (1.0 + 0.5 * thermal * expansion);
  cell.energy = energy - 0.5 * expansion * cell.pressure;
}

double CylindricalShell::longest_step() const {
  double width = radius_.back();
  for (std::size_t k = 0; k < cells_.size(); ++k) width = std::min(width, radius_[k + 1] - radius_[k]);
  if (!(width > 0.0 && radius_.front() > 0.0)) throw NumericalError("the shell closes at its axis");
  return courant * width / sound_speed_;
}

void CylindricalShell::advance_to(double time) {
  while (time_ < time) {
    const double step = std::min(longest_step(), time - time_);
    kick(0.5 * (last_step_ + step));
    // Rates and areas at the middle of the step are those of the positions there.
    for (std::size_t k = 0; k < radius_.size(); ++k) radius_[k] += 0.5 * step * velocity_[k];
    for (std::size_t k = 0; k < cells_.size(); ++k) strain(k, step);
    for (std::size_t k = 0; k < radius_.size(); ++k) radius_[k] += 0.5 * step * velocity_[k];
    last_step_ = step;
    time_ = step < time - time_ ? time_ + step : time;
  }
}

double CylindricalShell::kinetic_energy() const {
  double energy = 0.0;
  for (std::size_t k = 0; k < radius_.size(); ++k) energy += 0.5 * node_mass_[k] * velocity_[k] * velocity_[k];
  return per_metre * energy;
}

double CylindricalShell::internal_energy() const {
  double energy = 0.0;
  for (const Cell& cell : cells_) energy += cell.mass * cell.energy;
  return per_metre * energy;
}

}  // namespace anvil
