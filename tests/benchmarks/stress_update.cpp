// SPDX-License-Identifier: BSD-3-Clause
// Time per particle of the constitutive update, the way a range of particles is updated: one law, fields in memory.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "anvil/materials/material_tables.hpp"
#include "anvil/materials/stress_update.hpp"

namespace anvil {
namespace {

constexpr std::size_t particle_count = 1000;  // stays in the L2 cache

struct Particles {
  explicit Particles(double rate) : gradients(particle_count), histories(particle_count) {
    std::mt19937 engine(7);
    std::uniform_real_distribution<double> uniform(-rate, rate);
    for (Tensor& gradient : gradients) gradient = Tensor::NullaryExpr([&] { return uniform(engine); });
  }
  std::vector<Tensor> gradients;
  std::vector<Tensor> deviators = std::vector<Tensor>(particle_count, Tensor::Zero());
  std::vector<StrengthHistory> histories;
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
    for (std::size_t i = 0; i < particle_count; ++i) {
      const PlasticStep step =
          update_deviator(law, particles.deviators[i], particles.histories[i], particles.gradients[i], dt);
      benchmark::DoNotOptimize(step);
    }
    dt = -dt;
  }
  state.counters["ns_per_particle"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(particle_count) * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
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
