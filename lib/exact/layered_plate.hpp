// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "anvil/exact/plate.hpp"

namespace anvil {

/// Elastic plane waves in any number of layers under any load, exact to round-off: d'Alembert's solution in each layer,
/// stress = f(t - x/c) + g(t + x/c) and velocity = (g - f) / (density c), where every reflection and transmission is a
/// delayed and scaled copy of what happens at a face or, at the start, between layers of different velocity. Copies
/// that passed each layer equally often arrive together and are one. A slender rod is one layer of
/// WaveMaterial::uniaxial_stress. Yield is disregarded.
class LayeredPlate {
 public:
  struct Point {
    double stress;    // Pa, positive in tension
    double velocity;  // m/s
  };

  /// `end`: the last time anyone will ask for, s. Throws InputError, also for layers with a stress at the start.
  LayeredPlate(const PlateProblem& problem, double end);

  /// At the initial position (m) inside the plate and at a time (s) from 0 to `end`; on a boundary of layers the right
  /// one answers.
  [[nodiscard]] Point at(double position, double time) const;

 private:
  struct Layer {
    double begin;  // m
    double thickness;
    double wave_speed;
    double impedance;
    double velocity;  // at the start
  };
  /// A wave that enters its layer, at the left end or at the right one, as amplitude * signal(t - delay).
  struct Wave {
    bool to_right;
    double delay;
    double amplitude;
  };
  using Signal = std::function<double(double)>;
  struct Source {
    Signal signal;                         // stress against time, zero before 0
    std::vector<std::vector<Wave>> waves;  // per layer
  };
  struct Entry {
    std::size_t layer;
    bool to_right;
    double amplitude;
  };

  void add_source(Signal signal, const std::vector<Entry>& entries, double end);
  void add_impacts(double end);
  [[nodiscard]] std::vector<Entry> leave(const Entry& wave) const;
  [[nodiscard]] const Layer& layer_at(double position, std::size_t& index) const;

  std::vector<Layer> layers_;
  bool left_rigid_;
  bool right_rigid_;
  std::vector<Source> sources_;
};

}  // namespace anvil
