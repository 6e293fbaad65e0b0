// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/kernels/lattice_sum.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

/// sum of -x^2 (dw/dq)/q over the lattice points (x, y, z) around the origin, in units of the spacing.
template <class K>
double second_moment(int dimension, double gamma) {
  const int reach = static_cast<int>(std::ceil(K::support * gamma));
  const int reach_y = dimension >= 2 ? reach : 0;
  const int reach_z = dimension == 3 ? reach : 0;
  double sum = 0.0;
  for (int z = -reach_z; z <= reach_z; ++z) {
    for (int y = -reach_y; y <= reach_y; ++y) {
      // x and -x contribute the same, x = 0 nothing.
      for (int x = 1; x <= reach; ++x) {
        const double q = std::sqrt(static_cast<double>(x * x + y * y + z * z)) / gamma;
        sum -= 2.0 * x * x * K::slope_over_q(q);
      }
    }
  }
  return sum;
}

/// |sum of x (dw/dq)/q sin(kappa . x)| over the lattice, in units of the spacing; `components` of kappa are `wave`.
template <class K>
double gradient_of_wave(int dimension, double gamma, double wave, int components) {
  const int reach = static_cast<int>(std::ceil(K::support * gamma));
  const int reach_y = dimension >= 2 ? reach : 0;
  const int reach_z = dimension == 3 ? reach : 0;
  double sum[3] = {0.0, 0.0, 0.0};
  for (int z = -reach_z; z <= reach_z; ++z)
    for (int y = -reach_y; y <= reach_y; ++y)
      for (int x = -reach; x <= reach; ++x) {
        if (x == 0 && y == 0 && z == 0) continue;
        const int along = x + (components > 1 ? y : 0) + (components > 2 ? z : 0);
        const double q = std::sqrt(static_cast<double>(x * x + y * y + z * z)) / gamma;
        const double weight = K::slope_over_q(q) * std::sin(wave * along);
        sum[0] += x * weight;
        sum[1] += y * weight;
        sum[2] += z * weight;
      }
  return std::hypot(sum[0], sum[1], sum[2]);
}

template <class K>
double largest_gradient(int dimension, double gamma) {
  constexpr int waves = 200;
  constexpr double pi = 3.14159265358979323846;
  double largest = 0.0;
  for (int components = 1; components <= dimension; ++components)
    for (int k = 1; k <= waves; ++k)
      largest = std::max(largest, gradient_of_wave<K>(dimension, gamma, pi * k / waves, components));
  return largest;
}

void check_lattice(int dimension, double gamma) {
  if (dimension < 1 || dimension > 3) throw InputError("a lattice has 1, 2 or 3 dimensions");
  if (!(gamma > 0.0) || gamma > 100.0) {
    throw InputError("the smoothing length over the spacing must lie between 0 and 100");
  }
}

}  // namespace

double lattice_wave_speed_factor(const Kernel& kernel, int dimension, double gamma) {
  check_lattice(dimension, gamma);
  return std::visit(
      [&]<class K>(const K&) {
        return K::normalisation(dimension) * second_moment<K>(dimension, gamma) / std::pow(gamma, dimension + 2);
      },
      kernel);
}

double largest_stable_cfl(const Kernel& kernel, int dimension, double gamma, bool corrected) {
  check_lattice(dimension, gamma);
  const double largest = std::visit(
      [&]<class K>(const K&) {
        return K::normalisation(dimension) * largest_gradient<K>(dimension, gamma) / std::pow(gamma, dimension + 2);
      },
      kernel);
  return 2.0 / (gamma * largest) * (corrected ? lattice_wave_speed_factor(kernel, dimension, gamma) : 1.0);
}

}  // namespace anvil
