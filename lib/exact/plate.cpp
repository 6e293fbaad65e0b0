// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/exact/plate.hpp"

#include <algorithm>
#include <cmath>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

double impact_stress(const PlateLayer& layer, double velocity_jump) {
  return 0.5 * layer.material.density() * layer.material.elastic_wave_speed() * std::abs(velocity_jump);
}

}  // namespace

double PlateProblem::thickness() const {
  double sum = 0.0;
  for (const PlateLayer& layer : layers) sum += layer.thickness;
  return sum;
}

double PlateProblem::stress_scale() const {
  double scale = std::max(left_face.pressure.peak(), right_face.pressure.peak());
  double previous = left_face.rigid ? 0.0 : layers.front().velocity;
  for (const PlateLayer& layer : layers) {
    scale = std::max({scale, std::abs(layer.deviator), impact_stress(layer, layer.velocity - previous)});
    previous = layer.velocity;
  }
  if (right_face.rigid) scale = std::max(scale, impact_stress(layers.back(), previous));
  return scale > 0.0 ? scale : 1.0;
}

void PlateProblem::check() const {
  if (layers.empty()) throw InputError("a plate needs at least one layer");
  for (const PlateLayer& layer : layers)
    if (!(layer.thickness > 0.0)) throw InputError("the thickness of a layer must be above zero");
}

}  // namespace anvil
