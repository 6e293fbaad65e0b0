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
                 .help = "direction from the wall to the bodies, of any length but zero"}}},
      pressure_kind(),
  };
  return kinds;
}

}  // namespace anvil
