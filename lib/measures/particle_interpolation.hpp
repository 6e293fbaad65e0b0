// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "anvil/output/frame.hpp"

namespace anvil {

/// How values between particles are found.
struct InterpolationOptions {
  /// m; 0: the array smoothing_length of the frame, else 1.2 times the usual distance of neighbours.
  double smoothing_length = 0.0;
  /// 0: kernel-weighted mean, exact for constant fields (Shepard 1968). 1: the best plane through the weighted values,
  /// exact for linear fields as well (moving least squares, Lancaster and Salkauskas 1981); where too few particles are
  /// near, as order 0.
  int order = 0;
  /// Places that are less full than this lie outside the bodies and get NaN. Half full is where the surface is.
  double least_filling = 0.5;
};

/// Values of particles anywhere between them, by sums over the particles within reach of the cubic spline:
/// f(x) = sum_j f_j V_j W(x - x_j, h_j) / sum_j V_j W(x - x_j, h_j). The denominator is how full space is there: 1
/// inside a body, about 0.5 at its surface. V_j = m_j/rho_j where the frame has mass and density, else
/// 1 / sum_k W(x_j - x_k, h_j), which needs neither.
class ParticleInterpolation {
 public:
  /// Takes the particles where they are now, or at `positions` (3 per particle, m). Throws InputError when a position
  /// is not finite or a smoothing length is not above zero.
  ParticleInterpolation(const Frame& frame, const InterpolationOptions& options);
  ParticleInterpolation(const Frame& frame, const std::vector<double>& positions, const InterpolationOptions& options);

  struct Sampled {
    std::vector<double> filling;              // of each point
    std::vector<std::vector<double>> values;  // of each field at each point
  };

  /// `points`: 3 numbers each, m; of a frame in one or two dimensions the others are ignored. `fields`: one number per
  /// particle each.
  [[nodiscard]] Sampled at(std::span<const double> points, std::span<const std::vector<double>> fields) const;

 private:
  struct CellOf {
    std::uint64_t cell;
    std::int32_t particle;
  };

  void sort_into_cells();
  void find_volumes(const Frame& frame);
  [[nodiscard]] std::uint64_t cell_at(const double* point, int axis) const;
  /// Calls visit(particle, weight without volume, r) for all within reach of their kernels.
  template <class Visit>
  void for_each_near(const double* point, Visit&& visit) const;
  void sample_point(const double* point, std::span<const std::vector<double>> fields, std::size_t place,
                    Sampled& sampled) const;

  InterpolationOptions options_;
  int dimension_;
  std::vector<double> positions_, smoothing_length_, volume_;
  std::vector<CellOf> order_;  // ascending
  double origin_[3] = {0.0, 0.0, 0.0};
  double cell_size_ = 1.0;
};

/// The median distance of particles to their nearest neighbour, m, from some thousand of them; 0 for a single particle.
/// `positions`: 3 numbers per particle.
double usual_spacing(std::span<const double> positions, int dimension);

}  // namespace anvil
