// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/terms/line_transport.hpp"

#include <algorithm>
#include <numeric>

#include "anvil/core/field_keys.hpp"

namespace anvil {
namespace {

std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }

}  // namespace

std::vector<std::int32_t> line_order(std::span<const double> positions) {
  std::vector<std::int32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::int32_t a, std::int32_t b) { return positions[at(a)] < positions[at(b)]; });
  return order;
}

LineTransport::LineTransport(FieldStore& fields, std::vector<std::int32_t> order, std::span<const ParticleRange> ranges,
                             std::span<const double> reference_density, double support,
                             const TransportCoefficients& coefficients)
    : order_(std::move(order)),
      support_(support),
      transport_(coefficients),
      position_(fields.scalar(field::position)),
      smoothing_length_(fields.scalar(field::smoothing_length)),
      velocity_(fields.scalar(field::velocity)),
      density_(fields.scalar(field::density)) {
  const auto masses = fields.scalar(field::mass);
  std::vector<std::size_t> body(order_.size());
  for (std::size_t b = 0; b < ranges.size(); ++b)
    for (std::size_t i = ranges[b].first(); i < ranges[b].last(); ++i) body[i] = b;
  for (const std::int32_t i : order_) {
    reference_density_.push_back(reference_density[body[at(i)]]);
    mass_.push_back(masses[at(i)]);
    volume_.push_back(mass_.back() / reference_density_.back());
  }
  for (std::size_t k = 0; k + 1 < order_.size(); ++k) {
    const bool same = body[at(order_[k])] == body[at(order_[k + 1])];
    mass_link_.push_back(std::min(mass_[k], mass_[k + 1]));
    volume_link_.push_back(same ? std::min(volume_[k], volume_[k + 1]) : 0.0);
  }
  gap_.resize(mass_link_.size());
  open_link_.resize(mass_link_.size());
  before_.resize(order_.size());
  after_.resize(order_.size());
  density_before_.resize(order_.size());
}

void LineTransport::find_gaps() {
  for (std::size_t k = 0; k < gap_.size(); ++k) {
    const std::size_t i = at(order_[k]), j = at(order_[k + 1]);
    const double reach = 0.5 * support_ * (smoothing_length_[i] + smoothing_length_[j]);
    gap_[k] = position_[j] - position_[i] >= reach;
  }
}

void LineTransport::filter_velocity(std::span<const double> before) {
  find_gaps();
  for (std::size_t k = 0; k < order_.size(); ++k) {
    before_[k] = before[at(order_[k])];
    after_[k] = velocity_[at(order_[k])];
  }
  for (std::size_t k = 0; k < gap_.size(); ++k) open_link_[k] = gap_[k] ? 0.0 : mass_link_[k];
  transport_.apply(before_, after_, mass_, open_link_);
  for (std::size_t k = 0; k < order_.size(); ++k) velocity_[at(order_[k])] = after_[k];
}

void LineTransport::remember_density() {
  for (std::size_t k = 0; k < order_.size(); ++k) density_before_[k] = density_[at(order_[k])] / reference_density_[k];
}

void LineTransport::filter_density() {
  for (std::size_t k = 0; k < order_.size(); ++k) after_[k] = density_[at(order_[k])] / reference_density_[k];
  for (std::size_t k = 0; k < gap_.size(); ++k) open_link_[k] = gap_[k] ? 0.0 : volume_link_[k];
  transport_.apply(density_before_, after_, volume_, open_link_);
  for (std::size_t k = 0; k < order_.size(); ++k) density_[at(order_[k])] = after_[k] * reference_density_[k];
}

}  // namespace anvil
