// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/total_lagrangian/deformation.hpp"

#include <Eigen/LU>
#include <cmath>

#include "anvil/core/field_keys.hpp"

namespace anvil {

template <int D>
Deformation<D>::Deformation(FieldStore& fields)
    : gradient_((fields.require(field::deformation_gradient, D * D),
                 fields.vector<D * D>(field::deformation_gradient).raw())),
      mass_(fields.scalar(field::mass)),
      density_(fields.scalar(field::density)),
      reference_density_(density_.begin(), density_.end()),
      volume_(fields.particle_count()),
      correction_(fields.particle_count() * D * D) {
  for (std::size_t i = 0; i < fields.particle_count(); ++i) {
    volume_[i] = mass_[i] / density_[i];
    SquareMap<D>(gradient_ + i * D * D).setIdentity();
    SquareMap<D>(&correction_[i * D * D]).setIdentity();
  }
}

template <int D>
int Deformation<D>::find_corrections(const PairTile<D>& tile, const PairRecords<D>& records) {
  // As for the corrections of every step: see correction_loop.hpp.
  constexpr double least_moment = 1e-2;
  int uncorrected = 0;
  for (std::int32_t i = tile.begin; i < tile.end; ++i) {
    Square<D> moment = Square<D>::Zero();
    const double* own = records.geometry[static_cast<std::size_t>(i)];
    for (std::int64_t k = tile.first[i]; k < tile.first[i + 1]; ++k) {
      const auto j = static_cast<std::size_t>(tile.neighbour[k]);
      const double* other = records.geometry[j];
      const double volume = records.motion[j][D];
      if (volume == 0.0) continue;  // padding
      const auto pair = static_cast<std::size_t>(k - tile.first[tile.begin]);
      for (int a = 0; a < D; ++a)
        for (int b = 0; b < D; ++b)
          moment(a, b) += volume * (other[a] - own[a]) * tile.plain_gradient[static_cast<std::size_t>(b)][pair];
    }
    SquareMap<D> correction(&correction_[static_cast<std::size_t>(i) * D * D]);
    const double mean = moment.trace() / D;
    if (mean > least_moment && moment.determinant() > least_moment * std::pow(mean, D))
      correction = moment.inverse();
    else
      ++uncorrected;
  }
  return uncorrected;
}

template <int D>
void Deformation<D>::advance(ParticleRange range, double* gradients, double time_step) {
  point_loops<D>().advance_deformation(range, gradients, time_step, arrays());
}

template <int D>
void Deformation<D>::find_least_stretches(ParticleRange range, double* stretch) const {
  point_loops<D>().find_least_stretches(range, arrays(), stretch);
}

template class Deformation<1>;
template class Deformation<2>;
template class Deformation<3>;

}  // namespace anvil
