// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "anvil/boundaries/pressure.hpp"
#include "anvil/core/error.hpp"
#include "anvil/kernels/kernel.hpp"
#include "anvil/materials/material_tables.hpp"
#include "anvil/scene/body_checks.hpp"
#include "anvil/scene/boundary_checks.hpp"
#include "anvil/scene/overlap.hpp"
#include "anvil/scene/placement.hpp"
#include "anvil/scene/problems.hpp"
#include "anvil/scene/shape.hpp"
#include "anvil/scene/stabiliser_checks.hpp"

namespace anvil {
namespace {

using Contradictions = std::vector<Contradiction>;

void check_strain_state(const Domain& domain, Contradictions& found) {
  const std::vector<std::vector<std::string>> possible = {
      {"uniaxial_strain", "uniaxial_stress"}, {"plane_strain"}, {"full"}};
  const auto& states = possible.at(static_cast<std::size_t>(domain.dimension - 1));
  if (std::find(states.begin(), states.end(), domain.strain_state) != states.end()) return;
  found.push_back({"domain.strain_state",
                   fmt::format("{} does not exist in {} dimension{}; it can be {} there", domain.strain_state,
                               domain.dimension, domain.dimension == 1 ? "" : "s", fmt::join(states, " or "))});
}

void check_gravity(const Domain& domain, Contradictions& found) {
  if (domain.gravity.size() == static_cast<std::size_t>(domain.dimension)) return;
  found.push_back(
      {"domain.gravity", fmt::format("it has {} components, and {} belong to {} dimension{}", domain.gravity.size(),
                                     domain.dimension, domain.dimension, domain.dimension == 1 ? "" : "s")});
}

void check_times(const Scene& scene, Contradictions& found) {
  constexpr double most_frames = 1e6;  // the numbers of frame files have six digits
  const double end = scene.time.end;
  if (end > 0.0 && !(end / scene.output.interval < most_frames))
    found.push_back(
        {"output.interval", fmt::format("{} s would write {:.3g} frames until {} s, and at most {:.3g} are possible",
                                        scene.output.interval, end / scene.output.interval, end, most_frames)});
}

/// A kernel that ends two smoothing lengths away reaches this many particles; it has to reach the next one at least.
void check_neighbours(const Scene& scene, Contradictions& found) {
  const double support =
      std::visit([](const auto& kernel) { return kernel.support; }, make_kernel(scene.discretisation.kernel));
  if (!(support * scene.discretisation.smoothing_ratio > 1.0))
    found.push_back({"discretisation.smoothing_ratio",
                     fmt::format("with {} the kernel ends {:.3g} spacings away, and no particle has a neighbour within "
                                 "it; take more than {:.3g}, usual is 1 or a little more",
                                 scene.discretisation.smoothing_ratio, support * scene.discretisation.smoothing_ratio,
                                 1.0 / support)});
  constexpr double most_neighbours = 1e4;  // beyond it a misprint is likelier than a wish
  const double ratio = scene.discretisation.smoothing_ratio;
  const double neighbours = std::pow(4.0 * ratio, scene.domain.dimension);
  if (!(neighbours <= most_neighbours))
    found.push_back({"discretisation.smoothing_ratio",
                     fmt::format("{} gives each particle {:.3g} neighbours, and at most {:.3g} are possible", ratio,
                                 neighbours, most_neighbours)});
}

/// What the energy equation does not go with.
void check_energy(const Scene& scene, Contradictions& found) {
  for (const auto& material : scene.materials) {
    if (!uses_energy(make_eos(material.eos, material.density))) continue;
    if (scene.domain.strain_state == "uniaxial_stress")
      found.push_back({"domain.strain_state",
                       fmt::format("uniaxial_stress does not go with the equation of state of '{}', which reads the "
                                   "energy; use linear, or uniaxial_strain",
                                   material.name)});
    if (scene.shock.method == "fct")
      found.push_back({"shock.method",
                       fmt::format("flux-corrected transport moves density without its energy, which the equation of "
                                   "state of '{}' reads; use hllc or artificial_viscosity",
                                   material.name)});
  }
}

/// Whether a length is a whole number of spacings.
bool fits(double length, double spacing) {
  constexpr double tolerance = 1e-6;  // of a spacing: far above the rounding of decimal lengths, far below an effect
  const double cells = length / spacing;
  return cells > 0.5 && std::abs(cells - std::round(cells)) <= tolerance;
}

/// The spacing nearest to `spacing` that divides the first length into whole cells, and if there is one not far away,
/// one that divides all of them.
double fitting_spacing(const std::vector<double>& lengths, double spacing) {
  const double cells = std::max(1.0, std::round(lengths.front() / spacing));
  for (int change = 0; change < 100; ++change) {
    for (const double candidate :
         {lengths.front() / (cells + change), lengths.front() / std::max(1.0, cells - change)}) {
      const auto fits_candidate = [&](double length) { return fits(length, candidate); };
      if (std::all_of(lengths.begin(), lengths.end(), fits_candidate)) return candidate;
    }
  }
  return lengths.front() / cells;
}

template <int D>
void check_fit(const BodyDescription& body, const Shape<D>& shape, double spacing, Contradictions& found) {
  std::vector<double> lengths;
  for (int axis = 0; axis < D; ++axis)
    if (shape.ends_in_planes(axis)) lengths.push_back(shape.size()[axis]);
  for (const double length : lengths) {
    if (fits(length, spacing)) continue;
    found.push_back(
        {fmt::format("body.{}.shape", body.name),
         fmt::format("its side of {:.9g} m is {:.6g} spacings of {:.9g} m, which is not a whole number; the "
                     "nearest discretisation.spacing that fits is {:.9g} m",
                     length, length / spacing, spacing, fitting_spacing(lengths, spacing))});
    return;  // one side at a time: a spacing that suits it may suit the others
  }
}

template <int D>
Vec<D> component_vector(const std::vector<double>& numbers) {
  return Vec<D>(numbers.data());
}

/// Walls are solid behind their plane: a body may touch it, not start beyond it.
template <int D>
void check_walls(const Scene& scene, const BodyDescription& body, const Shape<D>& shape, Contradictions& found) {
  const Mat<D> rotation = rotation_of<D>(body);
  for (const auto& boundary : scene.boundaries) {
    if (boundary.entry.type != "rigid_wall" && boundary.entry.type != "symmetry_plane") continue;
    const Vec<D> normal = component_vector<D>(boundary.entry.parameters.numbers("normal"));
    if (normal.norm() == 0.0) continue;
    const Vec<D> inward = normal.normalized();
    const Vec<D> point = component_vector<D>(boundary.entry.parameters.numbers("point"));
    const Vec<D> inward_of_shape = rotation.transpose() * inward;
    const double depth = shape.reach(-inward_of_shape) - inward_of_shape.dot(shape.centre()) + inward.dot(point);
    const double tolerance = 1e-6 * scene.discretisation.spacing;  // as for the fit of the sides
    if (depth > tolerance)
      found.push_back(
          {fmt::format("body.{}.shape", body.name),
           fmt::format("the body starts {:.6g} m behind the wall '{}', whose normal points to where bodies are", depth,
                       boundary.name)});
  }
}

/// A pressure needs a face of its own: where another body begins there is none.
void check_loaded_face(const Scene& scene, const BoundaryDescription& boundary, Contradictions& found) {
  const Parameters& load = boundary.entry.parameters;
  const auto end_of = [&](const BodyDescription& body, bool left) {
    return body.shape.parameters.number(left ? "min" : "max");
  };
  const bool left = load.text("face") == "left";
  const auto loaded = std::find_if(scene.bodies.begin(), scene.bodies.end(),
                                   [&](const auto& body) { return body.name == load.text("body"); });
  if (loaded == scene.bodies.end()) {
    found.push_back(
        {fmt::format("boundary.{}.body", boundary.name), fmt::format("no body is named '{}'", load.text("body"))});
    return;
  }
  for (const auto& other : scene.bodies) {
    const double gap = std::abs(end_of(*loaded, left) - end_of(other, !left));
    if (other.name == loaded->name || gap > scene.discretisation.spacing) continue;
    found.push_back(
        {fmt::format("boundary.{}.face", boundary.name),
         fmt::format("the {} face of '{}' is covered by the body '{}'", load.text("face"), loaded->name, other.name)});
  }
}

void check_pressures(const Scene& scene, Contradictions& found) {
  for (const auto& boundary : scene.boundaries) {
    if (boundary.entry.type != "pressure") continue;
    check_loaded_face(scene, boundary, found);
    try {
      (void)make_load_history(boundary.entry.parameters);
    } catch (const InputError& error) {
      found.push_back({fmt::format("boundary.{}.history", boundary.name), error.what()});
    }
  }
}

/// Choices of the method that cannot stand together.
void check_method(const Scene& scene, Contradictions& found) {
  const auto& [method, form] = std::pair(scene.discretisation.method, scene.discretisation.momentum_form);
  if (method == "cspm" && form != "difference")
    found.push_back(
        {"discretisation.momentum_form",
         fmt::format("{} does not go with cspm, which takes stress differences; leave the key out, or choose "
                     "the method kernel_gradient_correction",
                     form)});
  if (method == "kernel_gradient_correction" && form == "difference")
    found.push_back({"discretisation.momentum_form",
                     "difference with corrected gradients is the method cspm; kernel_gradient_correction takes a sum"});
  if (scene.shock.method == "fct" && scene.domain.dimension != 1)
    found.push_back(
        {"shock.method",
         fmt::format("flux-corrected transport needs particles in one line, and this scene has {} dimensions; "
                     "use artificial_viscosity",
                     scene.domain.dimension)});
}

void check_local_steps(const Scene& scene, Contradictions& found) {
  if (!scene.time.local_steps) return;
  const auto refuse = [&](const std::string& sentence) { found.push_back({"time.local_steps", sentence}); };
  if (scene.discretisation.method != "total_lagrangian")
    refuse("only bodies of the method total_lagrangian are stepped in parts; leave the key out");
  if (scene.bodies.size() > 1) refuse("bodies that meet take their steps together; leave the key out");
  for (const auto& boundary : scene.boundaries) {
    const bool penalty = boundary.entry.type == "rigid_wall" && boundary.entry.parameters.text("contact") == "penalty";
    if (penalty || boundary.entry.type == "pressure")
      refuse(
          fmt::format("the force of boundary '{}' acts in steps of all particles; leave the key out", boundary.name));
  }
  const auto& gravity = scene.domain.gravity;
  if (std::any_of(gravity.begin(), gravity.end(), [](double g) { return g != 0.0; }))
    refuse("gravity acts in steps of all particles; leave the key out");
}

/// What total Lagrangian sums cannot do, and what only they can.
void check_total_lagrangian(const Scene& scene, Contradictions& found) {
  const auto refuse = [&](const char* key, const std::string& sentence) { found.push_back({key, sentence}); };
  if (scene.discretisation.method != "total_lagrangian") {
    for (const auto& boundary : scene.boundaries)
      if (boundary.entry.type == "rigid_wall" && boundary.entry.parameters.text("contact") == "penalty")
        found.push_back({fmt::format("boundary.{}.contact", boundary.name),
                         "penalty follows the faces of the method total_lagrangian; use impulse"});
    if (scene.stabiliser.method != "none")
      refuse("stabiliser.method", fmt::format("{} belongs to the method total_lagrangian, whose lattice never changes",
                                              scene.stabiliser.method));
    if (scene.stabiliser.erosion_stretch > 0.0)
      refuse("stabiliser.erosion_stretch",
             "erosion takes out stress points that stay what they were at the start, those of total_lagrangian");
    return;
  }
  if (scene.discretisation.momentum_form != "sum")
    refuse("discretisation.momentum_form",
           fmt::format("{} does not go with total_lagrangian, whose forces are the adjoint of its deformation "
                       "gradient; leave the key out",
                       scene.discretisation.momentum_form));
  if (scene.shock.method != "none" && scene.shock.method != "bulk_viscosity")
    refuse("shock.method", fmt::format("{} works on the present neighbours, and total_lagrangian keeps those of the "
                                       "start; use bulk_viscosity",
                                       scene.shock.method));
  if (scene.stabiliser.conservative_smoothing > 0.0)
    refuse("stabiliser.conservative_smoothing",
           "it averages over the present neighbours, and total_lagrangian keeps those of the start; use "
           "stabiliser.method");
  const std::vector<std::string> possible = {"rigid_wall", "symmetry_plane", "pressure"};
  for (const auto& boundary : scene.boundaries)
    if (std::find(possible.begin(), possible.end(), boundary.entry.type) == possible.end())
      found.push_back({fmt::format("boundary.{}.type", boundary.name),
                       fmt::format("{} works on the present neighbours; total_lagrangian goes with {}",
                                   boundary.entry.type, fmt::join(possible, ", "))});
  for (const auto& body : scene.bodies)
    if (body.jitter > 0.0)
      found.push_back(
          {fmt::format("body.{}.jitter", body.name), "total_lagrangian wants the lattice as it is; leave the key out"});
  const bool all_on_faces = std::all_of(scene.bodies.begin(), scene.bodies.end(),
                                        [](const auto& body) { return body.lattice == "face_lattice"; });
  if (scene.bodies.size() > 1 && !all_on_faces)
    refuse("discretisation.method",
           "total_lagrangian bodies meet by their faces; give each of them lattice = \"face_lattice\"");
  for (const auto& material : scene.materials)
    if (std::visit([](const auto& eos) { return eos.uses_energy; }, make_eos(material.eos, material.density)))
      found.push_back(
          {fmt::format("material.{}.eos", material.name),
           fmt::format("{} reads the energy, which total_lagrangian does not keep; use linear", material.eos.type)});
  if (scene.domain.strain_state == "uniaxial_stress")
    refuse("domain.strain_state", "total_lagrangian has no uniaxial stress; use kernel_gradient_correction or cspm");
}

/// The gradients of hllc are those of the method, or plain.
void check_hllc(const Scene& scene, Contradictions& found) {
  if (scene.shock.method != "hllc") return;
  if (scene.discretisation.method == "cspm")
    found.push_back({"discretisation.method",
                     "cspm takes differences of stress, and hllc sums it; use kernel_gradient_correction or sph"});
  if (scene.discretisation.momentum_form != "sum" && scene.discretisation.method != "cspm")
    found.push_back(
        {"discretisation.momentum_form",
         fmt::format("hllc takes the place of the momentum equation and knows no form {}; leave the key out",
                     scene.discretisation.momentum_form)});
  if (scene.shock.pair_gradient != "plain" && scene.discretisation.method == "sph")
    found.push_back({"shock.pair_gradient", "corrected gradients belong to the method kernel_gradient_correction"});
  const std::vector<std::string> known = {"rigid_wall", "pressure", "symmetry_plane", "periodic"};
  for (const auto& boundary : scene.boundaries)
    if (std::find(known.begin(), known.end(), boundary.entry.type) == known.end())
      found.push_back({fmt::format("boundary.{}.type", boundary.name),
                       fmt::format("hllc keeps no account of the work of {}; it goes with {}", boundary.entry.type,
                                   fmt::join(known, ", "))});
  if (scene.domain.strain_state == "uniaxial_stress")
    found.push_back(
        {"shock.method", "hllc solves waves in uniaxial strain; use artificial_viscosity or fct for a rod"});
}

void check_normals(const Scene& scene, Contradictions& found) {
  for (const auto& boundary : scene.boundaries) {
    if (!boundary.entry.parameters.has("normal")) continue;
    const auto& normal = boundary.entry.parameters.numbers("normal");
    if (std::all_of(normal.begin(), normal.end(), [](double component) { return component == 0.0; }))
      found.push_back({fmt::format("boundary.{}.normal", boundary.name),
                       "it must not be zero: it points from the wall to the bodies"});
  }
}

/// Shapes and walls of each body by itself, and the size of the whole.
template <int D>
void check_each_body(const Scene& scene, Contradictions& found) {
  const double spacing = scene.discretisation.spacing;
  double cells = 0.0;
  for (const auto& body : scene.bodies) {
    try {
      const auto shape = make_shape<D>(body.shape);
      double cells_of_body = 1.0;
      for (const long long along_axis : count_cells<D>(*shape, spacing))
        cells_of_body *= static_cast<double>(along_axis);
      cells += cells_of_body;
      check_fit<D>(body, *shape, spacing, found);
      check_walls<D>(scene, body, *shape, found);
    } catch (const InputError& error) {
      found.push_back({fmt::format("body.{}.shape", body.name), error.what()});
    }
  }
  if (cells > most_particles)
    found.push_back(
        {"discretisation.spacing", fmt::format("{} m gives {:.3g} particles in all, and at most {:.3g} are possible",
                                               spacing, cells, most_particles)});
}

/// What needs the particles themselves, or more than one body.
template <int D>
void check_particles(const Scene& scene, Contradictions& found) {
  const double spacing = scene.discretisation.spacing;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const auto& body = scene.bodies[i];
    try {
      for (std::size_t j = 0; j < i; ++j)
        if (bodies_overlap<D>(scene.bodies[j], body, spacing))
          found.push_back({fmt::format("body.{}.shape", body.name),
                           fmt::format("the body overlaps the body '{}'", scene.bodies[j].name)});
      const auto shape = make_shape<D>(body.shape);
      if (!shape->contains(Vec<D>::Zero())) place_body<D>(body, spacing);  // the only shapes that may catch no particle
    } catch (const InputError& error) {
      found.push_back({fmt::format("body.{}.shape", body.name), error.what()});
    }
  }
}

template <int D>
void check_bodies(const Scene& scene, Contradictions& found) {
  const std::size_t before = found.size();
  check_each_body<D>(scene, found);
  if (found.size() == before) check_particles<D>(scene, found);
}

}  // namespace

