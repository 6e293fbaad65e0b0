// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/core.h>

#include "anvil/scene/reader.hpp"
#include "anvil/solver/simulation.hpp"
#include "command_line.hpp"
#include "table.hpp"

namespace anvil {
namespace {

void print_terms(const Explanation& explanation) {
  std::vector<TableRow> rows;
  for (const auto& term : explanation.terms)
    rows.push_back({fmt::format("{}.", rows.size() + 1), term.name, term.purpose});
  fmt::print("A step is made of\n");
  print_table(rows, "rll");
}

void print_fields(const Explanation& explanation) {
  std::vector<TableRow> rows = {{"field", "unit", "bytes", "purpose"}};
  for (const auto& field : explanation.fields)
    rows.push_back(
        {field.name, field.unit.empty() ? "-" : field.unit, std::to_string(field.bytes_per_particle), field.purpose});
  fmt::print("\nA particle carries\n");
  print_table(rows, "llrl");
}

void print_cost(const Scene& scene, const Explanation& explanation) {
  const auto particles = static_cast<double>(explanation.particles);
  const double megabytes = particles * explanation.bytes_per_particle / 1e6;
  fmt::print("\nThe scene takes\n");
  print_table(
      {{"particles", std::to_string(explanation.particles)},
       {"neighbours per particle", fmt::format("{:.1f}", explanation.neighbours_per_particle)},
       {"bytes per particle, neighbour list included", std::to_string(explanation.bytes_per_particle)},
       {"memory", fmt::format("{:.1f} MB", megabytes)},
       {"first time step", fmt::format("{:.4g} s", explanation.first_time_step)},
       {fmt::format("steps to {:.4g} s, at that step", scene.time.end), std::to_string(explanation.steps_expected)},
       {"particle-steps", fmt::format("{:.3g}", particles * static_cast<double>(explanation.steps_expected))}},
      "lr");
}

}  // namespace

int execute_explain(const Arguments& arguments) {
  Usage usage{"anvil explain SCENE [--set KEY=VALUE]...",
              "Shows the terms a step of the scene is made of, the fields they need, and what a run will cost.",
              "SCENE"};
  add_scene_options(usage);
  const auto values = parse(usage, arguments);
  if (!values) return 0;
  const Scene scene = read_scene(locate_scene(required(*values, usage, "SCENE")), repeated(*values, "set"));
  const Explanation explanation = make_simulation(scene)->explain();
  fmt::print("{}\n\n", scene.title.empty() ? scene.name : scene.title);
  print_terms(explanation);
  print_fields(explanation);
  print_cost(scene, explanation);
  return 0;
}

}  // namespace anvil
