// SPDX-License-Identifier: BSD-3-Clause
// Time per particle of the constitutive update, the way a range of particles is updated: one law, fields in memory.
#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "anvil/materials/material_tables.hpp"
#include "anvil/materials/strain_state.hpp"
#include "anvil/materials/stress_update.hpp"

namespace anvil {
namespace {

constexpr std::size_t particle_count = 1000;  // stays in the L2 cache

using Components = std::array<double, FullStrain::components>;

struct Particles {
  explicit Particles(double rate) : gradients(particle_count) {
    std::mt19937 engine(7);
    std::uniform_real_distribution<double> uniform(-rate, rate);
    for (auto& gradient : gradients) {
      for (double& component : gradient) component = uniform(engine);
    }
  }
  std::vector<std::array<double, 9>> gradients;
  std::vector<Components> deviators = std::vector<Components>(particle_count, Components{});
  std::vector<Components> back_stresses = std::vector<Components>(particle_count, Components{});
  std::vector<double> plastic_strains = std::vector<double>(particle_count, 0.0);

  template <class Law>
  double update(std::size_t i, const Law& law, double dt) {
    StrengthHistory history;
    history.plastic_strain = plastic_strains[i];
    if (law.has_back_stress()) history.back_stress = FullStrain::deviator(back_stresses[i].data());
    Tensor deviator = FullStrain::deviator(deviators[i].data());
    const PlasticStep step = update_deviator(law, deviator, history, lift_gradient<3>(gradients[i].data()), dt);
    FullStrain::store(deviator, deviators[i].data());
    if (law.has_back_stress()) FullStrain::store(history.back_stress, back_stresses[i].data());
    plastic_strains[i] = history.plastic_strain;
    return step.plastic_work;
  }
};

template <class Law>
Law make_law(double isotropic_fraction) {
  Parameters parameters;
  for (const Key& key : Law::kind().keys) parameters.set(std::string(key.name), 400e6);
  parameters.set("isotropic_fraction", isotropic_fraction);
  return Law(parameters);
}

/// The gradients alternate in sign, so that stresses stay where they are: below yield for small strains per step, on
/// the yield surface for large ones.
template <class Law>
void update_stress(benchmark::State& state, double strain_per_step, double isotropic_fraction) {
  const Law law = make_law<Law>(isotropic_fraction);
  Particles particles(strain_per_step);
  double dt = 1.0;
  for (auto _ : state) {
    double work = 0.0;
    for (std::size_t i = 0; i < particle_count; ++i) work += particles.update(i, law, dt);
    benchmark::DoNotOptimize(work);
    dt = -dt;
  }
  state.counters["per_particle"] = benchmark::Counter(
      static_cast<double>(particle_count), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

constexpr double small_strain = 1e-4;
constexpr double large_strain = 10.0;

void elastic(benchmark::State& state) { update_stress<Elastic>(state, small_strain, 1.0); }
void j2_below_yield(benchmark::State& state) { update_stress<J2>(state, small_strain, 1.0); }
void j2_yielding_isotropic(benchmark::State& state) { update_stress<J2>(state, large_strain, 1.0); }
void j2_yielding_kinematic(benchmark::State& state) { update_stress<J2>(state, large_strain, 0.0); }

BENCHMARK(elastic);
BENCHMARK(j2_below_yield);
BENCHMARK(j2_yielding_isotropic);
BENCHMARK(j2_yielding_kinematic);

}  // namespace
}  // namespace anvil

BENCHMARK_MAIN();
