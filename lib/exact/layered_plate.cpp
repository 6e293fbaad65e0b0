// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/exact/layered_plate.hpp"

#include <map>
#include <tuple>
#include <utility>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

double step_at_zero(double time) { return time >= 0.0 ? 1.0 : 0.0; }

}  // namespace

LayeredPlate::LayeredPlate(const PlateProblem& problem, double end)
    : left_rigid_(problem.left_face.rigid), right_rigid_(problem.right_face.rigid) {
  problem.check();
  double begin = problem.left_position;
  for (const PlateLayer& layer : problem.layers) {
    if (layer.deviator != 0.0) throw InputError("the layers of an elastic plate start without stress");
    const double speed = layer.material.elastic_wave_speed();
    layers_.push_back({begin, layer.thickness, speed, layer.material.density() * speed, layer.velocity});
    begin += layer.thickness;
  }
  const auto pull = [](const PressureHistory& pressure) {
    return [pressure](double time) { return -pressure.at(time); };
  };
  if (!left_rigid_) add_source(pull(problem.left_face.pressure), {{0, true, 1.0}}, end);
  if (!right_rigid_) add_source(pull(problem.right_face.pressure), {{layers_.size() - 1, false, 1.0}}, end);
  add_impacts(end);
}

/// Waves that start where the velocities of neighbours, or of a layer and a wall, differ at the start.
void LayeredPlate::add_impacts(double end) {
  std::vector<Entry> entries;
  const std::size_t last = layers_.size() - 1;
  if (left_rigid_) entries.push_back({0, true, layers_.front().impedance * layers_.front().velocity});
  for (std::size_t i = 0; i < last; ++i) {
    const Layer& left = layers_[i];
    const Layer& right = layers_[i + 1];
    const double stress =
        left.impedance * right.impedance / (left.impedance + right.impedance) * (right.velocity - left.velocity);
    entries.push_back({i, false, stress});
    entries.push_back({i + 1, true, stress});
  }
  if (right_rigid_) entries.push_back({last, false, -layers_[last].impedance * layers_[last].velocity});
  std::erase_if(entries, [](const Entry& entry) { return entry.amplitude == 0.0; });
  if (!entries.empty()) add_source(step_at_zero, entries, end);
}

/// What a wave of the given stress becomes when it reaches the far end of its layer.
std::vector<LayeredPlate::Entry> LayeredPlate::leave(const Entry& wave) const {
  const bool at_face = wave.layer == (wave.to_right ? layers_.size() - 1 : 0);
  if (at_face) {
    const bool rigid = wave.to_right ? right_rigid_ : left_rigid_;
    return {{wave.layer, !wave.to_right, rigid ? wave.amplitude : -wave.amplitude}};
  }
  const std::size_t beyond = wave.to_right ? wave.layer + 1 : wave.layer - 1;
  const double here = layers_[wave.layer].impedance;
  const double there = layers_[beyond].impedance;
  return {{wave.layer, !wave.to_right, wave.amplitude * (there - here) / (there + here)},
          {beyond, wave.to_right, wave.amplitude * 2.0 * there / (there + here)}};
}

void LayeredPlate::add_source(Signal signal, const std::vector<Entry>& entries, double end) {
  Source source{std::move(signal), std::vector<std::vector<Wave>>(layers_.size())};
  // Waves by layer, direction and how often each layer was crossed: the delay follows from the counts alone.
  using Key = std::tuple<std::size_t, bool, std::vector<int>>;
  std::map<Key, double> generation;
  for (const Entry& entry : entries)
    generation[{entry.layer, entry.to_right, std::vector<int>(layers_.size(), 0)}] += entry.amplitude;
  while (!generation.empty()) {
    std::map<Key, double> next;
    for (const auto& [key, amplitude] : generation) {
      const auto& [layer, to_right, crossings] = key;
      double delay = 0.0;
      for (std::size_t i = 0; i < layers_.size(); ++i)
        delay += crossings[i] * (layers_[i].thickness / layers_[i].wave_speed);
      if (delay > end || amplitude == 0.0) continue;
      source.waves[layer].push_back({to_right, delay, amplitude});
      std::vector<int> crossed = crossings;
      ++crossed[layer];
      for (const Entry& entry : leave({layer, to_right, amplitude}))
        next[{entry.layer, entry.to_right, crossed}] += entry.amplitude;
    }
    generation = std::move(next);
  }
  sources_.push_back(std::move(source));
}

const LayeredPlate::Layer& LayeredPlate::layer_at(double position, std::size_t& index) const {
  index = 0;
  while (index + 1 < layers_.size() && position >= layers_[index + 1].begin) ++index;
  return layers_[index];
}

LayeredPlate::Point LayeredPlate::at(double position, double time) const {
  std::size_t index = 0;
  const Layer& layer = layer_at(position, index);
  const double from_left = (position - layer.begin) / layer.wave_speed;
  const double from_right = (layer.begin + layer.thickness - position) / layer.wave_speed;
  double to_right = 0.0;
  double to_left = 0.0;
  for (const Source& source : sources_) {
    for (const Wave& wave : source.waves[index]) {
      const double stress =
          wave.amplitude * source.signal(time - wave.delay - (wave.to_right ? from_left : from_right));
      (wave.to_right ? to_right : to_left) += stress;
    }
  }
  return {to_right + to_left, layer.velocity + (to_left - to_right) / layer.impedance};
}

}  // namespace anvil
