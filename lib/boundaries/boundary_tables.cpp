// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/boundaries/boundary_tables.hpp"

#include "anvil/boundaries/pressure.hpp"

namespace anvil {

std::span<const EntryKind> boundary_kinds() {
  static const std::vector<EntryKind> kinds = {
      {.type = "rigid_wall",
       .summary = "An immovable plane without friction that pushes and never pulls",
       .keys = {{.name = "point",
                 .kind = ValueKind::vector,
                 .unit = "m",
                 .standard = std::vector<double>{0.0},
                 .help = "a point of the plane"},
                {.name = "normal",
                 .kind = ValueKind::vector,
                 .help = "direction from the wall to the bodies, of any length but zero"},
                {.name = "contact",
                 .kind = ValueKind::choice,
                 .standard = "impulse",
                 .help = "impulse stops what would pass the plane within the step, and loses the energy of its approach; "
                         "penalty, in total_lagrangian, pushes with the depth behind the plane and gives back what it "
                         "takes",
                 .choices = {"impulse", "penalty"}},
                {.name = "stiffness",
                 .standard = 1.0,
                 .range = Range::positive,
                 .help = "of a penalty, over that of a layer of particles, (K + 4G/3)/spacing of the stiffest material"}}},
      pressure_kind(),
  };
  return kinds;
}

}  // namespace anvil
