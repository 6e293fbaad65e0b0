// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "anvil/exact/load.hpp"
#include "anvil/exact/wave_material.hpp"

namespace anvil {

/// One layer of a plate, or one of several plates that touch at the start.
struct PlateLayer {
  double thickness;  // m
  WaveMaterial material;
  double velocity = 0.0;  // m/s, at the start
  double deviator = 0.0;  // Pa, axial, at the start; the pressure is zero
};

/// What holds a face of the plate: a pressure (none: a free face), or a wall the face cannot leave.
struct PlateFace {
  bool rigid = false;
  PressureHistory pressure;
};

/// Plane waves in layers that stay in touch, from left to right. Positions are the initial (Lagrangian) ones, in m.
struct PlateProblem {
  double left_position = 0.0;
  std::vector<PlateLayer> layers;
  PlateFace left_face;
  PlateFace right_face;

  [[nodiscard]] double thickness() const;
  /// Largest stress the loads and the impact of the layers can cause by themselves, Pa: elastic impedance times
  /// velocity difference, initial deviators and peak pressures. Never zero.
  [[nodiscard]] double stress_scale() const;
  /// Throws InputError when there is no layer, or one without thickness.
  void check() const;
};

}  // namespace anvil
