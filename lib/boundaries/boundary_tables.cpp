// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/boundaries/boundary_tables.hpp"

#include "anvil/boundaries/pressure.hpp"
#include "anvil/boundaries/wall_keys.hpp"

namespace anvil {

namespace {

/// A kind that is a plane, with what it asks besides.
EntryKind plane_kind(std::string_view type, std::string_view summary, std::string_view normal,
                     const std::vector<Key>& more = {}) {
  EntryKind kind{.type = type,
                 .summary = summary,
                 .keys = {{.name = "point",
                           .kind = ValueKind::vector,
                           .unit = "m",
                           .standard = std::vector<double>{0.0},
                           .help = "a point of the plane"},
                          {.name = "normal", .kind = ValueKind::vector, .help = normal}}};
  kind.keys.insert(kind.keys.end(), more.begin(), more.end());
  return kind;
}

}  // namespace

std::span<const EntryKind> boundary_kinds() {
  static const std::vector<EntryKind> kinds = [] {
    std::vector<EntryKind> all = {
        plane_kind("rigid_wall", "An immovable plane without friction that pushes and never pulls",
                   "direction from the wall to the bodies, of any length but zero",
                   {{.name = "contact",
                     .kind = ValueKind::choice,
                     .standard = "impulse",
                     .help = "impulse stops what would pass the plane within the step, and loses the energy of its "
                             "approach; penalty, in total_lagrangian, pushes with the depth behind the plane and gives "
                             "back what it takes",
                     .choices = {"impulse", "penalty"}},
                    {.name = "stiffness",
                     .standard = 1.0,
                     .range = Range::positive,
                     .help = "of a penalty, over that of a layer of particles, (K + 4G/3)/spacing of the stiffest "
                             "material"}}),
        plane_kind("symmetry_plane",
                   "A plane of symmetry: images of the particles stand behind it, and no particle crosses it",
                   "direction from the plane to the bodies, of any length but zero; planes meet at angles that divide "
                   "180 degrees"),
        {.type = "periodic",
         .summary = "The scene repeats along an axis: what leaves at one end enters at the other",
         .keys = {{.name = "axis",
                   .kind = ValueKind::choice,
                   .standard = "x",
                   .help = "direction in which it repeats",
                   .choices = {"x", "y", "z"}},
                  {.name = "min", .unit = "m", .help = "lower end of the period"},
                  {.name = "max", .unit = "m", .help = "upper end of the period"}}},
        plane_kind("mirror_wall", "Mirror images behind a plane, which nothing else keeps particles from crossing",
                   "direction from the wall to the bodies, of any length but zero",
                   {{.name = "slip",
                     .kind = ValueKind::flag,
                     .standard = true,
                     .help = "whether images keep the velocity along the plane; else they move against their "
                             "particles"}}),
        plane_kind("inflow", "What waits behind a plane is pushed through it",
                   "direction of the flow, of any length but zero",
                   {{.name = "speed", .unit = "m/s", .range = Range::positive, .help = "speed along the normal"}}),
        pressure_kind(),
    };
    for (const EntryKind& kind : dummy_wall_kinds()) all.push_back(kind);
    return all;
  }();
  return kinds;
}

}  // namespace anvil