std::vector<Contradiction> find_contradictions(const Scene& scene) {
  Contradictions found;
  check_strain_state(scene.domain, found);
  check_gravity(scene.domain, found);
  check_times(scene, found);
  check_normals(scene, found);
  check_pressures(scene, found);
  check_planes_and_periods(scene, found);
  check_method(scene, found);
  check_total_lagrangian(scene, found);
  check_mirrored_lattices(scene, found);
  check_stabilisers(scene, found);
  check_local_steps(scene, found);
  check_hllc(scene, found);
  check_neighbours(scene, found);
  check_motions_and_stresses(scene, found);
  check_energy(scene, found);
  if (scene.domain.dimension == 1) check_bodies<1>(scene, found);
  if (scene.domain.dimension == 2) check_bodies<2>(scene, found);
  if (scene.domain.dimension == 3) check_bodies<3>(scene, found);
  if (found.empty()) check_dummy_walls(scene, found);  // needs bodies that can be placed
  return found;
}

void check_scene(const Scene& scene) {
  Problems problems;
  for (const auto& [key, sentence] : find_contradictions(scene))
    problems.add({fmt::format("scene '{}'", scene.name)}, fmt::format("key '{}': {}", key, sentence));
  problems.throw_if_any();
}

}  // namespace anvil
