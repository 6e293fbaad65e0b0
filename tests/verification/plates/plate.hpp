// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "anvil/exact/plate_reference.hpp"
#include "anvil/scene/scene.hpp"
#include "anvil/solver/simulation.hpp"

namespace anvil {

/// The plate of a scene as the exact solver sees it: layers in the order of the bodies, in finite strain, which is the
/// problem an updated Lagrangian method solves.
inline PlateProblem plate_problem(const Scene& scene) {
  PlateProblem problem;
  for (const auto& body : scene.bodies) {
    const auto material = std::find_if(scene.materials.begin(), scene.materials.end(),
                                       [&](const auto& one) { return one.name == body.material; });
    ElasticPlasticConstants constants{.shear_modulus = material->strength.parameters.number("shear_modulus")};
    if (material->strength.type == "j2") {
      constants.yield_stress = material->strength.parameters.number("yield_stress");
      constants.hardening_modulus = material->strength.parameters.number("hardening_modulus");
    }
    const double bulk_modulus = material->eos.parameters.number("bulk_modulus");
    problem.layers.push_back(
        {body.shape.parameters.number("max") - body.shape.parameters.number("min"),
         WaveMaterial::finite_strain(material->density, PressureLinearInDensity{bulk_modulus}, constants),
         body.velocity[0]});
  }
  problem.left_position = scene.bodies.front().shape.parameters.number("min");
  for (const auto& boundary : scene.boundaries) {
    const Parameters& load = boundary.entry.parameters;
    if (load.text("history") == "exponential")
      problem.left_face.pressure = PressureHistory::exponential(load.number("value"), load.number("decay"));
    else
      problem.left_face.pressure = PressureHistory::rectangular(load.number("value"), load.number("duration"));
  }
  return problem;
}

/// Exact profiles at ascending times (s). Waves that never meet a plastic front stay few, and are followed down to any
/// size.
inline std::vector<WaveProfile> exact_profiles(const Scene& scene, const std::vector<double>& times, bool elastic) {
  if (!elastic) return solve_plate(plate_problem(scene), times).profiles;
  FrontTracking tracking(plate_problem(scene), times.back(), {.step = 1.0 / 64.0, .smallest = 1e-9});
  std::vector<WaveProfile> profiles;
  for (const double time : times) {
    tracking.advance_to(time);
    profiles.push_back(tracking.profile());
  }
  return profiles;
}

/// Axial stresses of a plate against the exact ones, at initial positions.
struct PlateComparison {
  std::vector<double> position;  // m
  std::vector<double> stress;    // Pa
  std::vector<double> exact;     // Pa
  double l1 = 0.0;               // mean |stress - exact| over the largest |exact|

  [[nodiscard]] double mean_stress(double from, double to) const {
    double sum = 0.0;
    int count = 0;
    for (std::size_t k = 0; k < position.size(); ++k) {
      if (position[k] < from || position[k] > to) continue;
      sum += stress[k];
      ++count;
    }
    return sum / count;
  }
};

inline PlateComparison compare_plate(const Frame& frame, const WaveProfile& exact) {
  PlateComparison result;
  const auto& initial = frame.find("initial_position")->values;
  const auto& stress = frame.find("stress")->values;
  const std::size_t particles = frame.positions.size() / 3;
  double peak = 0.0;
  for (std::size_t i = 0; i < particles; ++i) {
    result.position.push_back(initial[3 * i]);
    result.stress.push_back(stress[6 * i]);
    result.exact.push_back(exact.state_at(initial[3 * i]).stress);
    peak = std::max(peak, std::abs(result.exact[i]));
    result.l1 += std::abs(result.stress[i] - result.exact[i]);
  }
  result.l1 /= peak * static_cast<double>(particles);
  return result;
}

}  // namespace anvil
