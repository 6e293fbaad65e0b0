// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/comparison.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "anvil/core/data_path.hpp"
#include "anvil/core/error.hpp"
#include "anvil/measures/balance.hpp"
#include "anvil/output/atomic_file.hpp"
#include "anvil/output/provenance.hpp"
#include "anvil/output/result_folder.hpp"
#include "anvil/scene/reader.hpp"
#include "command_line.hpp"
#include "frames.hpp"
#include "table.hpp"

namespace anvil {
namespace {

Result read_result(const ResultFolder& folder, const Provenance& run) {
  return {read_scene_text(run.scene_text, run.scene_name), read_any_frame(folder.last_frame()),
          read_history(folder.history())};
}

Reference reference_of(const Scene& scene) {
  if (scene.compare.reference.empty()) return {};
  return read_reference(find_bundled("reference", scene.compare.reference + ".toml"));
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

void print_heading(const Provenance& run, const Reference& reference) {
  fmt::print("{}, {} particles, t = {:.6g} s\n", run.title, run.particles, run.time);
  fmt::print("cost: {} steps, {:.1f} s with {} threads, {:.3g} particle-steps per second\n", run.steps - run.first_step,
             run.wall_time, run.threads, run.particle_steps_per_second);
  fmt::print("reference: {}\n\n", reference.title.empty() ? "none" : reference.title);
}

void print_quantities(const std::vector<ComparedQuantity>& quantities) {
  std::vector<TableRow> rows = {{"quantity", "unit", "this run", "reference", "+-", "deviation", "allowed", "verdict"}};
  for (const auto& quantity : quantities)
    rows.push_back({quantity.name, quantity.unit.empty() ? "-" : quantity.unit,
                    std::isnan(quantity.value) ? "none" : fmt::format("{:.5g}", quantity.value),
                    quantity.reference ? fmt::format("{:.5g}", *quantity.reference) : "-",
                    quantity.reference ? fmt::format("{:.2g}", quantity.uncertainty) : "-",
                    quantity.unit == "spacing" ? "-" : percent(quantity.deviation),
                    quantity.allowed ? fmt::format("{:.4g} %", 100.0 * *quantity.allowed) : "-", verdict(quantity)});
  print_table(rows, "llrrrrrl");
}

void print_energies(const History& history) {
  const double start = required_column(history, "total_energy").front();
  std::vector<TableRow> rows = {{"energy", "start J", "end J", "of the start"}};
  for (const auto& part : energy_parts(history))
    rows.push_back(
        {part.name, fmt::format("{:.6g}", part.start), fmt::format("{:.6g}", part.end), percent(part.end / start)});
  fmt::print("\n");
  print_table(rows, "lrrr");
}

std::string optional_text(const std::optional<double>& number) { return number ? fmt::format("{}", *number) : ""; }

void write_csv(const std::filesystem::path& path, const std::vector<ComparedQuantity>& quantities) {
  std::string text = "quantity,unit,value,reference,uncertainty,deviation,allowed,within\n";
  for (const auto& quantity : quantities)
    text += fmt::format("{},{},{},{},{},{},{},{}\n", quantity.name, quantity.unit, quantity.value,
                        optional_text(quantity.reference), quantity.uncertainty, quantity.deviation,
                        optional_text(quantity.allowed), quantity.within());
  write_text_atomically(path, text);
}

}  // namespace

int execute_compare(const Arguments& arguments) {
  Usage usage{
      "anvil compare RESULT [--csv FILE]",
      "Compares the last frame and the history of a result with the reference of its scene. The exit code is 4 "
      "when a\nquantity deviates by more than [compare] tolerance of the scene allows; the others are reported.",
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
  const Reference reference = reference_of(result.scene);
  const auto quantities = compare(result, reference, result.scene.compare.tolerance);
  print_heading(run, reference);
  print_quantities(quantities);
  print_energies(result.history);
  if (values->count("csv") != 0) write_csv((*values)["csv"].as<std::string>(), quantities);
  const bool within = std::all_of(quantities.begin(), quantities.end(), [](const auto& q) { return q.within(); });
  return static_cast<int>(within ? ExitCode::success : ExitCode::outside_tolerance);
}

}  // namespace anvil
