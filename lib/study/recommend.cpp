// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/study/recommend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "anvil/core/data_path.hpp"
#include "anvil/core/error.hpp"
#include "anvil/scene/reader.hpp"
#include "anvil/scene/shape.hpp"
#include "anvil/solver/simulation.hpp"
#include "anvil/study/cost.hpp"

namespace anvil {
namespace {

constexpr const char* spacing_key = "discretisation.spacing";

std::set<std::string> kinds_of(const std::vector<BoundaryDescription>& boundaries) {
  std::set<std::string> kinds;
  for (const auto& boundary : boundaries) kinds.insert(boundary.entry.type);
  return kinds;
}

std::set<std::string> laws_of(const std::vector<MaterialDescription>& materials) {
  std::set<std::string> laws;
  for (const auto& material : materials) laws.insert(material.eos.type + " " + material.strength.type);
  return laws;
}

/// The largest speed at the start, m/s, and the largest pressure on a face, Pa.
std::pair<double, double> drives_of(const Scene& scene) {
  double speed = 0.0, pressure = 0.0;
  for (const auto& body : scene.bodies) {
    speed = std::max(speed, std::abs(body.radial_velocity));
    for (const double component : body.velocity) speed = std::max(speed, std::abs(component));
  }
  for (const auto& boundary : scene.boundaries)
    if (boundary.entry.parameters.has("value"))
      pressure = std::max(pressure, std::abs(boundary.entry.parameters.number("value")));
  return {speed, pressure};
}

bool alike(double a, double b) { return a == b || (a < 2.0 * b && b < 2.0 * a); }

template <int D>
double longest_side(const Scene& scene) {
  Vec<D> low = Vec<D>::Constant(std::numeric_limits<double>::max()), high = -low;
  for (const auto& body : scene.bodies) {
    const auto shape = make_shape<D>(body.shape);
    low = low.cwiseMin(shape->centre() - 0.5 * shape->size());
    high = high.cwiseMax(shape->centre() + 0.5 * shape->size());
  }
  return (high - low).maxCoeff();
}

double longest_side_of(const Scene& scene) {
  if (scene.domain.dimension == 1) return longest_side<1>(scene);
  return scene.domain.dimension == 2 ? longest_side<2>(scene) : longest_side<3>(scene);
}

std::vector<std::string> settings_of(const StudyGrid& grid, const StudyRun& run) {
  std::vector<std::string> settings = grid.set;
  for (std::size_t axis = 0; axis < grid.axes.size(); ++axis)
    settings.push_back(fmt::format("{}={}", grid.axes[axis].key, run.axis_values[axis]));
  return settings;
}

/// A run of a record that could serve.
struct Candidate {
  const StudyRecord* record;
  std::size_t grid;
  const CostPoint* point;
  double error;
  double seconds;  // CPU time, as the record has it
};

/// All measured points of all records that are as near as the nearest, with the points they refer to.
struct Near {
  Nearness nearness = Nearness::none;
  std::vector<std::vector<CostPoint>> points;  // of each record
  std::vector<Candidate> candidates;
};

std::size_t measure_place(const StudyRecord& record, const Wish& wish) {
  const auto& measures = record.study.grids.front().measures;
  return wish.measure.empty() ? 0
                              : static_cast<std::size_t>(std::ranges::find(measures, wish.measure) - measures.begin());
}

Near near_to(const Scene& asked, const Wish& wish, const std::vector<StudyRecord>& records) {
  Near found;
  for (const auto& record : records) found.points.push_back(cost_points(record.study, record.runs));
  for (std::size_t r = 0; r < records.size(); ++r) {
    const StudyRecord& record = records[r];
    const std::size_t measure = measure_place(record, wish);
    if (measure == record.study.grids.front().measures.size()) continue;
    for (std::size_t grid = 0; grid < record.study.grids.size(); ++grid) {
      if (has_threads_axis(record.study.grids[grid])) continue;  // its times are not those of one thread
      const Nearness here = nearness(asked, read_scene(locate_scene(record.study.grids[grid].scene)));
      if (here == Nearness::none || here < found.nearness) continue;
      if (here > found.nearness) found.candidates.clear();
      found.nearness = here;
      for (const auto& point : found.points[r])
        if (record.runs[point.run].grid == grid)
          found.candidates.push_back({&record, grid, &point, point.kept_errors[measure], point.seconds});
    }
  }
  return found;
}

/// The settings of a candidate for the scene that is asked about.
std::vector<std::string> settings_for(const Candidate& candidate, const Scene& asked, Nearness near) {
  const StudyGrid& grid = candidate.record->study.grids[candidate.grid];
  auto settings = settings_of(grid, candidate.record->runs[candidate.point->run]);
  if (near == Nearness::same) return settings;
  const double ratio = longest_side_of(asked) / longest_side_of(read_scene(locate_scene(grid.scene)));
  for (auto& setting : settings)
    if (setting.starts_with(std::string(spacing_key) + "="))
      setting = fmt::format("{}={:.10g}", spacing_key, ratio * std::stod(setting.substr(setting.find('=') + 1)));
  return settings;
}

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

Explanation explanation_of(const Scene& scene) { return make_simulation(scene)->explain(); }

/// Particles and steps of a scene of the same kind: its own particles, and steps in the proportion of the first ones.
void scale_cost(const Candidate& candidate, const Scene& scene, Recommendation& result) {
  const StudyGrid& grid = candidate.record->study.grids[candidate.grid];
  const StudyRun& run = candidate.record->runs[candidate.point->run];
  result.particles = static_cast<double>(run.particles);
  result.steps = static_cast<double>(run.steps);
  result.seconds = run.cpu_seconds;
  if (result.rests_on == Nearness::same) return;
  const Explanation own = explanation_of(scene);
  const Explanation measured = explanation_of(read_scene(locate_scene(grid.scene), settings_of(grid, run)));
  result.steps *= static_cast<double>(own.steps_expected) / static_cast<double>(measured.steps_expected);
  result.particles = static_cast<double>(own.particles);
  result.seconds *= result.steps * result.particles / candidate.point->particle_steps;
}

std::string unreachable(const Wish& wish, const std::vector<Candidate>& candidates) {
  const auto accurate = std::ranges::min_element(candidates, {}, &Candidate::error);
  const auto fast = std::ranges::min_element(candidates, {}, &Candidate::seconds);
  const auto settings = [](const Candidate& candidate) {
    return fmt::format("{}, {}", candidate.point->curve, candidate.point->name);
  };
  if (wish.error)
    return fmt::format(
        "no measured run reaches an error of {:.3g} %; the most accurate one has {:.3g} % ({}). A finer run would have "
        "to be measured: add its spacing to the study {} and give its study.json by --from",
        100.0 * *wish.error, 100.0 * accurate->error, settings(*accurate), accurate->record->study.name);
  return fmt::format("no measured run takes less than {:.3g} s of CPU time; the shortest took {:.3g} s ({})",
                     *wish.seconds, fast->seconds, settings(*fast));
}

}  // namespace

Nearness nearness(const Scene& asked, const Scene& measured) {
  if (asked.domain == measured.domain && asked.bodies == measured.bodies && asked.materials == measured.materials &&
      asked.boundaries == measured.boundaries && asked.time.end == measured.time.end)
    return Nearness::same;
  const auto [speed, pressure] = drives_of(asked);
  const auto [measured_speed, measured_pressure] = drives_of(measured);
  const bool kind = asked.domain.dimension == measured.domain.dimension &&
                    asked.domain.strain_state == measured.domain.strain_state &&
                    asked.bodies.size() == measured.bodies.size() &&
                    asked.bodies.front().shape.type == measured.bodies.front().shape.type &&
                    kinds_of(asked.boundaries) == kinds_of(measured.boundaries) &&
                    laws_of(asked.materials) == laws_of(measured.materials) && alike(speed, measured_speed) &&
                    alike(pressure, measured_pressure);
  return kind ? Nearness::kind : Nearness::none;
}

double machine_ratio(const StudyRecord& record, std::size_t grid) {
  constexpr double longest = 0.5;  // s
  const StudyRun* chosen = nullptr;
  for (const auto& run : record.runs)
    if (run.grid == grid && run.status == StudyStatus::finished && run.cpu_seconds < longest &&
        (chosen == nullptr || run.cpu_seconds > chosen->cpu_seconds))
      chosen = &run;
  if (chosen == nullptr)
    throw InputError(fmt::format("the record '{}' has no run of less than {} s to measure this machine by",
                                 record.study.name, longest));
  StudyDescription once;
  once.grids = {record.study.grids[grid]};
  for (std::size_t axis = 0; axis < once.grids[0].axes.size(); ++axis)
    once.grids[0].axes[axis].values = {chosen->axis_values[axis]};
  // Only the time of the steps is of interest.
  once.grids[0].measures.clear();
  auto runs = prepare_study(once, {});
  run_study(once, runs, 1, [](const StudyPosition&) {});
  if (runs[0].status != StudyStatus::finished) throw InputError(runs[0].reason);
  return runs[0].cpu_seconds / chosen->cpu_seconds;
}

Recommendation recommend(const std::string& scene, const std::vector<std::string>& set, const Wish& wish,
                         const std::vector<StudyRecord>& records) {
  const auto file = locate_scene(scene);
  const Scene asked = read_scene(file, set);
  const Near near = near_to(asked, wish, records);
  if (near.candidates.empty())
    throw InputError(fmt::format(
        "nothing has been measured near '{}'{}: run a study of it with report = \"cost\" (docs/studies.md) and give "
        "its study.json by --from",
        scene, wish.measure.empty() ? "" : fmt::format(" by {}", wish.measure)));
  auto ordered = near.candidates;
  if (wish.error)
    std::ranges::sort(ordered, {}, &Candidate::seconds);
  else
    std::ranges::sort(ordered, {}, &Candidate::error);
  std::map<std::pair<const StudyRecord*, std::size_t>, double> ratios;
  for (const auto& candidate : ordered) {
    if (wish.error && candidate.error > *wish.error) continue;
    Recommendation result;
    result.rests_on = near.nearness;
    result.settings = settings_for(candidate, asked, near.nearness);
    Scene own;
    try {
      own = read_scene(file, joined(set, result.settings));
    } catch (const InputError&) {
      continue;  // a spacing that does not divide this scene's bodies
    }
    scale_cost(candidate, own, result);
    // A budget is refused by the record alone where no machine would be fast enough, and measured where it matters.
    constexpr double fastest_machine = 0.1;
    if (wish.seconds && fastest_machine * result.seconds > *wish.seconds) continue;
    const StudyGrid& grid = candidate.record->study.grids[candidate.grid];
    double& ratio = ratios[{candidate.record, candidate.grid}];
    if (ratio == 0.0) ratio = machine_ratio(*candidate.record, candidate.grid);
    result.machine_ratio = ratio;
    result.seconds *= result.machine_ratio;
    if (wish.seconds && result.seconds > *wish.seconds) continue;
    result.study = candidate.record->study.name;
    result.measured_scene = grid.scene;
    result.measure = grid.measures[measure_place(*candidate.record, wish)];
    result.times = grid.times;
    result.points = near.candidates.size();
    result.error = candidate.error;
    return result;
  }
  throw InputError(unreachable(wish, near.candidates));
}

std::vector<StudyRecord> bundled_study_records() {
  std::vector<StudyRecord> records;
  for (const auto& file : list_bundled("fronts", ".json"))
    records.push_back(read_study_record(find_bundled("fronts", file)));
  return records;
}

}  // namespace anvil
