// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/exact/poiseuille.hpp"

#include <cmath>
#include <numbers>

namespace anvil {

double PoiseuilleFlow::velocity(double y, double time) const {
  constexpr double pi = std::numbers::pi;
  double sum = acceleration / (2.0 * kinematic_viscosity) * y * (width - y);
  for (int n = 0; n < 100000; ++n) {
    const double odd = 2.0 * n + 1.0;
    const double decay = std::exp(-odd * odd * pi * pi * kinematic_viscosity * time / (width * width));
    const double size =
        4.0 * acceleration * width * width / (kinematic_viscosity * pi * pi * pi * odd * odd * odd) * decay;
    sum -= size * std::sin(pi * odd * y / width);
    if (size < 1e-17 * acceleration * width * width / kinematic_viscosity) break;
  }
  return sum;
}

}  // namespace anvil
