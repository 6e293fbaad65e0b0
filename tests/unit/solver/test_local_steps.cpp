// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "anvil/solver/local_steps.hpp"

namespace anvil {
namespace {

/// Tiles in a row, each near the ones beside it.
struct Row : LocalSteps {
  explicit Row(const std::vector<double>& limits) {
    limit = limits;
    const auto count = static_cast<std::int32_t>(limits.size());
    for (std::int32_t tile = 0; tile < count; ++tile) {
      all.push_back(tile);
      near.emplace_back();
      for (const std::int32_t beside : {tile - 1, tile, tile + 1})
        if (beside >= 0 && beside < count) near.back().push_back(beside);
    }
  }
};

TEST(LocalSteps, GrowWithTheDistanceFromASqueezedTile) {
  std::vector<double> limit(9, 1.0);
  limit[0] = 0.1;
  Row steps(limit);
  steps.classify(0.1, 2);  // 0.4 is the longest step then
  EXPECT_EQ(steps.edge_level, (std::vector<int>{0, 0, 2, 2, 2, 2, 2, 2, 2}));
  EXPECT_EQ(steps.strain_level, (std::vector<int>{0, 0, 0, 2, 2, 2, 2, 2, 2}));
  EXPECT_EQ(steps.move_level, (std::vector<int>{0, 0, 0, 0, 2, 2, 2, 2, 2}));
  EXPECT_EQ(steps.highest, 2);
}

TEST(LocalSteps, AreNoLongerThanATileAllows) {
  std::vector<double> limit;
  for (int tile = 0; tile < 12; ++tile) limit.push_back(0.1 * (tile + 1));
  Row steps(limit);
  steps.classify(0.1, 5);
  for (std::size_t t = 0; t < limit.size(); ++t) {
    EXPECT_LE(0.1 * (1 << steps.edge_level[t]), limit[t] * (1.0 + 1e-12)) << t;
    EXPECT_LE(steps.strain_level[t], steps.edge_level[t]);
    EXPECT_LE(steps.move_level[t], steps.strain_level[t]);
  }
  EXPECT_EQ(steps.highest, 3);  // 0.8, from the twelfth tile's 1.2
}

TEST(LocalSteps, AreEqualWhereNothingIsSqueezed) {
  Row steps({1.0, 1.0, 1.1, 1.9});
  steps.classify(1.0, 5);
  EXPECT_EQ(steps.highest, 0);
}

}  // namespace
}  // namespace anvil
