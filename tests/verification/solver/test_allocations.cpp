// SPDX-License-Identifier: BSD-3-Clause
#include <atomic>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

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

[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto each = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(each, (size + each) / each * each)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace anvil {
namespace {

/// A bundled scene of each kind of step, coarse enough to be quick.
struct Kind {
  std::string scene;
  std::vector<std::string> set;
};

std::ostream& operator<<(std::ostream& stream, const Kind& kind) { return stream << kind.scene; }

class Allocations : public testing::TestWithParam<Kind> {};

long allocations_of_a_step(Simulation& simulation) {
  const long before = allocations;
  simulation.advance(1.0);
  return allocations - before;
}

TEST_P(Allocations, OnlyTheNeighbourSearchMakesAny) {
  const auto simulation = simulation_of(GetParam().scene, GetParam().set);
  constexpr int warm_up = 3, steps = 100;  // the first steps size what depends on the scene in motion
  for (int step = 0; step < warm_up; ++step) simulation->advance(1.0);
  int steps_without_search = 0;
  for (int step = 0; step < steps; ++step) {
    const double builds = audited(*simulation, "list_builds");
    const long made = allocations_of_a_step(*simulation);
    if (audited(*simulation, "list_builds") > builds) continue;
    ++steps_without_search;
    EXPECT_EQ(made, 0) << "in step " << step;
  }
  EXPECT_GT(steps_without_search, steps / 2);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Allocations,
                         testing::Values(Kind{"bar_elastic_1d", {}}, Kind{"plate_perfect", {}}, Kind{"cu_al", {}},
                                         Kind{"al_impact", {}}, Kind{"thin_rod", {}}, Kind{"poiseuille", {}},
                                         Kind{"water_column", {}},
                                         Kind{"be_shell_quarter", {"discretisation.spacing=0.8e-3"}},
                                         Kind{"rod_square",
                                              {"discretisation.spacing=1.6e-3", "stabiliser.smoothing_form=pairwise",
                                               "shock.method=artificial_viscosity"}},
                                         Kind{"rod_square_quarter", {"discretisation.spacing=1.6e-3"}},
                                         Kind{"rod_on_rod", {"discretisation.spacing=1.6e-3"}}),
                         [](const auto& test) { return test.param.scene; });

/// A count that always stands at zero would pass too.
TEST(AllocationCount, Counts) {
  const long before = allocations;
  const std::vector<double> numbers(1000, 1.0);
  EXPECT_EQ(numbers.back(), 1.0);
  EXPECT_GT(allocations, before);
}

}  // namespace
}  // namespace anvil
