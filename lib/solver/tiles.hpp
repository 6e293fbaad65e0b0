// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/core/threads.hpp"
#include "anvil/solver/solver.hpp"

namespace anvil {

/// Particles per tile: the gradients of their pairs, some 70 of 24 bytes per particle, stay in the second-level cache.
/// Tiles of 32 and 128 took 1 to 4 % less time in two runs of benchmark_rod, no more than its noise.
inline constexpr std::int32_t tile_size = 64;

/// A tile in one dimension is done in a microsecond: only long lines of them are worth a second thread.
template <int D>
inline constexpr int least_shared_tiles = D == 1 ? 64 : 2;

/// work(tile, scratch of the thread, report of the tile) for all tiles, spread over the threads.
template <int D>
template <class Work>
void Solver<D>::for_each_tile(Work&& work) {
  for_each_parallel(
      static_cast<int>(tiles_.size()),
      [&](int tile, int thread) {
        const auto index = static_cast<std::size_t>(tile);
        work(tiles_[index], scratch_[static_cast<std::size_t>(thread)], reports_[index]);
      },
      least_shared_tiles<D>);
}

/// The same for some of them, by their numbers.
template <int D>
template <class Work>
void Solver<D>::for_each_tile_of(std::span<const std::int32_t> tiles, Work&& work) {
  for_each_parallel(
      static_cast<int>(tiles.size()),
      [&](int item, int thread) {
        const auto index = static_cast<std::size_t>(tiles[static_cast<std::size_t>(item)]);
        work(tiles_[index], scratch_[static_cast<std::size_t>(thread)], reports_[index]);
      },
      least_shared_tiles<D>);
}

}  // namespace anvil
