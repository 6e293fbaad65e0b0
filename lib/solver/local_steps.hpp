// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace anvil {

/// Which tiles of a total Lagrangian scene take short steps inside a long one, and what the stresses of each did last.
///
/// A stress acts by impulses of its own step, and particles drift between impulses: the impulse form of multiple time
/// steps (Tuckerman, Berne and Martyna 1992), with the parts by place as in asynchronous variational integrators (Lew,
/// Marsden, Ortiz and West 2003). Each impulse acts on both sides of its pairs, so momentum is kept to round-off.
struct LocalSteps {
  using Tiles = std::vector<std::int32_t>;

  std::vector<Tiles> near;  // by tile: those whose particles share a pair with its own, and itself
  Tiles all;
  // Around the squeezed tiles, each the neighbourhood of the one before: edges with short steps, particles whose
  // deformation is known after every short step, particles that move in short steps.
  Tiles edges, strained, moved;
  Tiles other_edges, not_strained;               // the rest
  std::vector<double> particle_step, edge_step;  // s, by tile: the last step of the stresses of particles and edges
  std::vector<double> start;                     // m, where the particles of `moved` were before the long step

  /// Sets the lists for long steps of `longest` (s), given the largest step each tile can take (s).
  void classify(const std::vector<double>& limit, double longest);
  /// How many of the shortest steps make a long one, so that the work per time is least: a power of two.
  [[nodiscard]] int best_ratio(const std::vector<double>& limit) const;

 private:
  [[nodiscard]] Tiles squeezed(const std::vector<double>& limit, double longest) const;
  [[nodiscard]] Tiles around(const Tiles& tiles) const;
};

}  // namespace anvil
