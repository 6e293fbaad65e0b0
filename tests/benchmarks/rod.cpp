// SPDX-License-Identifier: BSD-3-Clause
// Speed of whole steps: the square rod on its wall, from the impact on, nothing written. Counters: particle-steps per
// second, neighbours per particle (mean within the support, at the start), passes over the pairs in a step, nanoseconds
// per particle and pass with all else in a step included, steps from one neighbour list to the next.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "anvil/core/threads.hpp"
#include "anvil/pairs/pair_loops.hpp"
#include "anvil/scene/reader.hpp"
#include "anvil/solver/simulation.hpp"

namespace anvil {
namespace {

struct Rod {
  double spacing;          // m
  double smoothing_ratio;  // 1.0: some 30 neighbours, 1.2: some 50
  bool smoothing;
  std::int64_t steps;
};

double list_builds(const Simulation& simulation) {
  for (const AuditValue& value : simulation.audit())
    if (value.name == "list_builds") return value.value;
  return 0.0;
}

std::unique_ptr<Simulation> make_rod(const Rod& rod) {
  std::vector<std::string> overrides = {fmt::format("discretisation.spacing={}", rod.spacing),
                                        fmt::format("discretisation.smoothing_ratio={:.1f}", rod.smoothing_ratio)};
  if (!rod.smoothing) overrides.emplace_back("stabiliser.conservative_smoothing=0.0");
  return make_simulation(read_scene(locate_scene("rod_square"), overrides));
}

void run_rod(benchmark::State& state, const Rod& rod, int threads) {
  set_thread_count(threads);
  const auto simulation = make_rod(rod);
  const Explanation explanation = simulation->explain();
  const double builds_before = list_builds(*simulation);
  constexpr double far_future = 1.0;  // s: no step is cut short
  for (auto _ : state) {
    simulation->advance(far_future);
  }
  const auto particles = static_cast<double>(explanation.particles);
  const auto steps = static_cast<double>(state.iterations());
  const double passes = rod.smoothing ? 3.0 : 2.0;  // velocity gradient, forces, filter
  using benchmark::Counter;
  state.counters["particle_steps"] = Counter(particles, Counter::kIsIterationInvariantRate);
  state.counters["per_particle_pass"] =
      Counter(particles * passes, Counter::kIsIterationInvariantRate | Counter::kInvert);
  state.counters["passes"] = passes;
  state.counters["particles"] = particles;
  state.counters["neighbours"] = explanation.neighbours_per_particle;
  state.counters["steps_per_list"] = steps / std::max(1.0, list_builds(*simulation) - builds_before);
  state.SetLabel(fmt::format("{}, double", simd_level()));
}

void register_rod(const std::string& name, const Rod& rod) {
  for (const int threads : {1, 2}) {
    benchmark::RegisterBenchmark(fmt::format("{}/threads:{}", name, threads).c_str(),
                                 [=](benchmark::State& state) { run_rod(state, rod, threads); })
        ->Iterations(rod.steps)
        ->MeasureProcessCPUTime()
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace
}  // namespace anvil

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  for (const double ratio : {1.2, 1.0}) {
    for (const bool smoothing : {false, true}) {
      const std::string name = fmt::format("h:{:.1f}dx/{}", ratio, smoothing ? "smoothed" : "plain");
      anvil::register_rod("rod/" + name, {0.4e-3, ratio, smoothing, 300});
      anvil::register_rod("large/" + name, {0.128e-3, ratio, smoothing, 20});
    }
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
