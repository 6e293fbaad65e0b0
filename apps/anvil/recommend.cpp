// SPDX-License-Identifier: BSD-3-Clause
#include "recommend.hpp"

#include <fmt/format.h>

#include <charconv>

#include "anvil/core/error.hpp"
#include "command_line.hpp"

namespace anvil {
namespace {

namespace po = boost::program_options;

/// A number and what stands behind it.
std::pair<double, std::string> number_and_unit(const std::string& option, const std::string& text,
                                               const std::string& example) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [next, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || !(number > 0.0))
    throw InputError(fmt::format("--{} takes {}, found '{}'", option, example, text));
  return {number, std::string(next, end)};
}

double share_from(const std::string& text) {
  const std::string example = "a share such as 2% or 0.02";
  const auto [number, unit] = number_and_unit("error", text, example);
  if (unit == "%") return number / 100.0;
  if (unit.empty()) return number;
  throw InputError(fmt::format("--error takes {}, found '{}'", example, text));
}

double seconds_from(const std::string& text) {
  const std::string example = "a time such as 30s, 5min or 1h";
  const auto [number, unit] = number_and_unit("budget", text, example);
  if (unit == "s" || unit.empty()) return number;
  if (unit == "min") return 60.0 * number;
  if (unit == "h") return 3600.0 * number;
  throw InputError(fmt::format("--budget takes {}, found '{}'", example, text));
}

void refuse_chosen_keys(const Recommendation& recommendation, const std::vector<std::string>& set) {
  for (const auto& text : set)
    for (const auto& setting : recommendation.settings)
      if (text.substr(0, text.find('=')) == setting.substr(0, setting.find('=')))
        throw InputError(fmt::format("--set {} cannot go with --error or --budget, which choose that key", text));
}

std::string times_text(const std::vector<double>& times) {
  if (times.size() == 1) return fmt::format("at {:.4g} s", times[0]);
  return fmt::format("mean over {:.4g} s", fmt::join(times, ", "));
}

}  // namespace

void add_wish_options(po::options_description& options) {
  auto add = options.add_options();
  add("error", po::value<std::string>()->value_name("SHARE"), "the cheapest settings that reach this error, e.g. 2%");
  add("budget", po::value<std::string>()->value_name("TIME"),
      "the most accurate settings within this CPU time on one thread, e.g. 30s");
  add("measure", po::value<std::string>()->value_name("NAME"), "what the error is of (default: the record's first)");
  add("from", po::value<std::vector<std::string>>()->composing()->value_name("FILE"),
      "study.json of a study of your own, instead of those that come with anvil");
}

std::optional<Recommendation> recommendation_of(const po::variables_map& values, const std::string& scene,
                                                const std::vector<std::string>& set) {
  const bool by_error = values.count("error") != 0, by_budget = values.count("budget") != 0;
  if (!by_error && !by_budget) return std::nullopt;
  if (by_error && by_budget) throw InputError("give --error or --budget, not both");
  Wish wish;
  if (by_error) wish.error = share_from(values["error"].as<std::string>());
  if (by_budget) wish.seconds = seconds_from(values["budget"].as<std::string>());
  if (values.count("measure") != 0) wish.measure = values["measure"].as<std::string>();
  std::vector<StudyRecord> records;
  for (const auto& file : repeated(values, "from")) records.push_back(read_study_record(file));
  if (records.empty()) records = bundled_study_records();
  const Recommendation recommendation = recommend(scene, set, wish, records);
  refuse_chosen_keys(recommendation, set);
  return recommendation;
}

std::string describe(const Recommendation& r) {
  std::string text =
      fmt::format("expected    error {:.2g} % ({}, {})\n", 100.0 * r.error, r.measure, times_text(r.times));
  text += fmt::format(
      "cost        {:.2g} s of CPU time on one thread, {:.3g} particle-steps: {:.0f} particles, {:.0f} steps\n",
      r.seconds, r.particles * r.steps, r.particles, r.steps);
  text += fmt::format(
      "rests on    {} measured runs of {} in the study {}{}; this machine now takes {:.2f} times as long\n", r.points,
      r.measured_scene, r.study,
      r.rests_on == Nearness::same ? "" : ", a scene of the same kind, scaled to this one's size", r.machine_ratio);
  return text;
}

int execute_recommend(const Arguments& arguments) {
  Usage usage{
      "anvil recommend SCENE --error SHARE\n       anvil recommend SCENE --budget TIME",
      "Says with which settings a scene reaches an error at the least cost, or how accurate it can be within a\n"
      "time, from runs that have been measured, scaled by the speed of this machine, which a short run measures.\n"
      "Refuses where nothing near has been measured. `anvil run SCENE --error SHARE` takes the settings at once.",
      "SCENE"};
  add_wish_options(usage.options);
  add_scene_options(usage);
  const auto values = parse(usage, arguments);
  if (!values) return 0;
  const std::string scene = required(*values, usage, "SCENE");
  const auto set = repeated(*values, "set");
  const auto recommendation = recommendation_of(*values, scene, set);
  if (!recommendation) throw InputError("give --error SHARE or --budget TIME");
  fmt::print("{}", describe(*recommendation));
  std::string command = "anvil run " + scene;
  for (const auto& setting : set) command += fmt::format(" --set '{}'", setting);
  for (const auto& setting : recommendation->settings) command += fmt::format(" --set '{}'", setting);
  fmt::print("run it by   {}\n", command);
  return 0;
}

}  // namespace anvil
