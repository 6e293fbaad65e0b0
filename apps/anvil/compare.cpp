// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "anvil/core/data_path.hpp"
#include "anvil/core/error.hpp"
#include "anvil/measures/balance.hpp"
#include "anvil/measures/comparison.hpp"
#include "anvil/measures/wave_comparison.hpp"
#include "anvil/output/atomic_file.hpp"
#include "anvil/output/provenance.hpp"
#include "anvil/output/result_folder.hpp"
#include "anvil/scene/reader.hpp"
#include "command_line.hpp"
#include "frames.hpp"
#include "plotted_result.hpp"
#include "table.hpp"

namespace anvil {
namespace {

Result read_result(const ResultFolder& folder, const Provenance& run) {
  return {read_scene_text(run.scene_text, run.scene_name), read_any_frame(folder.last_frame()),
          read_history(folder.history())};
}

Reference reference_of(const Scene& scene) {
  if (scene.compare.reference.empty() || is_exact_reference(scene.compare.reference)) return {};
  return read_reference(find_bundled("reference", scene.compare.reference + ".toml"));
}

/// Quantities, and in words what they are held against.
struct Judged {
  std::string reference;
  std::vector<ComparedQuantity> quantities;
};

/// The frames at compare.times, or the last one, against the exact solution of the scene.
Judged compare_with_exact(const ResultFolder& folder) {
  const PlottedResult result = open_result(folder.path);
  if (result.times.empty()) throw InputError(fmt::format("the result in '{}' has no frames", folder.path.string()));
  std::vector<std::size_t> frames;
  if (!result.scene) throw InputError(fmt::format("the folder '{}' lacks its run.json", folder.path.string()));
  const Scene& scene = *result.scene;
  for (const double time : scene.compare.times) frames.push_back(frame_at(result.times, time, result.label));
  if (frames.empty()) frames = {result.times.size() - 1};
  std::sort(frames.begin(), frames.end());
  std::vector<double> times;
  for (const std::size_t frame : frames) times.push_back(result.times[frame]);
  const SceneReference reference(scene, times, strain_measure_of(scene));
  Judged judged{reference.description(), {}};
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto quantities = compare_waves(result.frame(frames[i]), reference, i, scene.discretisation.spacing);
    judged.quantities.insert(judged.quantities.end(), quantities.begin(), quantities.end());
  }
  return judged;
}

/// The exact solution where the scene asks for it, or asks for nothing and has one; else the reference file.
Judged judge(const ResultFolder& folder, const Result& result) {
  const Scene& scene = result.scene;
  Judged judged;
  if (is_exact_reference(scene.compare.reference)) {
    judged = compare_with_exact(folder);
  } else if (scene.compare.reference.empty() && scene.domain.dimension == 1) {
    try {
      judged = compare_with_exact(folder);
    } catch (const Error& error) {
      judged.reference = fmt::format("none; {}", error.what());
    }
  }
  const Reference reference = reference_of(scene);
  if (judged.reference.empty()) judged.reference = reference.title.empty() ? "none" : reference.title;
  const auto of_run = compare(result, reference, {});
  judged.quantities.insert(judged.quantities.end(), of_run.begin(), of_run.end());
  set_tolerances(judged.quantities, scene.compare.tolerance);
  return judged;
}

std::string percent(double share) {
  if (std::isnan(share)) return "-";
  const double value = 100.0 * share;
  return std::abs(value) < 0.01 && value != 0.0 ? fmt::format("{:+.1e} %", value) : fmt::format("{:+.2f} %", value);
}

std::string verdict(const ComparedQuantity& quantity) {
  if (!quantity.allowed) return "-";
  return quantity.within() ? "fine" : "OUTSIDE";
}

void print_heading(const Provenance& run, const std::string& reference) {
  fmt::print("{}, {} particles, t = {:.6g} s\n", run.title, run.particles, run.time);
  fmt::print("cost: {} steps, {:.1f} s with {} threads, {:.3g} particle-steps per second\n", run.steps - run.first_step,
             run.wall_time, run.threads, run.particle_steps_per_second);
  fmt::print("reference: {}\n", reference);
}

std::string number_or_none(double value) { return std::isnan(value) ? "none" : fmt::format("{:.5g}", value); }

TableRow row_of(const ComparedQuantity& quantity) {
  const bool counted = quantity.unit == "spacing";  // not a share of anything
  std::string allowed = "-";
  if (quantity.allowed)
    allowed = counted ? fmt::format("{:.4g}", *quantity.allowed) : fmt::format("{:.4g} %", 100.0 * *quantity.allowed);
  return {quantity.name,
          quantity.unit.empty() ? "-" : quantity.unit,
          number_or_none(quantity.value),
          quantity.reference ? fmt::format("{:.5g}", *quantity.reference) : "-",
          quantity.uncertainty > 0.0 ? fmt::format("{:.2g}", quantity.uncertainty) : "-",
          counted ? "-" : percent(quantity.deviation),
          allowed,
          verdict(quantity)};
}

/// A table for each time; the one without a time is that of the whole run.
void print_quantities(const std::vector<ComparedQuantity>& quantities) {
  const TableRow heading = {"quantity", "unit", "this run", "reference", "+-", "deviation", "allowed", "verdict"};
  for (std::size_t i = 0; i < quantities.size();) {
    const auto time = quantities[i].time;
    fmt::print("{}", time ? fmt::format("\nat {:.6g} s\n", *time) : "\n");
    std::vector<TableRow> rows = {heading};
    for (; i < quantities.size() && quantities[i].time == time; ++i) rows.push_back(row_of(quantities[i]));
    print_table(rows, "llrrrrrl");
  }
}

void print_energies(const History& history) {
  const auto& total = required_column(history, "total_energy");
  double largest = *std::max_element(total.begin(), total.end());
  // What falls from rest has no energy in total.
  if (const HistoryColumn* potential = history.find("potential_energy"))
    for (const double energy : potential->values) largest = std::max(largest, std::abs(energy));
  const std::string& unit = history.find("total_energy")->unit;
  std::vector<TableRow> rows = {{"energy", "start " + unit, "end " + unit, "of the largest"}};
  for (const auto& part : energy_parts(history))
    rows.push_back(
        {part.name, fmt::format("{:.6g}", part.start), fmt::format("{:.6g}", part.end), percent(part.end / largest)});
  fmt::print("\n");
  print_table(rows, "lrrr");
}

std::string optional_text(const std::optional<double>& number) { return number ? fmt::format("{}", *number) : ""; }

void write_csv(const std::filesystem::path& path, const std::vector<ComparedQuantity>& quantities) {
  std::string text = "quantity,unit,value,reference,uncertainty,deviation,allowed,within,time\n";
  for (const auto& quantity : quantities)
    text += fmt::format("{},{},{},{},{},{},{},{},{}\n", quantity.name, quantity.unit, quantity.value,
                        optional_text(quantity.reference), quantity.uncertainty, quantity.deviation,
                        optional_text(quantity.allowed), quantity.within(), optional_text(quantity.time));
  write_text_atomically(path, text);
}

}  // namespace

