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

double mean_stress(const WaveProfile& profile) {
  double sum = 0.0;
  for (const WaveZone& zone : profile.zones) sum += std::abs(zone.state.stress) * zone.width();
  return sum / (profile.zones.back().end - profile.zones.front().begin);
}

}  // namespace anvil
