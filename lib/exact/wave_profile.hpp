// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "anvil/exact/wave_material.hpp"

namespace anvil {

/// Material between two fronts, in one state. Positions are initial ones, in m.
struct WaveZone {
  double begin;
  double end;
  std::size_t layer;
  double reference_density;  // kg/m3
  WaveState state;

  [[nodiscard]] double width() const { return end - begin; }
  [[nodiscard]] double middle() const { return 0.5 * (begin + end); }
  [[nodiscard]] double density() const { return reference_density / (1.0 + state.strain); }
};

/// The state of a plate at one time: uniform zones from left to right, without gaps.
struct WaveProfile {
  double time = 0.0;                // s
  double left_face_position = 0.0;  // m, now
  double smooth_jump = 0.0;         // Pa; jumps up to this stand for waves that change smoothly
  std::vector<WaveZone> zones;

  /// The zone that holds the initial position (m); positions outside the plate belong to the nearest zone, a
  /// position on a front to the zone on its right.
  [[nodiscard]] const WaveZone& zone_at(double position) const;
  /// The state there. Across a smooth jump it runs straight, over half of the narrower zone on either side: from middle
  /// to middle of the steps of a spreading wave, which halves the error of the stairs or better.
  [[nodiscard]] WaveState state_at(double position) const;
  /// Whether the wave changes smoothly between this zone and the next.
  [[nodiscard]] bool smooth_behind(std::size_t zone) const;
  /// How far from the end of the zone the straight run goes, m; zero where the jump is a front.
  [[nodiscard]] double smooth_reach(std::size_t zone) const;
  /// Where the material point that started at `position` is now, m.
  [[nodiscard]] double current_position(double position) const;

  // Per unit of area: kg/(m s) and J/m2 (kinetic and internal).
  [[nodiscard]] double momentum() const;
  [[nodiscard]] double energy() const;
};

/// Integral of |a - b| over the initial positions the two share, divided by the length: the mean difference of
/// the axial stress, Pa.
double mean_stress_difference(const WaveProfile& a, const WaveProfile& b);
/// The same between the states at a few thousand points, which sees smooth waves as such.
double sampled_stress_difference(const WaveProfile& a, const WaveProfile& b);
/// Mean of |stress|, Pa.
double mean_stress(const WaveProfile& profile);

}  // namespace anvil
