// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/cut.hpp"

#include <cmath>
#include <numbers>

#include "anvil/core/error.hpp"
#include "anvil/scene/ring.hpp"

namespace anvil {

template <int D>
std::optional<Cut<D>> cut_of(const TypedEntry& shape) {
  const Parameters& keys = shape.parameters;
  if (shape.type == "box" && keys.has("half")) {
    const auto& half = keys.numbers("half");
    const Vec<D> normal = half.size() == D ? Vec<D>(half.data()) : Vec<D>::Zero();
    if (normal.isZero(0.0)) throw InputError("half must not be zero: it points to the half that remains");
    return Cut<D>{Vec<D>::Zero(), normal.normalized()};
  }
  if constexpr (D == 2) {
    if (shape.type != "ring") return std::nullopt;
    const double opening = ring_opening(keys);
    if (opening >= 0.5 * std::numbers::pi) return std::nullopt;  // along the lattice
    const Vec<2> to_middle = Vec<2>::Constant(-0.5 * keys.number("outer_radius"));
    return Cut<2>{to_middle, Vec<2>(std::sin(opening), -std::cos(opening))};
  }
  return std::nullopt;
}

template std::optional<Cut<1>> cut_of<1>(const TypedEntry&);
template std::optional<Cut<2>> cut_of<2>(const TypedEntry&);
template std::optional<Cut<3>> cut_of<3>(const TypedEntry&);

}  // namespace anvil
