// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace anvil {

/// How long a step each tile of a total Lagrangian scene takes, as the power of two of the shortest one: its level.
///
/// A stress acts by impulses of its own step, and particles drift between impulses: the impulse form of multiple time
/// steps (Tuckerman, Berne and Martyna 1992), with the parts by place as in asynchronous variational integrators (Lew,
/// Marsden, Ortiz and West 2003). Each impulse acts on both sides of its pairs, so momentum is kept to round-off.
struct LocalSteps {
  using Tiles = std::vector<std::int32_t>;

  std::vector<Tiles> near;  // by tile: those whose particles share a pair with its own, and itself
  Tiles all;
  // By tile. An edge needs its ends deformed as often as itself, and deformation needs its neighbours moved as often.
  std::vector<int> edge_level, strain_level, move_level;
  int highest = 0;                               // of all levels
  std::vector<double> particle_step, edge_step;  // s, by tile: the last step of the stresses of particles and edges
  // By level: where particles of shorter steps were (m) when a step of this level began.
  std::vector<std::vector<double>> start;

  /// Levels up to `greatest`, given the largest step each tile can take and the shortest one (s).
  void classify(const std::vector<double>& limit, double shortest, int greatest);
  [[nodiscard]] Tiles around(const Tiles& tiles) const;

 private:
  [[nodiscard]] std::vector<int> least_around(const std::vector<int>& level) const;
};

}  // namespace anvil
