// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "anvil/core/field_keys.hpp"
#include "anvil/solver/solver.hpp"

namespace anvil {
namespace {

template <int D>
std::string in_brackets(const Vec<D>& vector) {
  std::string text;
  for (int a = 0; a < D; ++a) text += fmt::format("{}{:.6g}", a == 0 ? "[" : ", ", vector[a]);
  return text + "]";
}

}  // namespace

/// Stops the run at the first particle, in the order of the tiles, that a pass reported; then at a step that has
/// collapsed.
template <int D>
void Solver<D>::check_reports() const {
  for (const auto& report : reports_) {
    if (report.inverted_edge_at >= 0)
      stop_at(report.inverted_edge_at,
              "an edge at it has turned inside out: the body is deformed further than its lattice can follow; "
              "stabiliser.erosion_stretch = 0.01 takes such points out");
    if (report.broken_particle < 0) continue;
    const auto i = static_cast<std::size_t>(report.broken_particle);
    if (!std::isfinite(position_[i].sum()) || !std::isfinite(velocity_[i].sum()))
      stop_at(report.broken_particle, "position or velocity is not a number");
    if (!(density_[i] > 0.0)) stop_at(report.broken_particle, "the density is not positive");
    if (!std::isfinite(pressure_[i])) stop_at(report.broken_particle, "the pressure is not a number");
    for (const auto& boundary : recipe_.boundaries)
      if (boundary->forbids(position_[i]))
        stop_at(report.broken_particle, "it is beyond the boundary '" + boundary->scene_name() + "'");
    stop_at(report.broken_particle, "smoothing length or wave speed is not positive");
  }
  const double least = scene_.time.minimum_step_fraction * first_step_limit_;
  if (!reports_.empty() && step_limit_ < least)
    stop_at(
        limiting_particle_,
        fmt::format("it asks for a time step of {:.3g} s, less than {:g} of the first one (time.minimum_step_fraction)",
                    step_limit_, scene_.time.minimum_step_fraction));
}

template <int D>
void Solver<D>::stop_at(std::int32_t particle, const std::string& reason) const {
  const auto i = static_cast<std::size_t>(particle);
  throw NumericalError(fmt::format(
      "step {} at {:.6g} s: particle {}: {}; position {} m, velocity {} m/s, density {:.6g} kg/m3, pressure {:.6g} Pa, "
      "smoothing length {:.6g} m",
      step_, time_, particle, reason, in_brackets<D>(position_[i]), in_brackets<D>(velocity_[i]), density_[i],
      pressure_[i], smoothing_length_[i]));
}

template void Solver<1>::check_reports() const;
template void Solver<2>::check_reports() const;
template void Solver<3>::check_reports() const;

}  // namespace anvil
