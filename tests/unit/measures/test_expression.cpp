// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "anvil/core/error.hpp"
#include "anvil/measures/frame_fields.hpp"

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
  EXPECT_EQ(field_of(frame, "velocity.y").values, (std::vector<double>{6.0, 9.0}));
  EXPECT_EQ(field_of(frame, "stress.xz").values, (std::vector<double>{6.0, -6.0}));
  EXPECT_EQ(field_of(frame, "position.x").values, (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(field_of(frame, "velocity.x").unit, "m/s");
}

TEST(Expression, ComputesWithThem) {
  const Frame frame = make_frame();
  const Evaluated axial = field_of(frame, "-(stress.xx + pressure)/0.5");
  EXPECT_EQ(axial.values, (std::vector<double>{-8.0, -6.0}));
  EXPECT_EQ(axial.unit, "");  // a product may have any unit
  EXPECT_EQ(field_of(frame, "stress.xx + pressure").unit, "Pa");
  EXPECT_EQ(field_of(frame, "stress.xx + velocity.x").unit, "");
  EXPECT_EQ(field_of(frame, "abs(stress.yy)").values, (std::vector<double>{2.0, 2.0}));
  EXPECT_EQ(field_of(frame, "2").values, (std::vector<double>{2.0, 2.0}));
}

TEST(Expression, SaysWhatIsWrong) {
  const Frame frame = make_frame();
  try {
    field_of(frame, "velocty.x");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'velocity.x'?"), std::string::npos) << error.what();
  }
  EXPECT_THROW(field_of(frame, "pressure +"), InputError);
  EXPECT_THROW(field_of(frame, ""), InputError);
}

TEST(FrameFields, DerivesLengthsAndInvariants) {
  const Frame frame = make_frame();
  EXPECT_DOUBLE_EQ(field_of(frame, "velocity").values[0], std::sqrt(110.0));
  EXPECT_DOUBLE_EQ(field_of(frame, "velocity.magnitude").values[0], std::sqrt(110.0));
  EXPECT_EQ(field_of(frame, "radius").values, (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(field_of(frame, "stress.mean").values, (std::vector<double>{2.0, -2.0}));
  EXPECT_EQ(field_of(frame, "von_mises").unit, "Pa");
  // Of the first: sqrt(((1-2)^2 + (2-3)^2 + (3-1)^2)/2 + 3 (4^2 + 5^2 + 6^2)).
  EXPECT_NEAR(field_of(frame, "von_mises").values[0], std::sqrt(3.0 + 3.0 * 77.0), 1e-12);
  // Trace, and the sum of squares of the principal values, are those of the tensor.
  double trace = 0.0;
  double squares = 0.0;
  for (const std::string name : {"stress.principal_1", "stress.principal_2", "stress.principal_3"}) {
    const double value = field_of(frame, name).values[0];
    trace += value;
    squares += value * value;
  }
  EXPECT_NEAR(trace, 6.0, 1e-12);
  EXPECT_NEAR(squares, 14.0 + 2.0 * 77.0, 1e-11);
  EXPECT_GE(field_of(frame, "stress.principal_1 - stress.principal_2").values[0], 0.0);
  EXPECT_NEAR(field_of(frame, "2*stress.max_shear - (stress.principal_1 - stress.principal_3)").values[0], 0.0, 1e-12);
}

TEST(FrameFields, NamesEveryFieldItKnows) {
  const Frame frame = make_frame();
  for (const auto& name : field_names(frame)) EXPECT_EQ(field_of(frame, name).values.size(), 2U) << name;
}

}  // namespace
}  // namespace anvil
