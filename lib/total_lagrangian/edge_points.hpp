// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "anvil/core/fields.hpp"
#include "anvil/core/particle_range.hpp"
#include "anvil/pairs/images.hpp"
#include "anvil/points/point_loops.hpp"
#include "anvil/terms/force_term.hpp"
#include "anvil/total_lagrangian/deformation.hpp"

namespace anvil {

/// Stress points on the edges of a lattice of particles, against the motions that gradients at particles do not see.
/// The deformation gradient of an edge is the mean of its two ends with the part along the edge replaced by the exact
/// one, F_e = (F_i + F_j)/2 (I - N N^T) + x_ij N^T / |X_ij| with N = X_ij / |X_ij|. Each edge carries the strength
/// law's state for the volume V_e = V_i/n_i + V_j/n_j, n the number of edges at a particle; pressure stays on the
/// particles, where fewer points mean no locking. Forces are the adjoint of F_e: momentum and angular momentum close.
/// Nothing in it is to be chosen.
template <int D>
class EdgePoints final : public ForceTerm<D> {
 public:
  /// Edges join particles of one body at a distance of about `spacing` (m), measured where they start. Symmetry planes
  /// of `images` may hold particles on them: these stand for whole ones, and have the edges behind the planes as well.
  EdgePoints(FieldStore& particles, const std::vector<ParticleRange>& bodies, double spacing,
             const Images<D>& images = {});

  /// Mass, density and what strength laws require, by edge.
  [[nodiscard]] FieldStore& fields() { return fields_; }
  [[nodiscard]] const FieldStore& fields() const { return fields_; }
  /// The edges whose first end lies in a range of particles; consecutive ranges have consecutive edges.
  [[nodiscard]] ParticleRange edges_from(ParticleRange particles) const {
    return {first_edge_[particles.first()], first_edge_[particles.last()]};
  }

  /// Density and cofactor of the edges of the range, and their velocity gradients in the middle of a step of time_step
  /// (s) since the call before, D x D per edge of the range, 1/s. A step of zero sets where the next one starts.
  /// Returns the particle at the first end of an edge that has turned inside out, -1 if there is none.
  [[nodiscard]] std::int32_t deform(ParticleRange edges, const Deformation<D>& particles, double time_step,
                                    double* velocity_gradients);
  /// Of an edge: see Deformation::least_stretch.
  [[nodiscard]] double least_stretch(std::size_t e) const {
    const Square<D> f = ConstSquareMap<D>(&deformation_[e * D * D]), c = cofactor<D>(f);
    return std::sqrt(static_cast<double>(D)) * determinant<D>(f, c) / c.norm();
  }
  /// Takes the edges' new deviators to the reference configuration.
  void pull_back(ParticleRange edges);
  /// Multiplies what pull_back gave by `span` (s, or none: zero): forces become impulses.
  void weigh(ParticleRange edges, double span);
  /// Adds up what pull_back and weigh left, for the particles of the range: before accumulate.
  void sum_forces(ParticleRange particles);
  /// By particle D x D and D numbers: what its edges add to its nominal stress, times its volume, and their force on
  /// it.
  [[nodiscard]] const double* force_sums() const { return force_sums_.data(); }
  /// Mean over the edges at each particle of a field of the edges, its components side by side.
  [[nodiscard]] std::vector<double> mean_at_particles(const FieldKey& key) const;
  /// A scalar field of the edges at the particles, to second order: the middles of edges are half a spacing away, so
  /// that their mean lacks a part of the curvature, which the means at the particle's neighbours tell. Never beyond the
  /// values of its own edges.
  [[nodiscard]] std::vector<double> scalar_at_particles(const FieldKey& key) const;

  [[nodiscard]] std::string_view name() const override { return "edge_stress_points"; }
  [[nodiscard]] std::string_view purpose() const override { return "deviatoric stress along the edges of the lattice"; }
  [[nodiscard]] PairNeeds needs() const override { return {}; }
  void pack(ParticleRange /*range*/, PairRecords<D>& /*records*/) const override {}
  void accumulate(const PairTile<D>& tile, const PairRecords<D>& records, double* acceleration,
                  double* loss) const override;
  [[nodiscard]] double doubles_per_particle() const;

 private:
  using Arrays = EdgeArrays<D>;
  static constexpr std::size_t shape_size = Arrays::shape_size, force_size = Arrays::force_size;
  [[nodiscard]] Arrays arrays();
  void find_edges(const std::vector<ParticleRange>& bodies, double spacing);
  [[nodiscard]] double part_on_this_side(std::size_t first, const Vec<D>& second, double spacing) const;
  void find_turns(double spacing, Images<D> images);
  void list_incoming();
  void share_volumes();
  template <class Work>
  void for_each_edge_at(std::size_t particle, Work&& work) const;
  [[nodiscard]] double& volume(std::size_t edge) { return shape_[edge * shape_size + D + 1]; }
  [[nodiscard]] double volume(std::size_t edge) const { return shape_[edge * shape_size + D + 1]; }

  VectorView<D> position_, initial_position_;
  std::span<const double> mass_, density_;
  std::vector<std::int32_t> first_, second_;  // by edge: its ends
  // By edge: its direction N from the second end to the first, 1/|X_ij| (1/m), and V_e on this side of the planes.
  std::vector<double> shape_;
  std::vector<std::int32_t> first_edge_;                 // by first end
  std::vector<std::int32_t> first_incoming_, incoming_;  // the edges by second end
  // What leaves a particle on symmetry planes where it is: empty away from them, else the unit matrix and the others.
  std::vector<std::vector<Transform<D>>> transforms_;
  std::vector<std::int32_t> transforms_of_;  // by particle, -1: away from planes
  // By edge: V_e P_e (I - N N^T)/2 with P_e = s cof F_e, the share of each end, and the force V_e P_e N/|X| that pulls
  // its first end back; by particle the sums of both.
  std::vector<double> force_, force_sums_;
  std::vector<double> deformation_;  // F_e, D x D
  FieldStore fields_{0};
  double* edge_density_ = nullptr;
  const double* deviator_ = nullptr;
};

}  // namespace anvil
