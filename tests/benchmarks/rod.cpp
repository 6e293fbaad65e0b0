// SPDX-License-Identifier: BSD-3-Clause
// Speed of whole steps: the square rod on its wall, from the impact on, nothing written, by smoothed particles and by
// total Lagrangian ones with edge stress points. Counters: particle-steps per second, neighbours per particle (mean
// within the support, at the start), passes over the pairs in a step, nanoseconds per particle and pass with all else
// in a step included, steps from one neighbour list to the next, and microseconds of the scene per second: what tells
// how long steps made of local ones compare.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "anvil/core/simd_level.hpp"
#include "anvil/core/threads.hpp"
#include "anvil/scene/reader.hpp"
#include "anvil/solver/simulation.hpp"

namespace anvil {
namespace {

struct Rod {
  std::string scene;
  std::vector<std::string> overrides;
  double passes;
  std::int64_t steps;
};

double list_builds(const Simulation& simulation) {
  for (const AuditValue& value : simulation.audit())
    if (value.name == "list_builds") return value.value;
  return 0.0;
}

void run_rod(benchmark::State& state, const Rod& rod, int threads) {
  set_thread_count(threads);
  const auto simulation = make_simulation(read_scene(locate_scene(rod.scene), rod.overrides));
  const Explanation explanation = simulation->explain();
  const double builds_before = list_builds(*simulation);
  constexpr double far_future = 1.0;  // s: no step is cut short
  for (auto _ : state) {
    simulation->advance(far_future);
  }
  const auto particles = static_cast<double>(explanation.particles);
  const auto steps = static_cast<double>(state.iterations());
  using benchmark::Counter;
  state.counters["particle_steps"] = Counter(particles, Counter::kIsIterationInvariantRate);
  state.counters["per_particle_pass"] =
      Counter(particles * rod.passes, Counter::kIsIterationInvariantRate | Counter::kInvert);
  state.counters["passes"] = rod.passes;
  state.counters["particles"] = particles;
  state.counters["neighbours"] = explanation.neighbours_per_particle;
  state.counters["steps_per_list"] = steps / std::max(1.0, list_builds(*simulation) - builds_before);
  state.counters["scene_us"] = Counter(1e6 * simulation->time(), Counter::kIsRate);
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
  const auto spaced = [](double spacing) { return fmt::format("discretisation.spacing={}", spacing); };
  constexpr double usual = 0.4e-3, fine = 0.128e-3;  // m: some 20,000 particles, and 640,000
  for (const double ratio : {1.2, 1.0})              // some 50 neighbours and 30
    for (const bool smoothing : {false, true}) {
      const std::string name = fmt::format("h:{:.1f}dx/{}", ratio, smoothing ? "smoothed" : "plain");
      std::vector<std::string> overrides = {fmt::format("discretisation.smoothing_ratio={:.1f}", ratio)};
      if (!smoothing) overrides.emplace_back("stabiliser.conservative_smoothing=0.0");
      const double passes = smoothing ? 3.0 : 2.0;  // velocity gradient, forces, filter
      for (const double spacing : {usual, fine}) {
        std::vector<std::string> all = overrides;
        all.push_back(spaced(spacing));
        anvil::register_rod((spacing == usual ? "rod/" : "large/") + name,
                            {"rod_square", all, passes, spacing == usual ? 300 : 20});
      }
    }
  for (const bool local : {false, true})
    for (const double spacing : {usual, fine})
      anvil::register_rod(
          fmt::format("{}/edge_points/{}", spacing == usual ? "rod" : "large", local ? "local_steps" : "one_step"),
          {"rod_square_best",
           {fmt::format("time.local_steps={}", local), spaced(spacing)},
           2.0,
           spacing == usual ? 300 : 20});
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
