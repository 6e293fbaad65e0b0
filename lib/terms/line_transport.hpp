// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "anvil/core/fields.hpp"
#include "anvil/core/particle_range.hpp"
#include "anvil/terms/flux_corrected_transport.hpp"

namespace anvil {

/// Flux-corrected transport of velocity and axial stress along a line of particles.
///
/// Velocity flows with the masses as weights, which conserves momentum across materials. Stress flows with volume over
/// axial modulus as weights: what goes through a link is then a volume, the way that the face between two particles
/// moves. So the length of the line is conserved, densities and positions stay together, and the strain rates that are
/// left drive density, stress and smoothing length alike. In elastic material this is the same as a filter on rho /
/// rho0; where plastic strain varies from particle to particle the stress of a body at rest is smooth and the density
/// is not, and a filter on density would pull it out of balance for ever. Stress is continuous where materials meet.
/// Nothing flows through an end or a gap wider than the kernel's reach.
class LineTransport {
 public:
  /// `order`: the particles by position; `axial_modulus`, Pa, of each body; `support` in smoothing lengths.
  LineTransport(FieldStore& fields, std::vector<std::int32_t> order, std::span<const ParticleRange> ranges,
                std::span<const double> axial_modulus, double support, const TransportCoefficients& coefficients);

  /// Filters the velocities (m/s) of a kick that started from `before`.
  void filter_velocity(std::span<const double> before);
  /// Filters the stresses that the axial strain rates (1/s, by particle) would lead to in a step of time_step (s),
  /// moves the particles with their faces and leaves in `strain_rate` what the filter lets through.
  void filter_strain(std::span<double> strain_rate, double time_step);
  /// J that the filter took in the last filter_strain: the work of the stresses on the strain it kept back. To be asked
  /// once the stresses have followed.
  [[nodiscard]] double strain_loss() const;

 private:
  void find_gaps();
  void filter(std::span<const double> weight);
  void move_with_faces();
  [[nodiscard]] double axial_stress(std::size_t i) const;

  std::vector<std::int32_t> order_;
  double support_;
  FluxCorrectedTransport transport_;
  std::span<const double> mass_, density_, smoothing_length_;
  std::span<const double> pressure_, deviator_;  // no deviator in a fluid
  std::span<double> position_, velocity_;
  // In the order of the line; links stand between a particle and the next.
  std::vector<double> modulus_, line_mass_, compliance_;  // Pa, kg, m/Pa
  std::vector<double> link_;
  std::vector<bool> gap_;
  std::vector<double> before_, after_;
  std::vector<double> kept_back_;  // strain
};

/// The particles by position; those of one place by number.
std::vector<std::int32_t> line_order(std::span<const double> positions);

}  // namespace anvil
