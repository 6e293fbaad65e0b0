// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "anvil/core/fields.hpp"
#include "anvil/pairs/pair_loops.hpp"

namespace anvil {

/// A neighbour that no search finds: an image of a particle, which stands in the records behind them.
struct ExtraNeighbour {
  std::int32_t particle;
  std::int32_t record;
};

/// For each particle all others within reach (h_i + h_j)/2 + skin, so that the list stays complete while the particles
/// move by less than the skin. Found on a grid of cells into which the particles are sorted; every pair stands twice,
/// once for each partner. Rows are padded to the width of the vector lanes with the weightless record behind the last
/// particle. The order of a row follows from the positions alone: the same for any number of threads.
template <int D>
class NeighbourList {
 public:
  /// `reach` is the kernel's support in smoothing lengths; `skin` in m.
  void build(VectorView<D> positions, std::span<const double> smoothing_length, double reach, double skin,
             const PairLoops<D>& loops);

  /// Adds neighbours to the rows of their particles, which stay padded to `lanes`.
  void append(std::span<const ExtraNeighbour> extra, int lanes);

  [[nodiscard]] const std::int64_t* first() const { return first_.data(); }
  [[nodiscard]] const std::int32_t* neighbours() const { return neighbours_.data(); }
  /// Listed neighbours of all particles, padding not counted.
  [[nodiscard]] std::int64_t listed() const { return listed_; }
  [[nodiscard]] std::int64_t row_begin(std::size_t i) const { return first_[i]; }
  [[nodiscard]] std::int64_t row_end(std::size_t i) const { return first_[i + 1]; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct CellOf {
    std::uint64_t cell;
    std::int32_t particle;
  };
  void sort_into_cells(VectorView<D> positions, std::span<const double> smoothing_length, double cell_size);
  void collect_chunk(int chunk, double reach, double skin, const PairLoops<D>& loops);
  void join_chunks(std::size_t particles);

  std::vector<std::int64_t> first_;
  std::vector<std::int32_t> neighbours_;
  std::int64_t listed_ = 0;

  // Kept between builds so that a rebuild allocates only when it needs more room.
  std::vector<CellOf> order_;
  std::vector<double> sorted_position_[D], sorted_smoothing_length_;
  std::vector<std::int32_t> sorted_particle_;
  struct Chunk {  // what one piece of work found: rows of consecutive sorted particles
    std::vector<std::int32_t> neighbours;
    std::vector<std::int32_t> row_length, padded_length;
  };
  std::vector<Chunk> chunks_;
};

}  // namespace anvil
