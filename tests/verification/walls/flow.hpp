// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "verification/simulate.hpp"

namespace anvil {

/// Largest of a quantity over the particles of bodies: `of(frame, i)` for each particle i of body 0.
template <class Of>
double largest_of_bodies(const Frame& frame, Of&& of) {
  const auto body = array_of(frame, "body");
  double largest = -1e300;
  for (std::size_t i = 0; i < body.size(); ++i)
    if (body[i] == 0.0) largest = std::max(largest, of(frame, i));
  return largest;
}

inline double speed_of(const Frame& frame, std::size_t i) {
  const auto& velocity = frame.find("velocity")->values;
  return std::hypot(velocity[3 * i], velocity[3 * i + 1], velocity[3 * i + 2]);
}

/// Kinetic, elastic, potential energy and what walls have stored, J.
inline double mechanical_energy(const Simulation& simulation) {
  return audited(simulation, "kinetic_energy") + audited(simulation, "elastic_energy") +
         audited(simulation, "potential_energy") + audited(simulation, "wall_stored_energy");
}

}  // namespace anvil
