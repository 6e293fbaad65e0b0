// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/exact/scene_reference.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

/// When the stress between the bodies and a wall becomes tension first, to a two-hundredth of `end`; nothing when it
/// does not. `problem` is that of small strain, where fronts stay few, and they are followed coarsely: what counts is
/// the big wave that comes back.
std::optional<double> leaves_wall(const PlateProblem& problem, double end) {
  if (!problem.left_face.rigid && !problem.right_face.rigid) return std::nullopt;
  constexpr int samples = 200;
  constexpr double tension = 1e-2;  // of the stress scale, above what coarse fronts leave behind
  FrontTracking fronts(problem, end, {.step = 1.0 / 32.0, .smallest = 1e-3, .most_events = 1'000'000});
  for (int i = 1; i <= samples; ++i) {
    const double time = end * i / samples;
    fronts.advance_to(time);
    const WaveProfile profile = fronts.profile();
    const bool left = problem.left_face.rigid && profile.zones.front().state.stress > tension * problem.stress_scale();
    const bool right = problem.right_face.rigid && profile.zones.back().state.stress > tension * problem.stress_scale();
    if (left || right) return time;
  }
  return std::nullopt;
}

void check_walls(const PlateProblem& problem, double end) {
  if (const auto time = leaves_wall(problem, end))
    throw InputError(
        fmt::format("there is no exact solution of this scene at {:.6g} s: the bodies leave the wall at about {:.3g} s",
                    end, *time));
}

/// Elastic waves hardly spread and are never split by yield: few fronts are enough, and are followed further down.
TrackingAccuracy accuracy_for(bool elastic) {
  return elastic ? TrackingAccuracy{.step = 1.0 / 128.0, .smallest = 1e-6, .most_events = 300'000} : reference_accuracy;
}

}  // namespace

bool is_exact_reference(std::string_view name) {
  return name == exact_reference || name == exact_small_strain_reference;
}

StrainMeasure strain_measure_of(const Scene& scene) {
  return scene.compare.reference == exact_small_strain_reference ? StrainMeasure::small : StrainMeasure::finite;
}

SceneReference::SceneReference(const Scene& scene, std::vector<double> times, StrainMeasure measure)
    : problem_(plate_problem(scene, measure)),
      rod_(scene.domain.strain_state == "uniaxial_stress"),
      times_(std::move(times)) {
  if (times_.empty() || !std::is_sorted(times_.begin(), times_.end()) || times_.front() < 0.0)
    throw InputError("the times of an exact solution begin at 0 or later and ascend");
  const bool elastic = is_elastic(scene);
  check_walls(plate_problem(scene, StrainMeasure::small), times_.back());
  const bool small = rod_ || measure == StrainMeasure::small;
  if (small && elastic) {
    layered_.emplace(problem_, times_.back());
    description_ = "exact, small strain (d'Alembert)";
    return;
  }
  tracked_ = solve_plate(problem_, times_, accuracy_for(elastic));
  const double error = *std::max_element(tracked_.relative_errors.begin(), tracked_.relative_errors.end());
  const std::string quality = error > 1e-12 ? fmt::format("error {:.1e} of the mean stress", error) : "to round-off";
  description_ = fmt::format("exact, {} strain (front tracking, {})", small ? "small" : "finite", quality);
}

double SceneReference::relative_error(std::size_t time) const {
  return layered_ ? 0.0 : tracked_.relative_errors.at(time);
}

ExactPoint SceneReference::point_of(double position, const WaveState& state, double reference_density) const {
  ExactPoint point{.initial_position = position, .stress = state.stress, .velocity = state.velocity};
  if (rod_) {  // its state knows nothing of the lateral directions; they are free of stress
    point.pressure = -state.stress / 3.0;
    point.deviator = state.stress + point.pressure;
    return point;
  }
  point.density = reference_density / (1.0 + state.strain);
  point.pressure = state.pressure();
  point.deviator = state.deviator;
  point.energy = state.energy;
  return point;
}

ExactPoint SceneReference::at(std::size_t time, double position) const {
  if (!layered_) {
    const WaveProfile& profile = tracked_.profiles.at(time);
    return point_of(position, profile.state_at(position), profile.zone_at(position).reference_density);
  }
  position = std::clamp(position, begin(), end());
  const LayeredPlate::Point point = layered_->at(position, times_.at(time));
  std::size_t layer = 0;
  for (double edge = begin() + problem_.layers[0].thickness; position >= edge && layer + 1 < problem_.layers.size();)
    edge += problem_.layers[++layer].thickness;
  const WaveMaterial& material = problem_.layers[layer].material;
  WaveState state = material.behind_front(material.rest(), point.stress / material.elastic_modulus());
  state.velocity = point.velocity;
  return point_of(position, state, material.density());
}

std::vector<ExactPoint> SceneReference::line(std::size_t time) const {
  std::vector<ExactPoint> points;
  if (!layered_) {
    const WaveProfile& profile = tracked_.profiles.at(time);
    double reach = 0.0;  // of the joint before
    for (std::size_t k = 0; k < profile.zones.size(); ++k) {
      const WaveZone& zone = profile.zones[k];
      const double begin = zone.begin + std::exchange(reach, profile.smooth_reach(k)), end = zone.end - reach;
      for (const double position : {begin, std::max(begin, end)})
        points.push_back(point_of(position, zone.state, zone.reference_density));
    }
    return points;
  }
  constexpr int samples = 4000;  // a front is then drawn thinner than any line
  for (int i = 0; i <= samples; ++i) points.push_back(at(time, begin() + (end() - begin()) * i / samples));
  return points;
}

}  // namespace anvil
