// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/placement.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "anvil/core/error.hpp"

namespace anvil {

template <int D>
std::array<long long, D> count_cells(const Shape<D>& shape, double spacing) {
  const Vec<D> size = shape.size();
  std::array<long long, D> cells{};
  double all = 1.0;  // in doubles, which do not overflow
  for (int axis = 0; axis < D; ++axis) all *= std::max(1.0, std::round(size[axis] / spacing));
  if (!(all <= most_particles))
    throw InputError(
        fmt::format("a spacing of {} m fills the body with {:.3g} cells, and at most {:.3g} are possible; "
                    "choose a larger discretisation.spacing",
                    spacing, all, most_particles));
  for (int axis = 0; axis < D; ++axis)
    cells[static_cast<std::size_t>(axis)] = std::max(1LL, std::llround(size[axis] / spacing));
  return cells;
}

namespace {

/// Calls visit(index) for every index below `count` along each axis, the last axis fastest.
template <int D, class Visit>
void for_each_index(const std::array<long long, D>& count, Visit&& visit) {
  std::array<long long, D> index{};
  for (bool more = true; more;) {
    visit(index);
    more = false;
    for (std::size_t axis = D; axis-- > 0 && !more;) {
      more = ++index[axis] < count[axis];
      if (!more) index[axis] = 0;
    }
  }
}

/// From the middle of the lattice, measured in half spacings, so that mirrored places have offsets of the same
/// magnitude, bit by bit. `halves` is twice the index, from the first face.
template <int D>
Vec<D> lattice_offset(const std::array<long long, D>& halves, const std::array<long long, D>& cells, double spacing) {
  Vec<D> offset;
  for (std::size_t axis = 0; axis < D; ++axis)
    offset[static_cast<int>(axis)] = 0.5 * spacing * static_cast<double>(halves[axis] - cells[axis]);
  return offset;
}

/// One particle in the middle of each cell of the shape.
template <int D>
PlacedBody<D> fill_cells(const Shape<D>& shape, const std::array<long long, D>& cells, double spacing) {
  PlacedBody<D> placed;
  for_each_index<D>(cells, [&](std::array<long long, D> index) {
    for (auto& along : index) along = 2 * along + 1;
    const Vec<D> offset = lattice_offset<D>(index, cells, spacing);
    if (shape.contains(offset)) placed.positions.push_back(offset);
  });
  placed.volumes.assign(placed.positions.size(), 1.0);
  return placed;
}

/// One particle on each corner of a cell of the shape, with an equal share of every cell that it belongs to.
template <int D>
PlacedBody<D> share_cells(const Shape<D>& shape, const std::array<long long, D>& cells, double spacing) {
  auto corners = cells;
  for (auto& count : corners) ++count;
  const auto number = [&](const std::array<long long, D>& index) {
    std::size_t flat = 0;
    for (std::size_t axis = 0; axis < D; ++axis)
      flat = flat * static_cast<std::size_t>(corners[axis]) + static_cast<std::size_t>(index[axis]);
    return flat;
  };
  std::size_t all = 1;
  for (const long long count : corners) all *= static_cast<std::size_t>(count);
  std::vector<double> share(all, 0.0);
  for_each_index<D>(cells, [&](const std::array<long long, D>& cell) {
    auto middle = cell;
    for (auto& along : middle) along = 2 * along + 1;
    if (!shape.contains(lattice_offset<D>(middle, cells, spacing))) return;
    for (unsigned corner = 0; corner < 1U << D; ++corner) {
      auto index = cell;
      for (std::size_t axis = 0; axis < D; ++axis) index[axis] += corner >> axis & 1U;
      share[number(index)] += 1.0 / (1U << D);
    }
  });
  PlacedBody<D> placed;
  for_each_index<D>(corners, [&](std::array<long long, D> index) {
    const double volume = share[number(index)];
    if (volume == 0.0) return;
    for (auto& along : index) along *= 2;
    placed.positions.push_back(lattice_offset<D>(index, cells, spacing));
    placed.volumes.push_back(volume);
  });
  return placed;
}

}  // namespace

template <int D>
PlacedBody<D> place_body(const BodyDescription& body, double spacing) {
  const auto shape = make_shape<D>(body.shape);
  const auto cells = count_cells<D>(*shape, spacing);
  PlacedBody<D> placed = body.lattice == "face_lattice" ? share_cells<D>(*shape, cells, spacing)
                                                        : fill_cells<D>(*shape, cells, spacing);
  if (placed.positions.empty())
    throw InputError(fmt::format("body '{}' holds no particle at a spacing of {} m", body.name, spacing));
  const double scale = shape->volume() / std::accumulate(placed.volumes.begin(), placed.volumes.end(), 0.0);
  for (double& volume : placed.volumes) volume *= scale;
  for (Vec<D>& position : placed.positions) position += shape->centre();
  return placed;
}

template std::array<long long, 1> count_cells<1>(const Shape<1>&, double);
template std::array<long long, 2> count_cells<2>(const Shape<2>&, double);
template std::array<long long, 3> count_cells<3>(const Shape<3>&, double);
template PlacedBody<1> place_body<1>(const BodyDescription&, double);
template PlacedBody<2> place_body<2>(const BodyDescription&, double);
template PlacedBody<3> place_body<3>(const BodyDescription&, double);

}  // namespace anvil
