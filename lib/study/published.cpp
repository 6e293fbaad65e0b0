// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/study/published.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <vector>

#include "anvil/core/data_path.hpp"
#include "anvil/core/error.hpp"
#include "anvil/exact/scene_reference.hpp"
#include "anvil/measures/comparison.hpp"
#include "anvil/measures/measures.hpp"
#include "anvil/scene/nearest_name.hpp"

namespace anvil {
namespace {

constexpr std::string_view deviation_prefix = "deviation.";
constexpr std::string_view profile_suffix = "_profile_l2";

Result result_of(const StudySample& sample) { return {sample.scene, sample.frames[sample.number], sample.history}; }

double quantity(const StudySample& sample, std::string_view name) { return find_measure(name)->of(result_of(sample)); }

double deviation(const StudySample& sample, std::string_view name) {
  const std::string& file = sample.scene.compare.reference;
  if (file.empty() || is_exact_reference(file))
    throw InputError(fmt::format("'{}' needs a scene whose compare.reference names a table of data/reference", name));
  name.remove_prefix(deviation_prefix.size());
  const auto quantities =
      compare(result_of(sample), read_reference(find_bundled("reference", file + ".toml")), NamedNumbers{});
  std::vector<std::string_view> names;
  for (const auto& compared : quantities) {
    if (compared.name == name) return std::abs(compared.deviation);
    names.push_back(compared.name);
  }
  throw InputError(fmt::format("the reference '{}' has no '{}'{}", file, name, suggestion(name, names)));
}

bool is_compared(std::string_view name) {
  if (find_measure(name) != nullptr) return true;
  if (!name.ends_with(profile_suffix)) return false;
  name.remove_suffix(profile_suffix.size());
  return find_profile_measure(name) != nullptr;
}

}  // namespace

std::optional<StudyMeasure> find_compared_measure(std::string_view name) {
  if (name.starts_with(deviation_prefix)) {
    if (is_compared(name.substr(deviation_prefix.size()))) return StudyMeasure{name, "", deviation};
  } else if (const Measure* found = find_measure(name)) {
    return StudyMeasure{found->name, found->unit, quantity};
  }
  return std::nullopt;
}

bool reads_history(std::string_view name) {
  const auto measure = find_compared_measure(name);
  return measure && (measure->of == deviation || measure->of == quantity);
}

}  // namespace anvil
