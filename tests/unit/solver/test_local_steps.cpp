// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "anvil/solver/local_steps.hpp"

namespace anvil {
namespace {

/// Tiles in a row, each near the ones beside it.
LocalSteps row_of(std::int32_t count) {
  LocalSteps steps;
  for (std::int32_t tile = 0; tile < count; ++tile) {
    steps.all.push_back(tile);
    steps.near.emplace_back();
    for (const std::int32_t beside : {tile - 1, tile, tile + 1})
      if (beside >= 0 && beside < count) steps.near.back().push_back(beside);
  }
  return steps;
}

TEST(LocalSteps, SurroundTheSqueezedTiles) {
  LocalSteps steps = row_of(9);
  std::vector<double> limit(9, 1.0);
  limit[0] = 0.1;
  steps.classify(limit, 0.8);
  EXPECT_EQ(steps.edges, (LocalSteps::Tiles{0, 1}));
  EXPECT_EQ(steps.strained, (LocalSteps::Tiles{0, 1, 2}));
  EXPECT_EQ(steps.moved, (LocalSteps::Tiles{0, 1, 2, 3}));
  EXPECT_EQ(steps.other_edges, (LocalSteps::Tiles{2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(steps.not_strained, (LocalSteps::Tiles{3, 4, 5, 6, 7, 8}));
}

TEST(LocalSteps, AreNoneWhereNothingIsSqueezed) {
  LocalSteps steps = row_of(4);
  const std::vector<double> limit(4, 1.0);
  steps.classify(limit, 1.0);
  EXPECT_TRUE(steps.moved.empty());
  EXPECT_EQ(steps.not_strained, steps.all);
  EXPECT_EQ(steps.best_ratio(limit), 1);
}

// One of 100 tiles a tenth as thick as the others: eight short steps to a long one take (100 + 7 * 4) / 8 tiles per
// short step, the least; with sixteen all tiles are squeezed.
TEST(LocalSteps, AreAsManyAsPay) {
  LocalSteps steps = row_of(100);
  std::vector<double> limit(100, 1.0);
  limit[0] = 0.1;
  EXPECT_EQ(steps.best_ratio(limit), 8);
}

}  // namespace
}  // namespace anvil
