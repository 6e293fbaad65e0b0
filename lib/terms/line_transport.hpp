// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "anvil/core/fields.hpp"
#include "anvil/core/particle_range.hpp"
#include "anvil/terms/flux_corrected_transport.hpp"

namespace anvil {

/// Flux-corrected transport of velocity and density along a line of particles. Velocity flows with the masses as
/// weights, which conserves momentum across materials; density as rho / rho0 with the volumes at rest, within one body:
/// it jumps where materials meet. Nothing flows through an end or a gap wider than the kernel's reach.
class LineTransport {
 public:
  /// `order`: the particles by position; `reference_density` of each body; `support` in smoothing lengths.
  LineTransport(FieldStore& fields, std::vector<std::int32_t> order, std::span<const ParticleRange> ranges,
                std::span<const double> reference_density, double support, const TransportCoefficients& coefficients);

  /// Filters the velocities (m/s) of a kick that started from `before`.
  void filter_velocity(std::span<const double> before);
  /// Keeps the densities of before an update.
  void remember_density();
  /// Filters the densities of the update since.
  void filter_density();

 private:
  void find_gaps();

  std::vector<std::int32_t> order_;
  double support_;
  FluxCorrectedTransport transport_;
  std::span<const double> position_, smoothing_length_;
  std::span<double> velocity_, density_;
  // All in the order of the line; links stand between a particle and the next.
  std::vector<double> mass_, mass_link_, volume_, volume_link_, reference_density_;
  std::vector<double> open_link_;  // mass_link_ or volume_link_ with the present gaps cut
  std::vector<bool> gap_;
  std::vector<double> before_, after_, density_before_;
};

/// The particles by position; those of one place by number.
std::vector<std::int32_t> line_order(std::span<const double> positions);

}  // namespace anvil
