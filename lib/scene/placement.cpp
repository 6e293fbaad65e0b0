// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/placement.hpp"

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "anvil/core/error.hpp"
#include "anvil/scene/concentric.hpp"

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

template <int D>
PlacedBody<D> place_body(const BodyDescription& body, double spacing) {
  if constexpr (D == 2)
    if (body.lattice == "concentric") return place_concentric(body, spacing);
  const auto shape = make_shape<D>(body.shape);
  const auto cells = count_cells<D>(*shape, spacing);
  const Vec<D> centre = shape->centre();
  PlacedBody<D> placed;
  std::array<long long, D> index{};
  for (bool more = true; more;) {
    Vec<D> offset;
    // Measured from the middle in half spacings, so that mirrored cells have offsets of the same magnitude, bit by bit.
    for (std::size_t axis = 0; axis < D; ++axis)
      offset[static_cast<int>(axis)] = 0.5 * spacing * static_cast<double>(2 * index[axis] + 1 - cells[axis]);
    if (shape->contains(offset)) placed.positions.push_back(centre + shape->turned(offset));
    more = false;
    for (std::size_t axis = D; axis-- > 0 && !more;) {
      more = ++index[axis] < cells[axis];
      if (!more) index[axis] = 0;
    }
  }
  std::mt19937 random(1);  // whose numbers are the same everywhere
  for (std::size_t i = 0; body.jitter > 0.0 && i < placed.positions.size(); ++i)
    for (int axis = 0; axis < D; ++axis)
      placed.positions[i][axis] += body.jitter * spacing * (static_cast<double>(random()) * 0x1p-31 - 1.0);
  if (placed.positions.empty())
    throw InputError(fmt::format("body '{}' holds no particle at a spacing of {} m", body.name, spacing));
  placed.volumes.assign(placed.positions.size(), shape->volume() / static_cast<double>(placed.positions.size()));
  return placed;
}

template std::array<long long, 1> count_cells<1>(const Shape<1>&, double);
template std::array<long long, 2> count_cells<2>(const Shape<2>&, double);
template std::array<long long, 3> count_cells<3>(const Shape<3>&, double);
template PlacedBody<1> place_body<1>(const BodyDescription&, double);
template PlacedBody<2> place_body<2>(const BodyDescription&, double);
template PlacedBody<3> place_body<3>(const BodyDescription&, double);

}  // namespace anvil
