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

/// Images of particles (see Images) as the search meets them: image g is the record particles + 1 + g.
template <int D>
struct ImageSites {
  std::vector<Vec<D>> position;          // m
  std::vector<double> smoothing_length;  // m
};

/// For each particle all others and all images within reach (h_i + h_j)/2 + skin, so that the list stays complete while
/// the particles move by less than the skin. Found on a grid of cells into which the particles are sorted; every pair
/// stands twice, once for each partner. Rows are padded to the width of the vector lanes with the weightless record
/// behind the last particle. The order of a row follows from the positions alone: the same for any number of threads.
/// Images have no rows.
template <int D>
class NeighbourList {
 public:
  /// `reach` is the kernel's support in smoothing lengths; `skin` in m.
  void build(VectorView<D> positions, std::span<const double> smoothing_length, double reach, double skin,
             const PairLoops<D>& loops, const ImageSites<D>& images = {});

  /// Adds neighbours to the rows of their particles, which stay padded to `lanes`.
  void append(std::span<const ExtraNeighbour> extra, int lanes);

  /// Keeps the listed neighbours for which wanted(particle, record of the neighbour) holds, and pads the rows anew.
  template <class Wanted>
  void keep_only(Wanted&& wanted, int lanes);

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
  void sort_into_cells(VectorView<D> positions, std::span<const double> smoothing_length, const ImageSites<D>& images,
                       double cell_size);
  void collect_chunk(int chunk, std::int32_t particles, double reach, double skin, const PairLoops<D>& loops);
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
    std::vector<std::int32_t> particle, row_length, padded_length;
  };
  std::vector<Chunk> chunks_;
};

template <int D>
template <class Wanted>
void NeighbourList<D>::keep_only(Wanted&& wanted, int lanes) {
  const auto particles = static_cast<std::int32_t>(first_.size() - 1);
  std::vector<std::int32_t> kept;
  std::int64_t begin = 0;
  listed_ = 0;
  for (std::int32_t i = 0; i < particles; ++i) {
    const auto row = static_cast<std::size_t>(i);
    const std::size_t row_start = kept.size();
    for (std::int64_t k = begin; k < first_[row + 1]; ++k) {
      const std::int32_t j = neighbours_[static_cast<std::size_t>(k)];
      if (j != particles && wanted(i, j)) kept.push_back(j);
    }
    listed_ += static_cast<std::int64_t>(kept.size() - row_start);
    while ((kept.size() - row_start) % static_cast<std::size_t>(lanes) != 0) kept.push_back(particles);
    begin = first_[row + 1];
    first_[row + 1] = static_cast<std::int64_t>(kept.size());
  }
  neighbours_ = std::move(kept);
}

}  // namespace anvil
