// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/concentric.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "anvil/core/error.hpp"

namespace anvil {

PlacedBody<2> place_concentric(const BodyDescription& body, double spacing) {
  if (body.shape.type != "ring")
    throw InputError(
        fmt::format("concentric layers fill a ring, and body '{}' is none; use the lattice cubic", body.name));
  const auto shape = make_shape<2>(body.shape);
  const Parameters& keys = body.shape.parameters;
  const double inner = keys.number("inner_radius"), thickness = keys.number("outer_radius") - inner;
  const std::string& sector = keys.text("sector");
  const long long parts = sector == "full" ? 1 : (sector == "half" ? 2 : 4);
  if (!(shape->volume() / (spacing * spacing) <= most_particles))
    throw InputError(
        fmt::format("a spacing of {} m fills the body with more than {:.3g} particles", spacing, most_particles));
  const Vec<2> middle(keys.numbers("centre").data());
  const auto layers = std::max(1LL, std::llround(thickness / spacing));
  const double layer = thickness / static_cast<double>(layers);
  PlacedBody<2> placed;
  for (long long k = 0; k < layers; ++k) {
    const double radius = inner + (static_cast<double>(k) + 0.5) * layer;
    const auto quarter = std::max(1LL, std::llround(0.5 * std::numbers::pi * radius / spacing));
    const double angle = 0.5 * std::numbers::pi / static_cast<double>(quarter);
    for (long long j = 0; j < 4 * quarter / parts; ++j) {
      const double turn = (static_cast<double>(j) + 0.5) * angle;
      placed.positions.push_back(middle + shape->turned(Vec<2>(radius * std::cos(turn), radius * std::sin(turn))));
      placed.volumes.push_back(angle * radius * layer);
    }
  }
  return placed;
}

}  // namespace anvil
