// SPDX-License-Identifier: BSD-3-Clause
#include "robustness/extremes/extreme_case.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <ostream>
#include <stdexcept>

namespace anvil {
namespace {

std::string text_of(const toml::table& row, const char* key, bool required) {
  const auto text = row[key].value<std::string>();
  if (required && !text) throw std::runtime_error(fmt::format("a case of cases.toml lacks '{}'", key));
  return text.value_or("");
}

std::vector<std::string> texts_of(const toml::table& row, const char* key) {
  std::vector<std::string> texts;
  if (const auto* list = row[key].as_array())
    for (const auto& item : *list) texts.push_back(item.value<std::string>().value());
  return texts;
}

Ending ending_of(const std::string& word) {
  if (word == "answer") return Ending::answer;
  if (word == "failure") return Ending::failure;
  if (word == "refusal") return Ending::refusal;
  throw std::runtime_error("cases.toml: no case ends in '" + word + "'");
}

std::string outcome(const ExtremeCase& extreme) {
  if (extreme.ending == Ending::refusal) return fmt::format("refused: \"{}\"", extreme.phrase);
  if (extreme.ending == Ending::failure) return fmt::format("stops, exit code 3: \"{}\"", extreme.phrase);
  std::string text;
  for (const auto& [measure, expected] : extreme.holds)
    text += fmt::format("{}`{}` {:g} ± {:.2g}", text.empty() ? "" : "; ", measure, expected.value, expected.within);
  if (extreme.scale > 0.0) text += fmt::format("{}the same bits as at scale 1", text.empty() ? "" : "; ");
  return text;
}

constexpr const char* heading = R"(# Robustness: the extremes, one by one

Made from tests/robustness/extremes/cases.toml, which holds scene, settings and expectation of every case; a test fails
when this page and the table differ. `ctest -L robustness -R extremes` runs all of them.

Every case ends in one of three ways: an answer, with its error against what it should be; exit code 3 with the reason,
and everything written before it readable; or a refusal of the scene, exit code 1, which leaves nothing behind. In
no case does a file hold what is not a number: frames, histories and checkpoints are read back and looked through.

`stress_l1`, `velocity_l1`, `plateau_error` and `stress_overshoot` are against the exact solution; `energy_balance` and
`momentum_balance` say what the audit cannot account for, relative to the largest value of the run. `max`, `min` and
`mean` go over the particles at the end, `most` and `end` over the history. Where a value is held within a
tolerance that is not zero, the reason stands in the last column.

| case | what is asked | what comes out | why |
|---|---|---|---|
)";

}  // namespace

std::ostream& operator<<(std::ostream& stream, const ExtremeCase& extreme) { return stream << extreme.name; }

std::vector<ExtremeCase> extreme_cases() {
  const toml::table file = toml::parse_file(ANVIL_SOURCE_DIR "/tests/robustness/extremes/cases.toml");
  std::vector<ExtremeCase> cases;
  for (const auto& node : *file["case"].as_array()) {
    const toml::table& row = *node.as_table();
    ExtremeCase& extreme = cases.emplace_back();
    extreme.name = text_of(row, "name", true);
    extreme.scene = text_of(row, "scene", true);
    extreme.set = texts_of(row, "set");
    extreme.ending = ending_of(text_of(row, "ends_in", true));
    extreme.phrase = text_of(row, "phrase", extreme.ending != Ending::answer);
    extreme.exact = texts_of(row, "exact");
    if (const auto* numbers = row["velocity_gradient"].as_array())
      for (const auto& number : *numbers) extreme.velocity_gradient.push_back(number.value<double>().value());
    extreme.scale = row["scale"].value_or(0.0);
    extreme.asked = text_of(row, "asked", true);
    extreme.why = text_of(row, "why", true);
    if (const auto* holds = row["holds"].as_table())
      for (const auto& [measure, pair] : *holds)
        extreme.holds[std::string(measure.str())] = {pair.as_array()->at(0).value<double>().value(),
                                                     pair.as_array()->at(1).value<double>().value()};
    if (extreme.ending == Ending::answer && extreme.holds.empty() && extreme.scale == 0.0)
      throw std::runtime_error("cases.toml: '" + extreme.name + "' has an answer and holds it against nothing");
  }
  return cases;
}

std::string robustness_page(const std::vector<ExtremeCase>& cases) {
  std::string page = heading;
  for (const auto& extreme : cases)
    page += fmt::format("| {} | {} | {} | {} |\n", extreme.name, extreme.asked, outcome(extreme), extreme.why);
  return page;
}

}  // namespace anvil
