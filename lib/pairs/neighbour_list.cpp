// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/pairs/neighbour_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "anvil/core/threads.hpp"

namespace anvil {
namespace {

constexpr int chunk_size = 256;  // sorted particles per piece of work
// Coordinates of cells are clamped to this many per axis. Neighbouring cells stay neighbours under clamping, so a
// particle that has flown out of any bounds costs time, never correctness.
constexpr std::int64_t cells_per_axis = std::int64_t{1} << 20;

/// Cells along the first axis have consecutive numbers, so three neighbours in a row are one range.
template <int D>
std::uint64_t cell_number(const std::array<std::int64_t, D>& cell) {
  std::uint64_t number = 0;
  for (std::size_t a = D; a-- > 0;) number = number << 20 | static_cast<std::uint64_t>(cell[a]);
  return number;
}

template <int D>
std::array<std::int64_t, D> cell_coordinates(std::uint64_t number) {
  std::array<std::int64_t, D> cell{};
  for (auto& coordinate : cell) {
    coordinate = static_cast<std::int64_t>(number & static_cast<std::uint64_t>(cells_per_axis - 1));
    number >>= 20;
  }
  return cell;
}

}  // namespace

template <int D>
void NeighbourList<D>::build(VectorView<D> positions, std::span<const double> smoothing_length, double reach,
                             double skin, const PairLoops<D>& loops, const ImageSites<D>& images) {
  const std::size_t particles = smoothing_length.size();
  const double longest = particles == 0 ? 1.0 : *std::max_element(smoothing_length.begin(), smoothing_length.end());
  sort_into_cells(positions, smoothing_length, images, reach * longest + skin);
  chunks_.resize((order_.size() + chunk_size - 1) / chunk_size);
  for_each_parallel(static_cast<int>(chunks_.size()), [&](int chunk, int /*thread*/) {
    collect_chunk(chunk, static_cast<std::int32_t>(particles), reach, skin, loops);
  });
  join_chunks(particles);
}

template <int D>
void NeighbourList<D>::sort_into_cells(VectorView<D> positions, std::span<const double> smoothing_length,
                                       const ImageSites<D>& images, double cell_size) {
  const std::size_t particles = smoothing_length.size(), all = particles + images.position.size();
  Vec<D> lowest = Vec<D>::Constant(std::numeric_limits<double>::max());
  for (std::size_t i = 0; i < particles; ++i) lowest = lowest.cwiseMin(positions[i]);
  for (const Vec<D>& position : images.position) lowest = lowest.cwiseMin(position);
  const auto cell_of = [&](const auto& position) {
    std::array<std::int64_t, D> cell{};
    for (int a = 0; a < D; ++a) {
      const double coordinate = std::min((position[a] - lowest[a]) / cell_size, double(cells_per_axis - 1));
      cell[static_cast<std::size_t>(a)] = static_cast<std::int64_t>(coordinate);
    }
    return cell_number<D>(cell);
  };
  order_.resize(all);
  for (std::size_t i = 0; i < particles; ++i) order_[i] = {cell_of(positions[i]), static_cast<std::int32_t>(i)};
  for (std::size_t k = particles; k < all; ++k)
    order_[k] = {cell_of(images.position[k - particles]), static_cast<std::int32_t>(k + 1)};
  std::sort(order_.begin(), order_.end(), [](const CellOf& a, const CellOf& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.particle < b.particle;
  });
  constexpr std::size_t overrun = 8;  // the loops load whole vectors
  for (auto& coordinate : sorted_position_) coordinate.assign(all + overrun, 0.0);
  sorted_smoothing_length_.assign(all + overrun, 0.0);
  sorted_particle_.assign(all + overrun, 0);
  for (std::size_t k = 0; k < all; ++k) {
    const auto i = static_cast<std::size_t>(order_[k].particle);
    const bool image = i > particles;
    for (int a = 0; a < D; ++a)
      sorted_position_[a][k] = image ? images.position[i - particles - 1][a] : positions[i][a];
    sorted_smoothing_length_[k] = image ? images.smoothing_length[i - particles - 1] : smoothing_length[i];
    sorted_particle_[k] = order_[k].particle;
  }
}

template <int D>
void NeighbourList<D>::collect_chunk(int chunk, std::int32_t particles, double reach, double skin,
                                     const PairLoops<D>& loops) {
  Chunk& found = chunks_[static_cast<std::size_t>(chunk)];
  found.neighbours.clear();
  found.particle.clear();
  found.row_length.clear();
  found.padded_length.clear();
  Candidates<D> candidates{};
  for (std::size_t a = 0; a < D; ++a) candidates.position[a] = sorted_position_[a].data();
  candidates.smoothing_length = sorted_smoothing_length_.data();
  candidates.particle = sorted_particle_.data();

  const auto all = static_cast<std::int64_t>(order_.size());
  const std::int64_t begin = std::int64_t{chunk} * chunk_size, end = std::min(begin + chunk_size, all);
  const auto number_less = [](const CellOf& entry, std::uint64_t number) { return entry.cell < number; };
  constexpr int rows = D == 1 ? 1 : (D == 2 ? 3 : 9);
  std::array<std::array<std::int64_t, 2>, rows> ranges{};
  std::uint64_t cell_of_ranges = ~std::uint64_t{0};
  for (std::int64_t self = begin; self < end; ++self) {
    if (order_[static_cast<std::size_t>(self)].particle > particles) continue;  // an image
    const std::uint64_t number = order_[static_cast<std::size_t>(self)].cell;
    if (number != cell_of_ranges) {  // sorted: many particles share a cell and its surroundings
      cell_of_ranges = number;
      for (int row = 0; row < rows; ++row) {
        auto low = cell_coordinates<D>(number);
        if constexpr (D > 1) low[1] += row % 3 - 1;
        if constexpr (D > 2) low[2] += row / 3 - 1;
        auto& range = ranges[static_cast<std::size_t>(row)];
        range = {0, 0};
        if (std::any_of(low.begin(), low.end(), [](std::int64_t c) { return c < 0 || c >= cells_per_axis; })) continue;
        auto high = low;
        low[0] = std::max<std::int64_t>(low[0] - 1, 0);
        high[0] = std::min(high[0] + 1, cells_per_axis - 1);
        const auto from = std::lower_bound(order_.begin(), order_.end(), cell_number<D>(low), number_less);
        const auto to = std::lower_bound(from, order_.end(), cell_number<D>(high) + 1, number_less);
        range = {from - order_.begin(), to - order_.begin()};
      }
    }
    const std::size_t row_start = found.neighbours.size();
    std::size_t room = 8;
    for (const auto& range : ranges) room += static_cast<std::size_t>(range[1] - range[0]) + 8;
    found.neighbours.resize(row_start + room);
    std::int32_t* out = found.neighbours.data() + row_start;
    int length = 0;
    for (const auto& range : ranges)
      length += loops.collect(candidates, range[0], range[1], self, reach, skin, out + length);
    int padded = length;
    while (padded % loops.lanes != 0) out[padded++] = particles;
    found.neighbours.resize(row_start + static_cast<std::size_t>(padded));
    found.particle.push_back(order_[static_cast<std::size_t>(self)].particle);
    found.row_length.push_back(length);
    found.padded_length.push_back(padded);
  }
}

template <int D>
void NeighbourList<D>::join_chunks(std::size_t particles) {
  first_.assign(particles + 1, 0);
  listed_ = 0;
  for (const Chunk& chunk : chunks_) {
    for (std::size_t k = 0; k < chunk.particle.size(); ++k) {
      first_[static_cast<std::size_t>(chunk.particle[k]) + 1] = chunk.padded_length[k];
      listed_ += chunk.row_length[k];
    }
  }
  for (std::size_t i = 0; i < particles; ++i) first_[i + 1] += first_[i];
  neighbours_.resize(static_cast<std::size_t>(first_[particles]));
  for_each_parallel(static_cast<int>(chunks_.size()), [&](int c, int /*thread*/) {
    const Chunk& chunk = chunks_[static_cast<std::size_t>(c)];
    const std::int32_t* source = chunk.neighbours.data();
    for (std::size_t k = 0; k < chunk.padded_length.size(); ++k) {
      const auto row = static_cast<std::size_t>(chunk.particle[k]);
      std::copy_n(source, chunk.padded_length[k], neighbours_.data() + first_[row]);
      source += chunk.padded_length[k];
    }
  });
}

template <int D>
void NeighbourList<D>::append(std::span<const ExtraNeighbour> extra, int lanes) {
  const auto particles = static_cast<std::int32_t>(first_.size() - 1);
  std::vector<ExtraNeighbour> sorted(extra.begin(), extra.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.particle < b.particle; });
  std::vector<std::int32_t> lengthened;
  auto next = sorted.begin();
  for (std::int32_t i = 0; i < particles; ++i) {
    const auto row = static_cast<std::size_t>(i);
    const auto begin = neighbours_.begin() + first_[row], end = neighbours_.begin() + first_[row + 1];
    first_[row] = static_cast<std::int64_t>(lengthened.size());
    lengthened.insert(lengthened.end(), begin, std::find(begin, end, particles));
    for (; next != sorted.end() && next->particle == i; ++next) lengthened.push_back(next->record);
    while (lengthened.size() % static_cast<std::size_t>(lanes) != 0) lengthened.push_back(particles);
  }
  first_.back() = static_cast<std::int64_t>(lengthened.size());
  neighbours_ = std::move(lengthened);
}

template <int D>
std::size_t NeighbourList<D>::bytes() const {
  return first_.size() * sizeof(std::int64_t) + neighbours_.size() * sizeof(std::int32_t);
}

template class NeighbourList<1>;
template class NeighbourList<2>;
template class NeighbourList<3>;

}  // namespace anvil
