// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace anvil {

/// Vectors and square matrices of D components. They stand unaligned in arrays, so that a field of them is one plain
/// run of doubles. `Vec<D>{}` is not zero: use `Vec<D>::Zero()`.
template <int D>
using Vec = Eigen::Matrix<double, D, 1, Eigen::DontAlign>;
template <int D>
using Mat = Eigen::Matrix<double, D, D, Eigen::DontAlign>;

/// A full tensor in three dimensions; what material laws see, whatever the dimension of the scene.
using Tensor = Mat<3>;

}  // namespace anvil
