// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace anvil {

/// Points of a line y(x), in the order of a walk along it.
struct Curve {
  std::vector<double> x;
  std::vector<double> y;
};

/// y at `x` by linear interpolation. Where a line turns back and passes `x` several times, the largest y: of an
/// outline, the outermost. At an x it never reaches, the y of its nearer end: under a foot that curls up, that of its
/// rim. The curve must hold a point.
double value_at(const Curve& curve, double x);

/// Distance of a curve from a reference at the abscissae of the reference, relative:
/// sqrt(sum (y - y_ref)^2 / sum y_ref^2).
double relative_distance(const Curve& curve, const Curve& reference);

}  // namespace anvil
