// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace anvil {
namespace {

TEST(Curve, IsLinearBetweenItsPointsAndConstantBeyondItsEnds) {
  const Curve curve{{0.0, 1.0, 3.0}, {10.0, 20.0, 0.0}};
  EXPECT_DOUBLE_EQ(value_at(curve, 0.25), 12.5);
  EXPECT_DOUBLE_EQ(value_at(curve, 1.0), 20.0);
  EXPECT_DOUBLE_EQ(value_at(curve, 2.0), 10.0);
  EXPECT_DOUBLE_EQ(value_at(curve, -1.0), 10.0);
  EXPECT_DOUBLE_EQ(value_at(curve, 4.0), 0.0);
}

TEST(Curve, ThatTurnsBackGivesItsOutermostPassage) {
  // The outline of a foot whose edge has lifted: x = 1 is passed at y = 4, then at y = 8.
  const Curve outline{{2.0, 0.0, 2.0}, {6.0, 2.0, 14.0}};
  EXPECT_DOUBLE_EQ(value_at(outline, 1.0), 8.0);
}

TEST(Curve, ThatCurlsUpEndsInItsRim) {
  const Curve outline{{1.0, 0.8, 2.0, 5.0}, {8.0, 7.5, 6.0, 3.0}};
  EXPECT_DOUBLE_EQ(value_at(outline, 0.5), 8.0);
  EXPECT_DOUBLE_EQ(value_at(outline, 9.0), 3.0);
}

TEST(Curve, OfOnePointIsConstant) { EXPECT_DOUBLE_EQ(value_at({{1.0}, {5.0}}, 7.0), 5.0); }

TEST(RelativeDistance, IsTheL2NormOverThatOfTheReference) {
  const Curve reference{{0.0, 1.0}, {3.0, 4.0}};
  EXPECT_DOUBLE_EQ(relative_distance(reference, reference), 0.0);
  EXPECT_DOUBLE_EQ(relative_distance({{0.0, 1.0}, {3.3, 4.4}}, reference), 0.1);
  EXPECT_DOUBLE_EQ(relative_distance({{0.0, 1.0}, {4.0, 4.0}}, reference), 0.2);
}

}  // namespace
}  // namespace anvil
