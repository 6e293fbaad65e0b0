// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numbers>
#include <string>

#include "anvil/core/error.hpp"
#include "anvil/scene/scene.hpp"

namespace anvil {

/// Radians that a ring of these keys spans about its centre, from the x axis on. Throws InputError when keys disagree.
inline double ring_opening(const Parameters& keys) {
  constexpr double pi = std::numbers::pi;
  const std::string& sector = keys.text("sector");
  const double opening = keys.number("opening");
  if (sector == "wedge" && !(opening > 0.0 && opening <= 0.5 * pi))
    throw InputError("a wedge needs an opening above 0 and up to pi / 2");
  if (sector != "wedge" && opening != 0.0) throw InputError("only a wedge has an opening: set sector = \"wedge\"");
  if (sector == "wedge") return opening;
  return sector == "full" ? 2.0 * pi : (sector == "half" ? pi : 0.5 * pi);
}

}  // namespace anvil
