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
                             std::span<const double> axial_modulus, double support,
                             const TransportCoefficients& coefficients)
    : order_(std::move(order)),
      support_(support),
      transport_(coefficients),
      mass_(fields.scalar(field::mass)),
      density_(fields.scalar(field::density)),
      smoothing_length_(fields.scalar(field::smoothing_length)),
      pressure_((fields.require(field::pressure), fields.scalar(field::pressure))),
      position_(fields.scalar(field::position)),
      velocity_(fields.scalar(field::velocity)) {
  if (fields.has(field::deviatoric_stress)) deviator_ = fields.scalar(field::deviatoric_stress);
  std::vector<double> modulus_of(order_.size());
  for (std::size_t b = 0; b < ranges.size(); ++b)
    std::fill(modulus_of.begin() + ranges[b].begin, modulus_of.begin() + ranges[b].end, axial_modulus[b]);
  for (const std::int32_t i : order_) {
    modulus_.push_back(modulus_of[at(i)]);
    line_mass_.push_back(mass_[at(i)]);
  }
  for (auto* values : {&compliance_, &before_, &after_, &kept_back_}) values->resize(order_.size());
  gap_.resize(order_.empty() ? 0 : order_.size() - 1);
  link_.resize(gap_.size());
}

void LineTransport::find_gaps() {
  for (std::size_t k = 0; k < gap_.size(); ++k) {
    const std::size_t i = at(order_[k]), j = at(order_[k + 1]);
    const double reach = 0.5 * support_ * (smoothing_length_[i] + smoothing_length_[j]);
    gap_[k] = position_[j] - position_[i] >= reach;
  }
}

void LineTransport::filter(std::span<const double> weight) {
  for (std::size_t k = 0; k < link_.size(); ++k) link_[k] = gap_[k] ? 0.0 : std::min(weight[k], weight[k + 1]);
  transport_.apply(before_, after_, weight, link_);
}

void LineTransport::filter_velocity(std::span<const double> before) {
  find_gaps();
  for (std::size_t k = 0; k < order_.size(); ++k) {
    before_[k] = before[at(order_[k])];
    after_[k] = velocity_[at(order_[k])];
  }
  filter(line_mass_);
  for (std::size_t k = 0; k < order_.size(); ++k) velocity_[at(order_[k])] = after_[k];
}

void LineTransport::filter_strain(std::span<double> strain_rate, double time_step) {
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const std::size_t i = at(order_[k]);
    before_[k] = axial_stress(i);
    after_[k] = before_[k] + modulus_[k] * time_step * strain_rate[i];
    compliance_[k] = mass_[i] / (density_[i] * modulus_[k]);
  }
  filter(compliance_);
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const double strain = (after_[k] - before_[k]) / modulus_[k];
    kept_back_[k] = time_step * strain_rate[at(order_[k])] - strain;
    strain_rate[at(order_[k])] = strain / time_step;
  }
  move_with_faces();
}

/// The volume that came through a link is the way of its face; a particle stays in the middle of its own two.
void LineTransport::move_with_faces() {
  const auto moved = transport_.moved();
  for (std::size_t k = 0; k < moved.size(); ++k) {
    position_[at(order_[k])] += 0.5 * moved[k];
    position_[at(order_[k + 1])] += 0.5 * moved[k];
  }
}

double LineTransport::axial_stress(std::size_t i) const {
  return (deviator_.empty() ? 0.0 : deviator_[i]) - pressure_[i];
}

double LineTransport::strain_loss() const {
  double loss = 0.0;
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const std::size_t i = at(order_[k]);
    loss += mass_[i] / density_[i] * kept_back_[k] * 0.5 * (before_[k] + axial_stress(i));
  }
  return loss;
}

}  // namespace anvil
