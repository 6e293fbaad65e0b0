// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/kernels/lattice_sum.hpp"

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

}  // namespace

double lattice_wave_speed_factor(const Kernel& kernel, int dimension, double gamma) {
  if (dimension < 1 || dimension > 3) throw InputError("a lattice has 1, 2 or 3 dimensions");
  if (!(gamma > 0.0) || gamma > 100.0) {
    throw InputError("the smoothing length over the spacing must lie between 0 and 100");
  }
  return std::visit(
      [&]<class K>(const K&) {
        return K::normalisation(dimension) * second_moment<K>(dimension, gamma) / std::pow(gamma, dimension + 2);
      },
      kernel);
}

}  // namespace anvil
