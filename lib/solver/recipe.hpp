// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "anvil/boundaries/boundary.hpp"
#include "anvil/boundaries/contact.hpp"
#include "anvil/boundaries/face_ghosts.hpp"
#include "anvil/kernels/kernel.hpp"
#include "anvil/materials/lateral_release.hpp"
#include "anvil/materials/material_update.hpp"
#include "anvil/scene/scene.hpp"
#include "anvil/terms/bulk_viscosity.hpp"
#include "anvil/terms/force_term.hpp"
#include "anvil/terms/line_transport.hpp"
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
};

/// What a step of a scene is made of, in order. Nothing in it knows the names of the scene's models any more.
template <int D>
struct Recipe {
  Kernel kernel;
  double support = 0.0;  // of the kernel, in smoothing lengths
  bool variable_smoothing_length = true;
  bool corrected_gradients = false;
  std::vector<Body<D>> bodies;
  std::vector<std::unique_ptr<ForceTerm<D>>> forces;
  std::vector<std::unique_ptr<VelocityFilter<D>>> filters;
  std::vector<std::unique_ptr<Boundary<D>>> boundaries;
  std::unique_ptr<BulkViscosity<D>> bulk_viscosity;
  // Only in total Lagrangian scenes: the terms' gradients are then those of the start.
  std::unique_ptr<Deformation<D>> deformation;
  EdgePoints<D>* edges = nullptr;  // one of the forces
  std::vector<const WallPenalty<D>*> wall_penalties;  // among the forces
  std::unique_ptr<Contact<D>> contact;  // where sums do not join bodies
  // Only in one dimension, where particles form a line with two ends.
  std::vector<PressureLoad> loads;
  std::unique_ptr<FaceGhosts> face_ghosts;
  std::unique_ptr<LineTransport> transport;
  PairNeeds force_needs, filter_needs;
};

/// Places the bodies of a scene and fills the fields every scene has: position, velocity, mass, density, smoothing
/// length.
template <int D>
FieldStore place_particles(const Scene& scene, std::vector<ParticleRange>& ranges);

/// Translates a scene into a recipe: the only place that knows the names of models. Throws InputError when a choice
/// cannot work with another.
template <int D>
Recipe<D> make_recipe(const Scene& scene, const std::vector<ParticleRange>& ranges, FieldStore& fields);

}  // namespace anvil
