// SPDX-License-Identifier: BSD-3-Clause
// What each optional term adds to a step: scenes with and without it, stepped in turn on one thread, by the user time
// of the processor. Prints the tables of docs/term_costs.md. Usage: benchmark_terms [rounds]
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "anvil/core/threads.hpp"
#include "anvil/scene/reader.hpp"
#include "anvil/solver/simulation.hpp"

namespace anvil {
namespace {

using Overrides = std::vector<std::string>;

struct Comparison {
  const char* term;
  Overrides without, with;
};

constexpr const char* materials = R"(
[material.one]
density = 8930
eos = { type = "linear", bulk_modulus = 130e9 }
strength = { type = "j2", shear_modulus = 43e9, yield_stress = 400e6, hardening_modulus = 100e6 }
[material.two]
density = 2700
eos = { type = "linear", bulk_modulus = 76e9 }
strength = { type = "j2", shear_modulus = 26e9, yield_stress = 300e6, hardening_modulus = 100e6 }
)";

/// A line and a block in two halves that meet: bodies under a linear velocity would come to rest or apart.
constexpr const char* line = R"(
domain = { dimension = 1 }
discretisation = { spacing = 10e-6 }
time = { end = 1 }
[[body]]
name = "left"
shape = { type = "interval", min = -32e-3, max = 0 }
material = "one"
velocity = [100]
[[body]]
name = "right"
shape = { type = "interval", min = 0, max = 32e-3 }
material = "one"
)";

constexpr const char* block = R"(
domain = { dimension = 3 }
discretisation = { spacing = 1e-3 }
time = { end = 1 }
[[body]]
name = "left"
shape = { type = "box", min = [-20e-3, 0, 0], max = [0, 16e-3, 16e-3] }
material = "one"
velocity = [100, 0, 0]
[[body]]
name = "right"
shape = { type = "box", min = [0, 0, 0], max = [20e-3, 16e-3, 16e-3] }
material = "one"
)";

const Overrides viscosity = {"shock.method=artificial_viscosity"};
const Overrides hllc = {"shock.method=hllc"};

std::vector<Comparison> comparisons(bool in_line) {
  std::vector<Comparison> all = {
      {"artificial_viscosity", {}, viscosity},
      {"hllc instead of artificial_viscosity", viscosity, hllc},
      {"energy: mie_grueneisen instead of linear",
       viscosity,
       {viscosity[0], "material.one.eos={type=\"mie_grueneisen\",sound_speed=3940,slope=1.489,grueneisen=1.99}"}},
      {"variable smoothing length", {"discretisation.variable_smoothing_length=false"}, {}},
      {"conservative_smoothing", {}, {"stabiliser.conservative_smoothing=0.14"}},
      {"kernel_gradient_correction", {}, {"discretisation.method=kernel_gradient_correction"}},
      {"cspm", {}, {"discretisation.method=cspm"}},
      {"plasticity: j2 instead of elastic", {"material.one.strength={type=\"elastic\",shear_modulus=43e9}"}, {}},
      {"second material", {}, {"body.right.material=two"}}};
  if (in_line) all.insert(all.begin(), {"fct", {}, {"shock.method=fct"}});
  return all;
}

double user_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Seconds of `steps` steps.
double step_for(Simulation& simulation, int steps) {
  const double start = user_seconds();
  for (int k = 0; k < steps; ++k) simulation.advance(1.0);
  return user_seconds() - start;
}

std::unique_ptr<Simulation> simulation_of(const char* scene, const Overrides& overrides) {
  return make_simulation(read_scene_text(std::string(scene) + materials, "costs", overrides));
}

void print_costs(const char* heading, const char* scene, bool in_line, int steps, int rounds) {
  fmt::print("\n| {} | ns per particle and step without | with | cost |\n|---|---|---|---|\n", heading);
  for (const auto& comparison : comparisons(in_line)) {
    const auto without = simulation_of(scene, comparison.without), with = simulation_of(scene, comparison.with);
    std::vector<double> times_without, times_with, ratios;
    step_for(*without, steps / 5);
    step_for(*with, steps / 5);
    for (int round = 0; round < rounds; ++round) {
      times_without.push_back(step_for(*without, steps));
      times_with.push_back(step_for(*with, steps));
      ratios.push_back(times_with.back() / times_without.back());
    }
    const double scale = 1e9 / static_cast<double>(steps) / static_cast<double>(without->particle_count());
    fmt::print("| {} | {:.0f} | {:.0f} | {:+.0f} % |\n", comparison.term, scale * median(times_without),
               scale * median(times_with), 100.0 * (median(ratios) - 1.0));
  }
}

}  // namespace
}  // namespace anvil

int main(int count, char** arguments) {
  anvil::set_thread_count(1);
  const int rounds = count > 1 ? std::max(1, std::atoi(arguments[1])) : 5;
  anvil::print_costs("line of 6400 particles", anvil::line, true, 100, rounds);
  anvil::print_costs("block of 20 x 16 x 16 particles twice", anvil::block, false, 4, rounds);
}
