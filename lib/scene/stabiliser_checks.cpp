// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/stabiliser_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace anvil {
namespace {

using Contradictions = std::vector<Contradiction>;

void check_hourglass_control(const Scene& scene, Contradictions& found) {
  if (scene.stabiliser.method != "hourglass_control") return;
  if (scene.time.local_steps)
    found.push_back({"time.local_steps", "hourglass_control acts in steps of all particles; leave the key out"});
  for (const auto& material : scene.materials)
    if (material.strength.type == "none")
      found.push_back({"stabiliser.method",
                       fmt::format("hourglass_control takes its stiffness from Young's modulus, and '{}' has none",
                                   material.name)});
}

/// What reads fields of both ends of a pair beside stress and velocity finds them at particles and at their mirror
/// images only.
template <class Refuse>
void refuse_other_boundaries(const Scene& scene, const char* what, const Refuse& refuse) {
  const std::vector<std::string> possible = {"rigid_wall", "symmetry_plane", "periodic"};
  for (const auto& boundary : scene.boundaries)
    if (std::find(possible.begin(), possible.end(), boundary.entry.type) == possible.end())
      refuse(fmt::format("it finds no {} at boundary '{}'; it goes with {}", what, boundary.name,
                         fmt::join(possible, ", ")));
}

void check_adjoint(const Scene& scene, Contradictions& found) {
  if (scene.discretisation.momentum_form != "adjoint") return;
  const auto refuse = [&](const std::string& sentence) { found.push_back({"discretisation.momentum_form", sentence}); };
  if (scene.discretisation.method == "sph")
    refuse(
        "adjoint is the form for corrected gradients, and sph has none; use sum, or the method "
        "kernel_gradient_correction");
  if (scene.shock.method == "hllc" || scene.shock.method == "fct")
    refuse(
        fmt::format("{} has pair forces of its own; use bulk_viscosity or artificial_viscosity", scene.shock.method));
  refuse_other_boundaries(scene, "correction of gradients", refuse);
}

void check_non_affine_damping(const Scene& scene, Contradictions& found) {
  if (scene.stabiliser.non_affine_damping == 0.0) return;
  const auto refuse = [&](const std::string& sentence) {
    found.push_back({"stabiliser.non_affine_damping", sentence});
  };
  if (scene.discretisation.method == "total_lagrangian")
    refuse("it works on the present neighbours, and total_lagrangian keeps those of the start; use stabiliser.method");
  if (scene.discretisation.method == "sph")
    refuse(
        "the gradients of sph do not see an even flow as even, which would be damped too; use the method "
        "kernel_gradient_correction");
  if (scene.shock.method == "hllc" || scene.shock.method == "fct")
    refuse(fmt::format("{} filters velocities in its own way; use bulk_viscosity or artificial_viscosity",
                       scene.shock.method));
  refuse_other_boundaries(scene, "velocity gradients", refuse);
}

}  // namespace

void check_stabilisers(const Scene& scene, std::vector<Contradiction>& found) {
  check_adjoint(scene, found);
  check_hourglass_control(scene, found);
  check_non_affine_damping(scene, found);
}

}  // namespace anvil
