// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace anvil {

/// How the antidiffusive flux is kept from making new extrema.
enum class FluxLimiter {
  standard,      // of Boris and Book 1973: the differences on either side of the link
  six_arguments  // as Wang 2002 prints it: five differences, from two links before to two links behind
};

struct TransportCoefficients {
  double diffusion = 0.125;      // eta1
  double antidiffusion = 0.125;  // eta2
  FluxLimiter limiter = FluxLimiter::standard;
};

/// The flux-corrected transport of Boris and Book (1973) as a filter along a line of particles (Wang 2002): the values
/// after an update are spread by a diffusive flux that comes from the values before it, and gathered again by a flux
/// that may restore gradients but never make a new extremum.
class FluxCorrectedTransport {
 public:
  explicit FluxCorrectedTransport(const TransportCoefficients& coefficients) : coefficients_(coefficients) {}

  /// `before` and `after` in the order of the line; `after` is changed such that sum_k weight[k] after[k] stays what it
  /// was. link[k] carries the flux between k and k + 1: the smaller of their weights, or 0 where nothing may flow.
  void apply(std::span<const double> before, std::span<double> after, std::span<const double> weight,
             std::span<const double> link);
  /// What the last filter moved over each link, from k + 1 to k, in units of weight times value.
  [[nodiscard]] std::span<const double> moved() const { return moved_; }

 private:
  [[nodiscard]] double limited(double flux, std::size_t link_index, std::span<const double> link) const;

  TransportCoefficients coefficients_;
  std::vector<double> flux_;        // of the antidiffusion, per link
  std::vector<double> difference_;  // of the diffused values, per link
  std::vector<double> moved_;
};

}  // namespace anvil
