// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "anvil/exact/layered_plate.hpp"
#include "anvil/exact/plate_reference.hpp"
#include "anvil/exact/scene_plate.hpp"
#include "anvil/scene/scene.hpp"

namespace anvil {

/// The exact state of a material point of a plate or a rod.
struct ExactPoint {
  double initial_position = 0.0;  // m
  double stress = 0.0;            // Pa, axial, tension positive
  double velocity = 0.0;          // m/s
  double density = 0.0;           // kg/m3
  double pressure = 0.0;          // Pa
  double deviator = 0.0;          // Pa, axial part
  double energy = 0.0;            // J/kg, specific internal; in finite strain
};

/// Whether a value of compare.reference asks for the solution computed here and not for a file.
bool is_exact_reference(std::string_view name);

/// The strain measure that the scene's compare.reference asks for: finite, unless it says small strain.
StrainMeasure strain_measure_of(const Scene& scene);

/// Exact plane waves of a scene at some times, whatever its layers, materials and loads: d'Alembert's solution where
/// everything is elastic in small strain, front tracking elsewhere. Layers stay in touch, also in tension, as particles
/// do; a rigid wall lets go, and times after that are refused.
class SceneReference {
 public:
  /// `times` in s, ascending. Throws InputError when the scene has no exact solution (plate_problem) or a body has left
  /// a wall by the last time, NumericalError when the solution fails.
  SceneReference(const Scene& scene, std::vector<double> times, StrainMeasure measure);

  [[nodiscard]] const std::vector<double>& times() const { return times_; }
  /// Which solution this is and how good, for headings: "exact, finite strain (front tracking, error 3e-05)".
  [[nodiscard]] const std::string& description() const { return description_; }
  /// Mean error of the stress over its mean, as far as it is known: 0 for d'Alembert's solution.
  [[nodiscard]] double relative_error(std::size_t time) const;

  [[nodiscard]] double begin() const { return problem_.left_position; }
  [[nodiscard]] double end() const { return problem_.left_position + problem_.thickness(); }
  /// At an initial position in m, at the time of that number.
  [[nodiscard]] ExactPoint at(std::size_t time, double position) const;
  /// A line to draw, from left to right: every front as two points at its place, and samples where stress varies.
  [[nodiscard]] std::vector<ExactPoint> line(std::size_t time) const;

 private:
  [[nodiscard]] ExactPoint point_of(double position, const WaveState& state, double reference_density) const;

  PlateProblem problem_;
  bool rod_;
  std::vector<double> times_;
  std::string description_;
  std::optional<LayeredPlate> layered_;
  PlateReference tracked_;  // empty beside a layered_ one
};

}  // namespace anvil
