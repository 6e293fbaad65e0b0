// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/boundaries/wall_keys.hpp"

namespace anvil {
namespace {

std::vector<Key> keys_of_rows() {
  return {{.name = "path",
           .kind = ValueKind::points,
           .unit = "m",
           .help = "in 2D: points of the wall's surface in turn, the bodies to the left of it",
           .optional = true},
          {.name = "closed", .kind = ValueKind::flag, .standard = false, .help = "whether path ends where it begins"},
          {.name = "min", .kind = ValueKind::vector, .unit = "m", .help = "in 3D: lowest corner", .optional = true},
          {.name = "max", .kind = ValueKind::vector, .unit = "m", .help = "in 3D: highest corner", .optional = true},
          {.name = "particles",
           .kind = ValueKind::choice,
           .standard = "inside",
           .help = "in 3D: on which side of the box the bodies are",
           .choices = {"inside", "outside"}},
          {.name = "open",
           .kind = ValueKind::choices,
           .standard = Texts{},
           .help = "in 3D: faces that are no wall",
           .choices = {"-x", "+x", "-y", "+y", "-z", "+z"}},
          {.name = "rows",
           .kind = ValueKind::integer,
           .standard = 3LL,
           .help = "rows of dummy particles",
           .choices = {"1", "2", "3", "4", "5", "6"}},
          {.name = "first_row",
           .standard = 0.5,
           .range = Range::fraction,
           .help = "distance of the first row behind the surface, in spacings"},
          {.name = "in_sums",
           .kind = ValueKind::flag,
           .standard = true,
           .help = "whether the dummy particles take part in continuity and momentum, with interpolated density and "
                   "stress"},
          {.name = "velocity",
           .kind = ValueKind::choice,
           .standard = "antisymmetric",
           .help = "velocity of the dummy particles in these sums, <v> that of the particles beside them: zero; "
                   "antisymmetric, -<v>, no slip; reversed_normal, <v> with its normal part reversed, free slip",
           .choices = {"zero", "antisymmetric", "reversed_normal", "moving_along"}}};
}

EntryKind with_rows(std::string_view type, std::string_view summary, const std::vector<Key>& own) {
  EntryKind kind{.type = type, .summary = summary, .keys = keys_of_rows(), .dimensions = {2, 3}};
  kind.keys.insert(kind.keys.end(), own.begin(), own.end());
  return kind;
}

}  // namespace

std::vector<EntryKind> dummy_wall_kinds() {
  const Key range{.name = "range",
                  .standard = 1.0,
                  .range = Range::fraction,
                  .help =
                      "reach of the force in smoothing lengths; no more than the first gap between the first row and "
                      "the bodies"};
  return {
      with_rows("long_range_wall", "Rows of dummy particles, the first of which repels with a peridynamic bond force",
                {{.name = "strength",
                  .standard = 1.0,
                  .range = Range::positive,
                  .help = "beta of the bond force: about 1 for water, 0.1 for soil"},
                 range,
                 {.name = "bulk_modulus",
                  .unit = "Pa",
                  .range = Range::positive,
                  .help = "K of the bond force",
                  .optional = true,
                  .derived = "that of the stiffest material of the scene"}}),
      with_rows("dummy_wall", "Rows of dummy particles without a force of their own", {}),
      with_rows("repulsive_wall", "Rows of dummy particles, the first of which repels as in Monaghan (1994)",
                {range,
                 {.name = "coefficient",
                  .unit = "m2/s2",
                  .range = Range::positive,
                  .help = "D of the repulsion, about the square of the largest speed",
                  .optional = true,
                  .derived = "a hundredth of the square of the fastest sound"}})};
}

}  // namespace anvil
