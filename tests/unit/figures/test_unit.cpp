// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/figures/unit.hpp"

#include <gtest/gtest.h>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

TEST(Unit, IsFoundByNameAndBySize) {
  EXPECT_DOUBLE_EQ(find_unit("GPa").factor, 1e9);
  EXPECT_EQ(find_unit("us").name, "µs");
  EXPECT_THROW(find_unit("gpa"), InputError);
  EXPECT_EQ(readable_unit("Pa", 5e9).name, "GPa");
  EXPECT_EQ(readable_unit("Pa", 5e8).name, "MPa");
  EXPECT_EQ(readable_unit("s", 14e-6).name, "µs");
  EXPECT_EQ(readable_unit("m", 0.08).name, "mm");
  EXPECT_EQ(readable_unit("m", 0.0).name, "m");
  EXPECT_EQ(readable_unit("furlong", 3.0).name, "furlong");
  EXPECT_EQ(with_unit("Density", find_unit("kg/m3")), "Density [kg/m³]");
  EXPECT_EQ(with_unit("Plastic strain", {}), "Plastic strain");
  EXPECT_EQ(with_unit("Energy", readable_unit("J/m2", 2.5e4)), "Energy [kJ/m²]");
  EXPECT_EQ(with_unit("Momentum", readable_unit("N s/m", 3.0)), "Momentum [N s/m]");
}

}  // namespace
}  // namespace anvil
