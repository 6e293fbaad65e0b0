// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "anvil/core/particle_range.hpp"

namespace anvil {

/// Where the deformation of particles stands, see Deformation: tensors are D x D per particle, row first.
template <int D>
struct DeformationArrays {
  double* gradient;                 // F
  const double* correction;         // B
  const double* reference_density;  // kg/m3
  double* density;                  // kg/m3
  const double* volume;             // m3 (m2, m), at the start
};

/// Where the state of edges stands, see EdgePoints.
template <int D>
struct EdgeArrays {
  static constexpr int shape_size = D + 2;      // N, 1/|X| (1/m), volume (m3, m2, m)
  static constexpr int force_size = D * D + D;  // the share of each end in V P (J), and the pull on the first (N)
  const std::int32_t *first, *second;           // the particles at its ends
  const double* shape;                          // shape_size per edge
  const double* position;                       // m, of the particles
  double* gradient;                             // F_e, D x D per edge
  double* density;                              // kg/m3
  const double* deviator;                       // Pa, packed
  double* force;                                // force_size per edge
  const std::int32_t *first_edge, *first_incoming, *incoming;  // by particle: edges that begin and that end there
};

/// What nominal stresses follow from; those without values are null.
struct StressArrays {
  const double *pressure, *viscous_pressure;  // Pa, by particle
  const double* deviator;                     // Pa, packed, by particle
  const double* edge_sums;                    // force_size per particle, as sum_edge_forces gives them
};

/// The loops over points that carry stress, particles and edges, with a point in each lane, as compiled for one
/// instruction set: beside PairLoops, and handed out in the same way.
template <int D>
struct PointLoops {
  int lanes;
  /// Brings packed deviators (Pa) of `count` points to the trial state of a step of time_step (s) under velocity
  /// gradients (D x D each, 1/s): turned with the spin, plus 2 G dt dev(D). See update_deviator.
  void (*strain_deviators)(int count, const double* velocity_gradient, double shear_modulus, double time_step,
                           double* deviator);
  /// Turns packed tensors with the spin.
  void (*turn_tensors)(int count, const double* velocity_gradient, double time_step, double* tensor);
  void (*advance_deformation)(ParticleRange range, double* gradients, double time_step,
                              const DeformationArrays<D>& particles);
  /// Deformation::find_least_stretches.
  void (*find_least_stretches)(ParticleRange range, const DeformationArrays<D>& particles, double* stretch);
  /// EdgePoints::deform; returns the first edge that has turned inside out, or -1.
  std::int32_t (*deform_edges)(ParticleRange edges, const EdgeArrays<D>& of, const DeformationArrays<D>& particles,
                               double time_step, double* velocity_gradients);
  void (*pull_back_edges)(ParticleRange edges, const EdgeArrays<D>& of);
  /// The shares and pulls of the edges at each particle of the range, force_size each.
  void (*sum_edge_forces)(ParticleRange range, const EdgeArrays<D>& of, double* sums);
  /// Nominal records of the range, see NominalMomentum: `records` is that of particle zero.
  void (*pack_nominal)(ParticleRange range, const DeformationArrays<D>& particles, const StressArrays& stresses,
                       double span, double* records);
};

/// The loops of the instruction set that simd_level() names.
template <int D>
const PointLoops<D>& point_loops();

}  // namespace anvil
