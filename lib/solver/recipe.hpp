// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "anvil/boundaries/boundary.hpp"
#include "anvil/boundaries/contact.hpp"
#include "anvil/boundaries/dummy_rows.hpp"
#include "anvil/boundaries/face_ghosts.hpp"
#include "anvil/boundaries/wall_force.hpp"
#include "anvil/kernels/kernel.hpp"
#include "anvil/materials/lateral_release.hpp"
#include "anvil/materials/material_update.hpp"
#include "anvil/pairs/images.hpp"
#include "anvil/scene/scene.hpp"
#include "anvil/terms/bulk_viscosity.hpp"
#include "anvil/terms/force_term.hpp"
#include "anvil/terms/line_transport.hpp"
#include "anvil/terms/nominal_momentum.hpp"
#include "anvil/terms/velocity_filter.hpp"
#include "anvil/terms/wall_penalty.hpp"
#include "anvil/total_lagrangian/deformation.hpp"
#include "anvil/total_lagrangian/edge_points.hpp"

namespace anvil {

/// A body in the solver: a contiguous range of particles and the laws of its material.
template <int D>
struct Body {
  std::string name;
  ParticleRange range;
  std::unique_ptr<StrengthUpdate<D>> strength;
  ParticleRange strength_range;  // where the strength law works: the particles, or edges between them
  std::unique_ptr<EosUpdate<D>> eos;
  std::unique_ptr<LateralRelease> lateral_release;  // in uniaxial stress
  double face_distance = 0.0;                       // m, from the outermost particles to the body's faces at the start
  double viscosity = 0.0;                           // Pa s
};

/// What a step of a scene is made of, in order. Nothing in it knows the names of the scene's models any more.
template <int D>
struct Recipe {
  Kernel kernel;
  double support = 0.0;  // of the kernel, in smoothing lengths
  bool variable_smoothing_length = true;
  bool corrected_gradients = false;
  double density_diffusion = 0.0;  // delta
  std::vector<Body<D>> bodies;
  std::vector<std::unique_ptr<ForceTerm<D>>> forces;
  std::vector<std::unique_ptr<VelocityFilter<D>>> filters;
  std::vector<std::unique_ptr<Boundary<D>>> boundaries;
  std::unique_ptr<BulkViscosity<D>> bulk_viscosity;
  // Only in total Lagrangian scenes: the terms' gradients are then those of the start.
  std::unique_ptr<Deformation<D>> deformation;
  const NominalMomentum<D>* nominal_momentum = nullptr;  // of a total Lagrangian scene, one of the forces
  EdgePoints<D>* edges = nullptr;                        // one of the forces
  std::optional<double> erosion;                         // the stretch below which stress points are eroded
  std::vector<const WallPenalty<D>*> wall_penalties;     // among the forces
  std::unique_ptr<Contact<D>> contact;                   // where sums do not join bodies
  Images<D> images;                            // behind symmetry planes and mirror walls, beyond the ends of periods
  std::vector<MirrorPlane<D>> mirror_walls;    // which particles can cross
  std::vector<WallForceTerm<D>*> wall_forces;  // among the forces
  bool holds_particles = false;                // whether a boundary does
  Vec<D> gravity = Vec<D>::Zero();             // m/s2
  double largest_step = std::numeric_limits<double>::max();  // s, that walls can bear
  double wall_sound_speed = 0.0, wall_viscosity = 0.0;       // of dummy particles, m/s and Pa s
  // Only in one dimension, where particles form a line with two ends.
  std::vector<PressureLoad> loads;
  std::unique_ptr<FaceGhosts> face_ghosts;
  std::unique_ptr<LineTransport> transport;
  PairNeeds force_needs, filter_needs;
};

/// Places the bodies of a scene and behind them the dummy particles of its walls, and fills the fields every scene has:
/// position, velocity, mass, density, smoothing length.
template <int D>
FieldStore place_particles(const Scene& scene, std::vector<ParticleRange>& ranges, Walls<D>& walls);

/// Translates a scene into a recipe: the only place that knows the names of models. Throws InputError when a choice
/// cannot work with another.
template <int D>
Recipe<D> make_recipe(const Scene& scene, const std::vector<ParticleRange>& ranges, const Walls<D>& walls,
                      FieldStore& fields);

// The parts of it that know the names of boundaries.
template <int D>
Walls<D> plan_walls(const Scene& scene, std::size_t first_particle);
template <int D>
void add_boundaries(const Scene& scene, Recipe<D>& recipe);
/// `bulk_modulus` (Pa) and `sound_speed` (m/s) of the stiffest material.
template <int D>
void add_wall_forces(const Scene& scene, const Walls<D>& walls, double bulk_modulus, double sound_speed,
                     FieldStore& fields, Recipe<D>& recipe);

}  // namespace anvil
