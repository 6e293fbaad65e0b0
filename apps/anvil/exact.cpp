// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/core.h>

#include <string>

#include "anvil/core/error.hpp"
#include "anvil/exact/scene_reference.hpp"
#include "anvil/exact/scene_shell.hpp"
#include "anvil/output/atomic_file.hpp"
#include "anvil/scene/reader.hpp"
#include "command_line.hpp"

namespace anvil {
namespace {

namespace po = boost::program_options;

Usage make_usage() {
  Usage usage{
      "anvil exact SCENE --time T [-o FILE] [options]",
      "Prints the exact solution of plane waves in a scene as CSV: a plate in layers or a rod, under any "
      "pressures,\nin contact or in flight. Positions are those before the deformation. Of a collapsing ring it "
      "prints\nradii and energies from the start to T.",
      "SCENE"};
  auto add = usage.options.add_options();
  add("time", po::value<double>()->value_name("T"), "time in s");
  add("points", po::value<int>()->value_name("N")->default_value(1000),
      "number of points, evenly from face to face; 0: the ends of every uniform zone, so that fronts are steps");
  add("strain", po::value<std::string>()->value_name("MEASURE"),
      "finite or small; default: what compare.reference of the scene says, else finite");
  add("output,o", po::value<std::string>()->value_name("FILE"), "file to write (default: standard output)");
  add_scene_options(usage);
  return usage;
}

StrainMeasure measure_from(const po::variables_map& values, const Scene& scene) {
  if (values.count("strain") == 0) return strain_measure_of(scene);
  const auto& text = values["strain"].as<std::string>();
  if (text == "finite") return StrainMeasure::finite;
  if (text == "small") return StrainMeasure::small;
  throw InputError(fmt::format("--strain must be finite or small, found '{}'", text));
}

double time_from(const po::variables_map& values, const Usage& usage) {
  if (values.count("time") == 0) throw InputError(fmt::format("--time is missing; usage: {}", usage.synopsis));
  const double time = values["time"].as<double>();
  if (!(time >= 0.0)) throw InputError(fmt::format("--time must be zero or more, found {}", time));
  return time;
}

std::vector<ExactPoint> sample(const SceneReference& reference, int points) {
  constexpr int most = 10'000'000;
  if (points == 0) return reference.line(0);
  if (points < 2 || points > most)
    throw InputError(fmt::format("--points must be 0, or a whole number from 2 to {}, found {}", most, points));
  std::vector<ExactPoint> samples;
  for (int i = 0; i < points; ++i)
    samples.push_back(reference.at(0, reference.begin() + (reference.end() - reference.begin()) * i / (points - 1)));
  return samples;
}

std::string write_table(const std::vector<ExactPoint>& points, bool has_density) {
  std::string text =
      "initial_position [m],stress_xx [Pa],velocity_x [m/s],pressure [Pa],deviator_xx [Pa],specific_energy [J/kg]";
  text += has_density ? ",density [kg/m3]\n" : "\n";
  for (const auto& point : points) {
    text += fmt::format("{},{},{},{},{},{}", point.initial_position, point.stress, point.velocity, point.pressure,
                        point.deviator, point.energy);
    text += has_density ? fmt::format(",{}\n", point.density) : "\n";
  }
  return text;
}

/// A shell over time: faces and energies at `points` times from the start to `time`.
std::string shell_table(const Scene& scene, double time, int points) {
  constexpr std::size_t cells = 400;
  if (points < 2) throw InputError(fmt::format("--points must be 2 or more for a shell, found {}", points));
  CylindricalShell shell(shell_problem(scene), cells);
  std::string text =
      fmt::format("# {}: one-dimensional calculation with {} cells, energies per metre\n", scene.title, cells);
  text += "time [s],inner_radius [m],outer_radius [m],kinetic_energy [J/m],internal_energy [J/m],plastic_work [J/m]\n";
  for (int i = 0; i < points; ++i) {
    shell.advance_to(time * i / (points - 1));
    text += fmt::format("{},{},{},{},{},{}\n", shell.time(), shell.inner_radius(), shell.outer_radius(),
                        shell.kinetic_energy(), shell.internal_energy(), shell.plastic_work());
  }
  return text;
}

std::string wave_table(const Scene& scene, double time, const po::variables_map& values) {
  const SceneReference reference(scene, {time}, measure_from(values, scene));
  return fmt::format("# {}, t = {} s: {}\n", scene.title.empty() ? scene.name : scene.title, time,
                     reference.description()) +
         write_table(sample(reference, values["points"].as<int>()), scene.domain.strain_state == "uniaxial_strain");
}

}  // namespace

int execute_exact(const Arguments& arguments) {
  Usage usage = make_usage();
  const auto values = parse(usage, arguments);
  if (!values) return 0;
  const Scene scene = read_scene(locate_scene(required(*values, usage, "SCENE")), repeated(*values, "set"));
  const double time = time_from(*values, usage);
  const std::string text =
      is_shell(scene) ? shell_table(scene, time, (*values)["points"].as<int>()) : wave_table(scene, time, *values);
  if (values->count("output") != 0)
    write_text_atomically((*values)["output"].as<std::string>(), text);
  else
    fmt::print("{}", text);
  return 0;
}

}  // namespace anvil
