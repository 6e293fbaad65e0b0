// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/figures/expression.hpp"

#include <gtest/gtest.h>

#include <string>

#include "anvil/core/error.hpp"
#include "anvil/figures/unit.hpp"

namespace anvil {
namespace {

/// Two particles.
Frame make_frame() {
  Frame frame;
  frame.positions = {1.0, 0.0, 0.0, 2.0, 0.0, 0.0};
  frame.arrays = {{"pressure", "Pa", 1, false, {3.0, 4.0}},
                  {"velocity", "m/s", 3, false, {5.0, 6.0, 7.0, 8.0, 9.0, 10.0}},
                  {"stress", "Pa", 6, false, {1, 2, 3, 4, 5, 6, -1, -2, -3, -4, -5, -6}}};
  return frame;
}

TEST(Expression, FindsComponentsOfFields) {
  const Frame frame = make_frame();
  const auto fields = fields_of(frame);
  EXPECT_EQ(evaluate("velocity.y", fields).values, (std::vector<double>{6.0, 9.0}));
  EXPECT_EQ(evaluate("stress.xz", fields).values, (std::vector<double>{6.0, -6.0}));
  EXPECT_EQ(evaluate("position.x", fields).values, (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(evaluate("velocity.x", fields).unit, "m/s");
}

TEST(Expression, ComputesWithThem) {
  const Frame frame = make_frame();
  const auto fields = fields_of(frame);
  const Evaluated axial = evaluate("-(stress.xx + pressure)/0.5", fields);
  EXPECT_EQ(axial.values, (std::vector<double>{-8.0, -6.0}));
  EXPECT_EQ(axial.unit, "");  // a product may have any unit
  EXPECT_EQ(evaluate("stress.xx + pressure", fields).unit, "Pa");
  EXPECT_EQ(evaluate("stress.xx + velocity.x", fields).unit, "");
  EXPECT_EQ(evaluate("abs(stress.yy)", fields).values, (std::vector<double>{2.0, 2.0}));
  EXPECT_EQ(evaluate("2", fields).values, (std::vector<double>{2.0, 2.0}));
}

TEST(Expression, SaysWhatIsWrong) {
  const Frame frame = make_frame();
  const auto fields = fields_of(frame);
  try {
    evaluate("velocty.x", fields);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'velocity.x'?"), std::string::npos) << error.what();
  }
  EXPECT_THROW(evaluate("pressure +", fields), InputError);
  EXPECT_THROW(evaluate("", fields), InputError);
}

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
}

}  // namespace
}  // namespace anvil
