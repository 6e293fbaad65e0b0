// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/core/tensor.hpp"
#include "anvil/pairs/records.hpp"

namespace anvil {

/// Where the image of a particle stands and how what it carries is turned: x -> turn x + shift, vectors v -> turn v,
/// tensors T -> turn T turn^T. `turn` is orthogonal: a reflection, a rotation or the identity.
template <int D>
struct Transform {
  Mat<D> turn = Mat<D>::Identity();
  Vec<D> shift = Vec<D>::Zero();  // m
  // Velocities are turned by it instead: the same as `turn`, or minus the identity behind a wall without slip.
  Mat<D> velocity_turn = Mat<D>::Identity();

  [[nodiscard]] Vec<D> operator()(const Vec<D>& position) const { return turn * position + shift; }
};

/// first after second.
template <int D>
Transform<D> operator*(const Transform<D>& first, const Transform<D>& second) {
  return {first.turn * second.turn, first.turn * second.shift + first.shift,
          first.velocity_turn * second.velocity_turn};
}

/// out = turn in, D components each; `in` and `out` are different memory.
template <int D>
void turn_vector(const Mat<D>& turn, const double* in, double* out) {
  Eigen::Map<Vec<D>>(out).noalias() = turn * Eigen::Map<const Vec<D>>(in);
}

/// out = turn in turn^T for any D x D tensor, row first; `in` and `out` are different memory.
template <int D>
void turn_tensor(const Mat<D>& turn, const double* in, double* out) {
  // Column-major maps see the transposed tensors, which turn alike.
  const Mat<D> turned = turn * Eigen::Map<const Mat<D>>(in) * turn.transpose();
  Eigen::Map<Mat<D>> result(out);
  result = turned;
}

/// Row and column of the components of a packed symmetric tensor, XX | XX YY XY | XX YY ZZ XY YZ XZ.
template <int D>
inline constexpr int symmetric_row[] = {0, 1, D == 2 ? 0 : 2, 0, 1, 0};
template <int D>
inline constexpr int symmetric_column[] = {0, 1, D == 2 ? 1 : 2, 1, 2, 2};

template <int D>
Mat<D> unpack_symmetric(const double* in) {
  Mat<D> tensor;
  for (int c = 0; c < symmetric_components<D>; ++c) {
    const int a = symmetric_row<D>[c], b = symmetric_column<D>[c];
    tensor(a, b) = tensor(b, a) = in[c];
  }
  return tensor;
}

/// out = turn in turn^T for a packed symmetric tensor.
template <int D>
void turn_symmetric(const Mat<D>& turn, const double* in, double* out) {
  const Mat<D> turned = turn * unpack_symmetric<D>(in) * turn.transpose();
  for (int c = 0; c < symmetric_components<D>; ++c) out[c] = turned(symmetric_row<D>[c], symmetric_column<D>[c]);
}

}  // namespace anvil
