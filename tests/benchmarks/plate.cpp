// SPDX-License-Identifier: BSD-3-Clause
// Speed of whole steps of a line of particles on one thread: the two-layer plate, from the load on, nothing written.
// Also the time from a scene file to a simulation that is ready to step, and what a second thread is worth on long
// lines.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "anvil/core/threads.hpp"
#include "anvil/scene/reader.hpp"
#include "anvil/solver/simulation.hpp"

namespace anvil {
namespace {

std::unique_ptr<Simulation> make_plate(std::int64_t particles, const std::string& shock) {
  return make_simulation(read_scene(
      locate_scene("plate_two_layer"),
      {fmt::format("discretisation.spacing={}", 80e-3 / static_cast<double>(particles)), "shock.method=" + shock}));
}

/// Arguments: particles, threads.
void run_plate(benchmark::State& state, const std::string& shock) {
  const int before = thread_count();
  set_thread_count(static_cast<int>(state.range(1)));
  const auto simulation = make_plate(state.range(0), shock);
  constexpr double far_future = 1.0;  // s: no step is cut short
  for (auto _ : state) simulation->advance(far_future);
  using benchmark::Counter;
  state.counters["particle_steps"] = Counter(static_cast<double>(state.range(0)), Counter::kIsIterationInvariantRate);
  set_thread_count(before);
}

void start_plate(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(make_plate(state.range(0), "artificial_viscosity"));
}

BENCHMARK_CAPTURE(run_plate, viscosity, "artificial_viscosity")
    ->ArgsProduct({{800}, {1}})
    ->ArgsProduct({{6400, 25600}, {1, 2}})
    ->Iterations(3500)
    ->UseRealTime();
BENCHMARK_CAPTURE(run_plate, fct, "fct")->Args({800, 1})->Iterations(3500)->UseRealTime();
BENCHMARK(start_plate)->Arg(800)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace anvil

BENCHMARK_MAIN();
