// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "anvil/scene/reader.hpp"
#include "anvil/solver/simulation.hpp"

namespace anvil {
namespace {

std::string unit_of(const std::vector<AuditValue>& audit, const std::string& name) {
  const auto found = std::ranges::find(audit, name, &AuditValue::name);
  return found == audit.end() ? "not there" : found->unit;
}

TEST(Audit, CountsPerMetreOfEveryMissingDimension) {
  const std::pair<const char*, std::string> scenes[] = {
      {"plate_perfect", "/m2"}, {"water_column", "/m"}, {"rod_square", ""}};
  for (const auto& [name, depth] : scenes) {
    const auto audit = make_simulation(read_scene(locate_scene(name), {}))->audit();
    EXPECT_EQ(unit_of(audit, "mass"), "kg" + depth) << name;
    EXPECT_EQ(unit_of(audit, "momentum_x"), "N s" + depth) << name;
    EXPECT_EQ(unit_of(audit, "wall_impulse_x"), "N s" + depth) << name;
    EXPECT_EQ(unit_of(audit, "kinetic_energy"), "J" + depth) << name;
    EXPECT_EQ(unit_of(audit, "total_energy"), "J" + depth) << name;
    EXPECT_EQ(unit_of(audit, "minimum_pair_distance"), "m") << name;
  }
}

}  // namespace
}  // namespace anvil