int execute_compare(const Arguments& arguments) {
  Usage usage{
      "anvil compare RESULT [--csv FILE]",
      "Compares frames and history of a result with the reference of its scene: a bundled one, or the exact solution "
      "of\nplane waves at the times in compare.times. The exit code is 4 when a quantity deviates by more than "
      "[compare] tolerance of the scene allows; the others are reported.",
      "RESULT"};
  usage.options.add_options()("csv", boost::program_options::value<std::string>()->value_name("FILE"),
                              "write the table to a CSV file, with all digits");
  const auto values = parse(usage, arguments);
  if (!values) return 0;
  const ResultFolder folder{required(*values, usage, "RESULT")};
  const Provenance run = read_provenance(folder.provenance());
  if (run.status != "finished")
    throw InputError(
        fmt::format("the run in '{}' is not finished: {} {}", folder.path.string(), run.status, run.reason));
  const Result result = read_result(folder, run);
  const auto [reference, quantities] = judge(folder, result);
  print_heading(run, reference);
  print_quantities(quantities);
  print_energies(result.history);
  if (values->count("csv") != 0) write_csv((*values)["csv"].as<std::string>(), quantities);
  const bool within = std::all_of(quantities.begin(), quantities.end(), [](const auto& q) { return q.within(); });
  return static_cast<int>(within ? ExitCode::success : ExitCode::outside_tolerance);
}

}  // namespace anvil
