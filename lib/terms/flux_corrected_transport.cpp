// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/terms/flux_corrected_transport.hpp"

#include <algorithm>
#include <cmath>

namespace anvil {

/// `flux` is that of link k in units of the value. Links behind an end carry no difference and so set no limit: with a
/// limit of zero there, a wave would be diffused at a face and never gathered again.
double FluxCorrectedTransport::limited(double flux, std::size_t k, std::span<const double> link) const {
  const double sign = flux < 0.0 ? -1.0 : 1.0;
  double size = std::abs(flux);
  const auto limit_by = [&](std::size_t other) {
    if (other < link.size() && link[other] > 0.0) size = std::min(size, sign * difference_[other]);
  };
  limit_by(k - 1);  // wraps around to no link at all before the first
  limit_by(k + 1);
  if (coefficients_.limiter == FluxLimiter::six_arguments) {
    limit_by(k - 2);
    limit_by(k);
    limit_by(k + 2);
  }
  return sign * std::max(size, 0.0);
}

void FluxCorrectedTransport::apply(std::span<const double> before, std::span<double> after,
                                   std::span<const double> weight, std::span<const double> link) {
  const std::size_t links = link.size();
  flux_.resize(links);
  difference_.resize(links);
  moved_.assign(links, 0.0);
  for (std::size_t k = 0; k < links; ++k) flux_[k] = coefficients_.antidiffusion * (after[k + 1] - after[k]);
  const auto move_along = [&](std::size_t k, double moved) {  // from k + 1 to k
    moved_[k] += moved;
    after[k] += moved / weight[k];
    after[k + 1] -= moved / weight[k + 1];
  };
  for (std::size_t k = 0; k < links; ++k)
    move_along(k, coefficients_.diffusion * link[k] * (before[k + 1] - before[k]));
  for (std::size_t k = 0; k < links; ++k) difference_[k] = after[k + 1] - after[k];
  for (std::size_t k = 0; k < links; ++k)
    if (link[k] > 0.0) move_along(k, -link[k] * limited(flux_[k], k, link));
}

}  // namespace anvil
