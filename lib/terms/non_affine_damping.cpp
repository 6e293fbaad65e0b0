// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/terms/non_affine_damping.hpp"

namespace anvil {
namespace {

template <int D>
using ConstTensor = Eigen::Map<const Eigen::Matrix<double, D, D, D == 1 ? Eigen::ColMajor : Eigen::RowMajor>>;

}  // namespace

template <int D>
void NonAffineDamping<D>::accumulate(const PairTile<D>& tile, const PairRecords<D>& records, double* acceleration,
                                     double* loss) const {
  const auto place = [&](std::size_t i) { return Eigen::Map<const Vec<D>>(records.geometry[i]); };
  const auto velocity = [&](std::size_t i) { return Eigen::Map<const Vec<D>>(records.motion[i]); };
  const auto gradient = [&](std::size_t i) { return ConstTensor<D>(records.slope[i] + SlopeField<D>::velocity); };
  for (auto i = static_cast<std::size_t>(tile.begin); i < static_cast<std::size_t>(tile.end);
       ++i, acceleration += D, ++loss) {
    Eigen::Map<Vec<D>> sum(acceleration);
    const double *medium = records.medium[i], h = records.geometry[i][D];
    for (std::int64_t k = tile.first[i]; k < tile.first[i + 1]; ++k) {
      const auto j = static_cast<std::size_t>(tile.neighbour[k]);
      const double* other = records.medium[j];
      if (other[2] == 0.0) continue;  // padding
      Vec<D> grad;
      for (std::size_t a = 0; a < D; ++a)
        grad[static_cast<int>(a)] = tile.plain_gradient[a][k - tile.first[tile.begin]];
      if (grad.isZero(0.0)) continue;  // beyond the support
      const Vec<D> x = place(i) - place(j), v = velocity(i) - velocity(j);
      const double approach = x.dot(v - 0.5 * (gradient(i) + gradient(j)) * x);
      const double mean_h = 0.5 * (h + records.geometry[j][D]);
      const double mu = mean_h * approach / (x.squaredNorm() + 0.01 * mean_h * mean_h);
      const double weight = -coefficient_ * other[2] * (medium[0] + other[0]) * mu / (medium[1] + other[1]);
      sum -= weight * grad;
      *loss += 0.5 * weight * v.dot(grad);
    }
  }
}

template class NonAffineDamping<1>;
template class NonAffineDamping<2>;
template class NonAffineDamping<3>;

}  // namespace anvil
