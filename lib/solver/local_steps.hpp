// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory_resource>
#include <vector>

namespace anvil {

/// How long a step each tile of a total Lagrangian scene takes, as the power of two of the shortest one: its level.
///
/// A stress acts by impulses of its own step, and particles drift between impulses: the impulse form of multiple time
/// steps (Tuckerman, Berne and Martyna 1992), with the parts by place as in asynchronous variational integrators (Lew,
/// Marsden, Ortiz and West 2003). Each impulse acts on both sides of its pairs, so momentum is kept to round-off.
struct LocalSteps {
  using Tiles = std::pmr::vector<std::int32_t>;

  // Lists of tiles come and go within a step: their memory is kept, so that a step allocates none.
  mutable std::pmr::unsynchronized_pool_resource memory{
      {.max_blocks_per_chunk = 0, .largest_required_pool_block = 1 << 20}};
  std::vector<Tiles> near;  // by tile: those whose particles share a pair with its own, and itself
  Tiles all;
  // By tile. An edge needs its ends deformed as often as itself, and deformation needs its neighbours moved as often.
  std::vector<int> edge_level, strain_level, move_level;
  int highest = 0;                               // of all levels
  std::vector<double> particle_step, edge_step;  // s, by tile: the last step of the stresses of particles and edges
  // By level: where particles of shorter steps were (m) when a step of this level began.
  std::vector<std::vector<double>> start;

  std::vector<double> limit;  // s, by tile: the largest step it can take

  /// Levels up to `greatest`, given the limits and the shortest of them (s).
  void classify(double shortest, int greatest);
  [[nodiscard]] Tiles around(const Tiles& tiles) const;
  /// Those for which chosen(tile).
  template <class Chosen>
  [[nodiscard]] Tiles where(Chosen&& chosen) const {
    return those_of(all, chosen);
  }
  template <class Chosen>
  [[nodiscard]] Tiles those_of(const Tiles& tiles, Chosen&& chosen) const {
    Tiles found(&memory);
    for (const std::int32_t tile : tiles)
      if (chosen(static_cast<std::size_t>(tile))) found.push_back(tile);
    return found;
  }

 private:
  void least_around(const std::vector<int>& level, std::vector<int>& least) const;

  std::vector<int> allowed_;  // by tile: the level of its own limit
};

}  // namespace anvil
