// SPDX-License-Identifier: BSD-3-Clause
#include <atomic>
#include <cstdlib>
#include <new>

#include "verification/simulate.hpp"

namespace {
std::atomic<long> allocations{0};
}  // namespace

// Not inlined: seen side by side, the compiler takes malloc and these for mismatched pairs.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace anvil {
namespace {

long allocations_of_a_step(Simulation& simulation) {
  const long before = allocations;
  simulation.advance(1.0);
  return allocations - before;
}

TEST(Allocations, OnlyTheNeighbourSearchMakesAny) {
  const auto rod = coarse_rod({"stabiliser.smoothing_form=pairwise", "shock.method=artificial_viscosity"});
  int steps_without_search = 0, searches = 0;
  for (int step = 0; step < 200; ++step) {
    const double builds = audited(*rod, "list_builds");
    const long made = allocations_of_a_step(*rod);
    if (audited(*rod, "list_builds") > builds) {
      ++searches;
      continue;
    }
    ++steps_without_search;
    EXPECT_EQ(made, 0) << "in step " << step;
  }
  EXPECT_GT(steps_without_search, 100);
  EXPECT_GT(searches, 2);
}

}  // namespace
}  // namespace anvil
