// SPDX-License-Identifier: BSD-3-Clause
// What a step with hllc costs over one with artificial viscosity, on one thread: the copper and aluminium plates in one
// dimension and the beryllium shell in two, both with the energy that their equation of state reads. Waves are on their
// way when the clock starts. Compare rows of one run.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "anvil/core/threads.hpp"
#include "anvil/scene/reader.hpp"
#include "anvil/solver/simulation.hpp"

namespace anvil {
namespace {

void run_steps(benchmark::State& state, const std::string& scene, double start,
               const std::vector<std::string>& overrides) {
  const int before = thread_count();
  set_thread_count(1);
  const auto simulation = make_simulation(read_scene(locate_scene(scene), overrides));
  while (simulation->time() < start) simulation->advance(start);
  constexpr double far_future = 1.0;  // s: no step is cut short
  for (auto _ : state) simulation->advance(far_future);
  state.counters["particle_steps"] = benchmark::Counter(static_cast<double>(simulation->particle_count()),
                                                        benchmark::Counter::kIsIterationInvariantRate);
  set_thread_count(before);
}

void plates(benchmark::State& state, const std::string& key) {
  run_steps(state, "cu_al", 0.5e-6, {key, "discretisation.spacing=0.05e-3"});
}
void shell(benchmark::State& state, const std::string& key, const std::string& more) {
  run_steps(state, "be_shell", 0.2e-6, {key, more, "discretisation.spacing=1e-3"});
}

BENCHMARK_CAPTURE(plates, viscosity, "shock.method=artificial_viscosity")->Iterations(600);
BENCHMARK_CAPTURE(plates, hllc_constant, "shock.reconstruction=constant")->Iterations(600);
BENCHMARK_CAPTURE(plates, hllc_linear, "shock.reconstruction=linear")->Iterations(600);
BENCHMARK_CAPTURE(shell, viscosity, "shock.method=artificial_viscosity", "shock.pair_gradient=plain")->Iterations(60);
BENCHMARK_CAPTURE(shell, hllc_constant, "shock.reconstruction=constant", "shock.pair_gradient=plain")->Iterations(60);
BENCHMARK_CAPTURE(shell, hllc_linear, "shock.reconstruction=linear", "shock.pair_gradient=plain")->Iterations(60);
BENCHMARK_CAPTURE(shell, hllc_constant_corrected, "shock.reconstruction=constant", "shock.pair_gradient=corrected")
    ->Iterations(60);
BENCHMARK_CAPTURE(shell, hllc_linear_corrected, "shock.reconstruction=linear", "shock.pair_gradient=corrected")
    ->Iterations(60);
BENCHMARK_CAPTURE(shell, hllc_linear_symmetrised, "shock.reconstruction=linear", "shock.pair_gradient=symmetrised")
    ->Iterations(60);

}  // namespace
}  // namespace anvil

BENCHMARK_MAIN();
