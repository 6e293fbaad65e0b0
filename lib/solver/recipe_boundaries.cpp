// SPDX-License-Identifier: BSD-3-Clause
// The part of the recipe that knows the names of boundaries.
#include <algorithm>
#include <cmath>

#include "anvil/boundaries/inflow.hpp"
#include "anvil/boundaries/rigid_wall.hpp"
#include "anvil/boundaries/symmetry_plane.hpp"
#include "anvil/core/field_keys.hpp"
#include "anvil/solver/recipe.hpp"

namespace anvil {
namespace {

bool is_dummy_wall(const TypedEntry& entry) {
  return entry.type == "long_range_wall" || entry.type == "dummy_wall" || entry.type == "repulsive_wall";
}

WallVelocity velocity_rule(const std::string& name) {
  if (name == "zero") return WallVelocity::zero;
  return name == "reversed_normal" ? WallVelocity::reversed_normal : WallVelocity::antisymmetric;
}

template <int D>
Vec<D> vector_from(const std::vector<double>& components) {
  if (components.size() == 1) return Vec<D>::Constant(components[0]);  // the schema's default of zero
  return Vec<D>(components.data());
}

}  // namespace

template <int D>
Walls<D> plan_walls(const Scene& scene, std::size_t first) {
  Walls<D> walls;
  const double spacing = scene.discretisation.spacing;
  for (const auto& [name, entry] : scene.boundaries) {
    if (!is_dummy_wall(entry)) continue;
    const Parameters& keys = entry.parameters;
    WallSurface<D> surface(keys);
    auto points = surface.rows(spacing, keys.number("first_row"), static_cast<int>(keys.integer("rows")));
    const ParticleRange range{static_cast<std::int32_t>(first), static_cast<std::int32_t>(first + points.size())};
    first += points.size();
    walls.push_back(std::make_unique<DummyRows<D>>(name, std::move(surface), std::move(points), range,
                                                   std::pow(spacing, D), velocity_rule(keys.text("velocity")),
                                                   keys.flag("in_sums")));
  }
  return walls;
}

template <int D>
void add_wall_forces(const Scene& scene, const Walls<D>& walls, double bulk_modulus, double sound_speed,
                     FieldStore& fields, Recipe<D>& recipe) {
  auto wall = walls.begin();
  const double h = scene.discretisation.smoothing_ratio * scene.discretisation.spacing;
  const auto add = [&]<class Law>(const Law& law, const char* name, const char* purpose) {
    auto force = std::make_unique<WallForce<D, Law>>(fields, **wall, law, name, purpose);
    recipe.wall_forces.push_back(force.get());
    recipe.forces.push_back(std::move(force));
  };
  for (const auto& boundary : scene.boundaries) {
    if (!is_dummy_wall(boundary.entry)) continue;
    const Parameters& keys = boundary.entry.parameters;
    if (boundary.entry.type == "long_range_wall") {
      const double modulus = keys.has("bulk_modulus") ? keys.number("bulk_modulus") : bulk_modulus;
      const double strength = keys.number("strength");
      add(PeridynamicForce(D, modulus, h, strength, keys.number("range") * h), "long_range_wall",
          "bond force of the first row of a wall");
      recipe.largest_step = std::min(recipe.largest_step, 0.25 * h / (sound_speed * std::sqrt(strength)));
    } else if (boundary.entry.type == "repulsive_wall") {
      const double reach = keys.number("range") * h;
      const double coefficient =
          keys.has("coefficient") ? keys.number("coefficient") : 0.01 * sound_speed * sound_speed;
      add(MonaghanRepulsion(coefficient, reach), "repulsive_wall", "repulsion of the first row of a wall");
      recipe.largest_step = std::min(recipe.largest_step, 0.25 * reach / std::sqrt(coefficient));
    }
    ++wall;
  }
}

template <int D>
void add_boundaries(const Scene& scene, Recipe<D>& recipe) {
  const double spacing = scene.discretisation.spacing;
  std::vector<MirrorPlane<D>> planes;
  std::vector<Period> periods;
  for (const auto& [name, entry] : scene.boundaries) {
    const Parameters& keys = entry.parameters;
    if ((entry.type == "pressure" && D == 1) || is_dummy_wall(entry)) continue;
    if (entry.type == "periodic") {
      periods.push_back({keys.text("axis")[0] - 'x', keys.number("min"), keys.number("max")});
      continue;
    }
    if (!keys.has("normal"))
      throw InputError("boundary '" + name + "' has type '" + entry.type + "', which no solver knows");
    const Vec<D> point = vector_from<D>(keys.numbers("point"));
    const Vec<D> normal = vector_from<D>(keys.numbers("normal")).normalized();
    if (entry.type == "rigid_wall" && keys.text("contact") == "penalty") continue;  // among the forces
    if (entry.type == "rigid_wall") {
      recipe.boundaries.push_back(std::make_unique<RigidWall<D>>(name, point, normal, spacing));
    } else if (entry.type == "inflow") {
      recipe.boundaries.push_back(std::make_unique<Inflow<D>>(name, point, normal, keys.number("speed")));
      recipe.holds_particles = true;
    } else if (entry.type == "mirror_wall") {
      planes.push_back({point, normal, !keys.flag("slip")});
      recipe.mirror_walls.push_back(planes.back());
    } else {
      recipe.boundaries.push_back(std::make_unique<SymmetryPlane<D>>(name, point, normal, spacing));
      planes.push_back({point, normal});
    }
  }
  recipe.images = Images<D>(std::move(planes), std::move(periods));
}

#define ANVIL_INSTANTIATE(D)                                                                                \
  template Walls<D> plan_walls<D>(const Scene&, std::size_t);                                               \
  template void add_wall_forces<D>(const Scene&, const Walls<D>&, double, double, FieldStore&, Recipe<D>&); \
  template void add_boundaries<D>(const Scene&, Recipe<D>&)
ANVIL_INSTANTIATE(1);
ANVIL_INSTANTIATE(2);
ANVIL_INSTANTIATE(3);
#undef ANVIL_INSTANTIATE

}  // namespace anvil
