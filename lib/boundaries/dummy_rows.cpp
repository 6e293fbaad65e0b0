// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/boundaries/dummy_rows.hpp"

namespace anvil {

template <int D>
void DummyRows<D>::list(const NeighbourList<D>& neighbours, const Images<D>& images, std::size_t first_image,
                        std::size_t particles) {
  near_.clear();
  record_.clear();
  first_.assign(particles + 1, 0);
  for (std::size_t i = 0; i < particles; ++i) {
    for (std::int64_t k = neighbours.row_begin(i); k < neighbours.row_end(i); ++k) {
      const std::int32_t record = neighbours.neighbours()[k];
      auto source = static_cast<std::size_t>(record);
      if (source >= first_image) source = images.source(source - first_image);
      if (source < range_.first() || source >= range_.last() || !in_first_row(source)) continue;
      record_.push_back(record);
    }
    first_[i + 1] = static_cast<std::int64_t>(record_.size());
    if (first_[i + 1] > first_[i]) near_.push_back(static_cast<std::int32_t>(i));
  }
}

template <int D>
int DummyRows<D>::count_penetrations(VectorView<D> positions, VectorView<D> velocities, double time_step) const {
  int count = 0;
  for (const std::int32_t near : near_) {
    const auto i = static_cast<std::size_t>(near);
    const Vec<D> now = positions[i];
    if (surface_.crossed(now - time_step * velocities[i], now)) ++count;
  }
  return count;
}

template class DummyRows<1>;
template class DummyRows<2>;
template class DummyRows<3>;

}  // namespace anvil
