// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/exact/wave_profile.hpp"

#include <algorithm>
#include <cmath>

namespace anvil {

const WaveZone& WaveProfile::zone_at(double position) const {
  const auto ends_before = [](double value, const WaveZone& zone) { return value < zone.end; };
  const auto found = std::upper_bound(zones.begin(), zones.end(), position, ends_before);
  return found == zones.end() ? zones.back() : *found;
}

bool WaveProfile::smooth_behind(std::size_t zone) const {
  if (smooth_jump == 0.0 || zone + 1 >= zones.size() || zones[zone].layer != zones[zone + 1].layer) return false;
  const WaveState &here = zones[zone].state, &there = zones[zone + 1].state;
  return std::abs(there.stress - here.stress) <= smooth_jump && std::abs(there.deviator - here.deviator) <= smooth_jump;
}

double WaveProfile::smooth_reach(std::size_t zone) const {
  return smooth_behind(zone) ? 0.5 * std::min(zones[zone].width(), zones[zone + 1].width()) : 0.0;
}

WaveState WaveProfile::state_at(double position) const {
  const WaveZone& zone = zone_at(position);
  const auto index = static_cast<std::size_t>(&zone - zones.data());
  const bool left = index > 0 && position < zone.middle();
  const std::size_t joint = left ? index - 1 : index;
  const double reach = smooth_reach(joint), distance = std::abs(position - zones[joint].end);
  if (distance >= reach) return zone.state;
  const WaveState& other = zones[left ? index - 1 : index + 1].state;
  const double part = 0.5 * (1.0 - distance / reach);
  WaveState state = zone.state;
  for (const auto member : {&WaveState::strain, &WaveState::velocity, &WaveState::energy, &WaveState::stress,
                            &WaveState::deviator, &WaveState::back_deviator, &WaveState::yield_deviator})
    state.*member += part * (other.*member - state.*member);
  return state;
}

double WaveProfile::current_position(double position) const {
  double current = left_face_position + std::min(0.0, position - zones.front().begin);
  for (const WaveZone& zone : zones) {
    if (position <= zone.begin) break;
    current += (std::min(position, zone.end) - zone.begin) * (1.0 + zone.state.strain);
  }
  return current + std::max(0.0, position - zones.back().end);
}

double WaveProfile::momentum() const {
  double sum = 0.0;
  for (const WaveZone& zone : zones) sum += zone.reference_density * zone.width() * zone.state.velocity;
  return sum;
}

double WaveProfile::energy() const {
  double sum = 0.0;
  for (const WaveZone& zone : zones) {
    const double velocity = zone.state.velocity;
    sum += zone.reference_density * zone.width() * (0.5 * velocity * velocity + zone.state.energy);
  }
  return sum;
}

double mean_stress_difference(const WaveProfile& a, const WaveProfile& b) {
  const double begin = std::max(a.zones.front().begin, b.zones.front().begin);
  const double end = std::min(a.zones.back().end, b.zones.back().end);
  double sum = 0.0;
  double position = begin;
  auto in_a = a.zones.begin();
  auto in_b = b.zones.begin();
  while (position < end) {
    while (in_a->end <= position) ++in_a;
    while (in_b->end <= position) ++in_b;
    const double next = std::min({in_a->end, in_b->end, end});
    sum += std::abs(in_a->state.stress - in_b->state.stress) * (next - position);
    position = next;
  }
  return sum / (end - begin);
}

double sampled_stress_difference(const WaveProfile& a, const WaveProfile& b) {
  constexpr int points = 4096;
  const double begin = std::max(a.zones.front().begin, b.zones.front().begin);
  const double end = std::min(a.zones.back().end, b.zones.back().end);
  double sum = 0.0;
  for (int i = 0; i < points; ++i) {
    const double position = begin + (end - begin) * (i + 0.5) / points;
    sum += std::abs(a.state_at(position).stress - b.state_at(position).stress);
  }
  return sum / points;
}

double mean_stress(const WaveProfile& profile) {
  double sum = 0.0;
  for (const WaveZone& zone : profile.zones) sum += std::abs(zone.state.stress) * zone.width();
  return sum / (profile.zones.back().end - profile.zones.front().begin);
}

}  // namespace anvil
