// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/concentric.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "anvil/core/error.hpp"
#include "anvil/scene/ring.hpp"

namespace anvil {

PlacedBody<2> place_concentric(const BodyDescription& body, double spacing) {
  if (body.shape.type != "ring")
    throw InputError(
        fmt::format("concentric layers fill a ring, and body '{}' is none; use the lattice cubic", body.name));
  const auto shape = make_shape<2>(body.shape);
  const Parameters& keys = body.shape.parameters;
  const double inner = keys.number("inner_radius"), thickness = keys.number("outer_radius") - inner;
  const double opening = ring_opening(keys), part = std::min(opening, 0.5 * std::numbers::pi);
  const long long parts = std::llround(opening / part);
  if (!(shape->volume() / (spacing * spacing) <= most_particles))
    throw InputError(
        fmt::format("a spacing of {} m fills the body with more than {:.3g} particles", spacing, most_particles));
  const Vec<2> middle(keys.numbers("centre").data());
  const auto layers = std::max(1LL, std::llround(thickness / spacing));
  const double layer = thickness / static_cast<double>(layers);
  PlacedBody<2> placed;
  for (long long k = 0; k < layers; ++k) {
    const double radius = inner + (static_cast<double>(k) + 0.5) * layer;
    const auto in_part = std::max(1LL, std::llround(part * radius / spacing));  // a sector has the ring's particles
    const double angle = part / static_cast<double>(in_part);
    for (long long j = 0; j < parts * in_part; ++j) {
      const double turn = (static_cast<double>(j) + 0.5) * angle;
      placed.positions.push_back(middle + shape->turned(Vec<2>(radius * std::cos(turn), radius * std::sin(turn))));
      placed.volumes.push_back(angle * radius * layer);
    }
  }
  return placed;
}

}  // namespace anvil
