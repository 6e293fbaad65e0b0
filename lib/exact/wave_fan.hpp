// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "anvil/exact/wave_material.hpp"

namespace anvil {

/// How finely waves are resolved, Pa.
struct WaveResolution {
  double step = 0.0;      // largest jump of a front inside a spreading wave; such waves exist in finite strain only
  double smallest = 0.0;  // waves with a smaller jump of stress are not followed
};

enum class Direction { left = -1, right = 1 };

/// The waves that bring material from one stress to another: fronts with uniform states between them, fastest first.
struct WaveFan {
  struct Front {
    double speed;  // m/s, Lagrangian, always positive
    WaveState behind;
  };
  std::vector<Front> fronts;

  [[nodiscard]] const WaveState& end(const WaveState& ahead) const {
    return fronts.empty() ? ahead : fronts.back().behind;
  }
};

/// Fills `fan` with the waves that run in `direction` into `ahead` and leave `stress` behind them: an elastic wave, and
/// a plastic one when the yield limit is passed. A wave that shortens the material is one front (two moving fronts that
/// would catch each other are one); one that lengthens it spreads in finite strain and is cut into fronts of at most
/// `resolution.step`, each of which keeps mass, momentum and energy. Throws NumericalError when the law cannot reach
/// `stress`.
void fill_fan(const WaveMaterial& material, const WaveState& ahead, double stress, Direction direction,
              const WaveResolution& resolution, WaveFan& fan);

/// Both sides of a contact after its Riemann problem: equal stress and velocity.
struct ContactSolution {
  double stress = 0.0;
  WaveFan left_fan;   // runs left into the left state
  WaveFan right_fan;  // runs right into the right state
};

/// The Riemann problem between two states, the materials staying in touch (also in tension).
void solve_contact(const WaveMaterial& left_material, const WaveState& left, const WaveMaterial& right_material,
                   const WaveState& right, const WaveResolution& resolution, ContactSolution& solution);

/// Waves that run in `direction` from a face held at rest.
void fill_fan_from_rigid_face(const WaveMaterial& material, const WaveState& ahead, Direction direction,
                              const WaveResolution& resolution, WaveFan& fan);

}  // namespace anvil
