// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/study/axis_labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "anvil/scene/schema.hpp"
#include "anvil/study/measures.hpp"

namespace anvil {
namespace {

/// Measures whose names leave open what they are relative to.
constexpr std::array<std::pair<std::string_view, std::string_view>, 15> relative_measures = {{
    {"stress_l1", "Mean error of stress / peak stress"},
    {"stress_l2", "RMS error of stress / peak stress"},
    {"velocity_l1", "Mean error of velocity / peak velocity"},
    {"velocity_l2", "RMS error of velocity / peak velocity"},
    {"stress_overshoot", "Overshoot of stress / peak stress"},
    {"reference_error", "Error of the exact solution / peak stress"},
    {"plateau_error", "Largest relative error of a plateau"},
    {"precursor_error", "Relative error at the elastic limit"},
    {"elastic_speed_ratio", "Elastic wave speed / exact speed"},
    {"plastic_speed_ratio", "Plastic wave speed / exact speed"},
    {"lattice_factor", "Slope on the lattice / exact slope"},
    {"poiseuille_error", "Largest error of velocity / greatest velocity"},
    {"energy_growth", "Growth of energy / energy at the start"},
    {"shell_circularity", "Spread of the inner radius / its mean"},
    {"deviation.half_width_profile_l2", "RMS deviation of the side profile / its width"},
}};

std::string in_words(std::string_view name) {
  std::string words(name);
  std::ranges::replace(words, '_', ' ');
  if (!words.empty()) words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words;
}

std::string with_bracket(const std::string& words, std::string_view unit) {
  if (unit.empty()) return words;
  return fmt::format("{} [{}]", words, unit == "us" ? "µs" : unit);
}

}  // namespace

std::string measure_label(const std::string& measure) {
  for (const auto& [name, label] : relative_measures)
    if (measure == name) return std::string(label);
  constexpr std::string_view deviation = "deviation.";
  if (measure.starts_with(deviation)) {
    std::string quantity = measure.substr(deviation.size());
    std::ranges::replace(quantity, '_', ' ');
    return "Relative deviation of " + quantity;
  }
  const auto found = find_study_measure(measure);
  return with_bracket(in_words(measure), found ? found->unit : "");
}

std::string key_label(const std::string& key) {
  for (const auto& section : scene_sections())
    for (const Key* known : section.keys)
      if (key == fmt::format("{}.{}", section.name, known->name))
        return with_bracket(in_words(known->name), known->unit);
  return in_words(key.substr(key.rfind('.') + 1));
}

}  // namespace anvil
