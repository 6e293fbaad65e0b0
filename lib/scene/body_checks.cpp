// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/body_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "anvil/materials/strain_state.hpp"
#include "anvil/materials/strength/strength_law.hpp"

namespace anvil {
namespace {

using Contradictions = std::vector<Contradiction>;

void check_speeds(const Scene& scene, Contradictions& found) {
  constexpr double speed_of_light = 299792458.0;  // m/s
  for (const auto& body : scene.bodies) {
    const bool possible = std::all_of(body.velocity.begin(), body.velocity.end(),
                                      [](double component) { return std::abs(component) < speed_of_light; });
    if (!possible) found.push_back({fmt::format("body.{}.velocity", body.name), "the body would be faster than light"});
  }
}

/// Tensor of a packed deviator; nothing when it has not the components of its dimension.
std::optional<Tensor> unpacked_deviator(int dimension, const std::vector<double>& s) {
  if (dimension == 1 && s.size() == 1) return UniaxialStrain::deviator(s.data());
  if (dimension == 2 && s.size() == 3) return PlaneStrain::deviator(s.data());
  if (dimension == 3 && s.size() == 6) return FullStrain::deviator(s.data());
  return std::nullopt;
}

/// A stress at the start must be a deviator that the material can hold.
void check_deviators(const Scene& scene, Contradictions& found) {
  for (const auto& body : scene.bodies) {
    if (body.deviatoric_stress.empty()) continue;
    const auto refuse = [&](const std::string& why) {
      found.push_back({fmt::format("body.{}.deviatoric_stress", body.name), why});
    };
    const auto deviator = unpacked_deviator(scene.domain.dimension, body.deviatoric_stress);
    if (!deviator) {
      const int components = scene.domain.dimension * (scene.domain.dimension + 1) / 2;
      refuse(fmt::format("it has {} components, and {} belong to {} dimension{}", body.deviatoric_stress.size(),
                         components, scene.domain.dimension, scene.domain.dimension == 1 ? "" : "s"));
      continue;
    }
    const double size = std::sqrt(equivalent_stress_squared(*deviator));
    if (std::abs(deviator->trace()) > 1e-9 * size)
      refuse(fmt::format("its trace is {:.6g} Pa, and that of a deviator is zero", deviator->trace()));
    const auto material = std::find_if(scene.materials.begin(), scene.materials.end(),
                                       [&](const auto& one) { return one.name == body.material; });
    if (material == scene.materials.end()) continue;
    const Parameters& strength = material->strength.parameters;
    if (material->strength.type == "none") {
      refuse(fmt::format("the material '{}' has no strength and holds none", material->name));
    } else if (strength.has("yield_stress") && size > strength.number("yield_stress")) {
      refuse(fmt::format("its equivalent stress of {:.6g} Pa is beyond the yield stress of '{}', {:.6g} Pa", size,
                         material->name, strength.number("yield_stress")));
    }
  }
}

/// Layers and a radial velocity need a ring, the latter with a hole, where 1/r has an end.
void check_rings(const Scene& scene, Contradictions& found) {
  for (const auto& body : scene.bodies) {
    const bool ring = body.shape.type == "ring";
    if (body.lattice == "concentric" && !ring)
      found.push_back({fmt::format("body.{}.lattice", body.name), "concentric layers fill a ring; use cubic"});
    if (body.radial_velocity != 0.0 && (!ring || body.shape.parameters.number("inner_radius") == 0.0))
      found.push_back({fmt::format("body.{}.radial_velocity", body.name), "it belongs to a ring with a hole"});
  }
}

void check_rotations(const Scene& scene, Contradictions& found) {
  const int dimension = scene.domain.dimension;
  const std::size_t wanted = dimension == 3 ? 3 : static_cast<std::size_t>(dimension - 1);
  for (const auto& body : scene.bodies) {
    if (body.rotation.empty() || body.rotation.size() == wanted) continue;
    found.push_back({fmt::format("body.{}.rotation", body.name),
                     dimension == 1 ? std::string("there is nothing to turn in 1D; leave the key out")
                                    : fmt::format("in {}D it takes {}, not {}", dimension,
                                                  wanted == 1 ? "one angle" : "three numbers, axis times angle",
                                                  body.rotation.size())});
  }
}

}  // namespace

void check_motions_and_stresses(const Scene& scene, std::vector<Contradiction>& found) {
  check_rotations(scene, found);
  check_speeds(scene, found);
  check_deviators(scene, found);
  check_rings(scene, found);
}

}  // namespace anvil
