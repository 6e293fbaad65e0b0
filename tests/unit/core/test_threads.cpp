// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/core/threads.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <vector>

namespace anvil {
namespace {

class Threads : public testing::TestWithParam<int> {
 protected:
  void SetUp() override { set_thread_count(GetParam()); }
  void TearDown() override { set_thread_count(before_); }

 private:
  int before_ = thread_count();
};

TEST_P(Threads, DoEachItemOnce) {
  for (const int count : {0, 1, 2, 3, 1000}) {
    std::vector<std::atomic<int>> visits(static_cast<std::size_t>(count));
    for_each_parallel(count, [&](int item, int) { ++visits[static_cast<std::size_t>(item)]; });
    EXPECT_TRUE(std::ranges::all_of(visits, [](const auto& times) { return times == 1; })) << count << " items";
  }
}

TEST_P(Threads, HaveNumbersBelowTheirCount) {
  ASSERT_EQ(thread_count(), GetParam());
  std::vector<int> worker(1000, -1);
  for_each_parallel(1000, [&](int item, int thread) { worker[static_cast<std::size_t>(item)] = thread; });
  EXPECT_GE(*std::ranges::min_element(worker), 0);
  EXPECT_LT(*std::ranges::max_element(worker), GetParam());
}

INSTANTIATE_TEST_SUITE_P(OneToFour, Threads, testing::Values(1, 2, 4));

}  // namespace
}  // namespace anvil
