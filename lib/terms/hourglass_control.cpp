// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/terms/hourglass_control.hpp"

#include <cmath>
#include <variant>

#include "anvil/core/field_keys.hpp"
#include "anvil/pairs/neighbour_list.hpp"

namespace anvil {

template <int D>
HourglassControl<D>::HourglassControl(FieldStore& fields, const Deformation<D>& deformation, const Kernel& kernel,
                                      const std::vector<Stiffness>& bodies, Images<D> images)
    : position_(fields.vector<D>(field::position)),
      initial_position_(fields.vector<D>(field::initial_position)),
      velocity_(fields.vector<D>(field::velocity)),
      last_((fields.require(field::hourglass_acceleration, D), fields.vector<D>(field::hourglass_acceleration).raw())),
      deformation_(deformation),
      kernel_(kernel),
      first_pair_(1, 0) {
  const auto smoothing_length = fields.scalar(field::smoothing_length);
  const std::size_t particles = fields.particle_count();
  double longest = 0.0;
  for (const double h : smoothing_length) longest = std::max(longest, h);
  const double support = std::visit([](const auto& chosen) { return chosen.support; }, kernel);
  if (images.possible()) images.find(initial_position_, smoothing_length, support * longest);
  NeighbourList<D> near;
  near.build(initial_position_, smoothing_length, support, 0.0, pair_loops<D>(), images.sites());
  for (std::size_t g = 0; g < images.count(); ++g) transforms_.push_back(images.transform(g));
  for (const Stiffness& stiffness : bodies) {
    for (std::size_t i = stiffness.body.first(); i < stiffness.body.last(); ++i) {
      for (std::int64_t k = near.row_begin(i); k < near.row_end(i); ++k) {
        const auto j = static_cast<std::size_t>(near.neighbours()[k]);
        if (j == particles) continue;  // padding
        const bool image = j > particles;
        const std::size_t source = image ? images.source(j - particles - 1) : j;
        if (source < stiffness.body.first() || source >= stiffness.body.last()) continue;
        add_pair(i, source, image ? static_cast<std::int32_t>(j - particles - 1) : -1, stiffness.modulus,
                 smoothing_length);
      }
      first_pair_.push_back(pairs_.size());
    }
  }
}

template <int D>
void HourglassControl<D>::add_pair(std::size_t i, std::size_t j, std::int32_t transform, double modulus,
                                   std::span<const double> smoothing_length) {
  Vec<D> other = initial_position_[j];
  if (transform >= 0) other = transforms_[static_cast<std::size_t>(transform)](other);
  const Vec<D> start = initial_position_[i] - other;
  const double distance = start.norm(), h = 0.5 * (smoothing_length[i] + smoothing_length[j]);
  if (distance < 1e-6 * h) return;  // a particle on a symmetry plane and itself
  const double value = std::visit(
      [&]<class K>(const K&) { return K::normalisation(D) / std::pow(h, D) * K::value(distance / h); }, kernel_);
  const double weight =
      deformation_.volume(j) * value / (distance * distance) * modulus / deformation_.reference_density(i);
  pairs_.push_back({static_cast<std::int32_t>(j), transform, start, weight});
}

template <int D>
Vec<D> HourglassControl<D>::pull(std::size_t i, const Pair& pair) const {
  const auto j = static_cast<std::size_t>(pair.other);
  Vec<D> other = position_[j];
  Vec<D> predicted = deformation_.gradient(i) * pair.start;
  if (pair.transform < 0) {
    predicted += deformation_.gradient(j) * pair.start;
  } else {
    const Transform<D>& transform = transforms_[static_cast<std::size_t>(pair.transform)];
    other = transform(other);
    predicted += transform.turn * (deformation_.gradient(j) * (transform.turn.transpose() * pair.start));
  }
  const Vec<D> apart = position_[i] - other;
  const Vec<D> error = 0.5 * predicted - apart;
  return pair.weight * error.dot(apart) / apart.squaredNorm() * apart;
}

template <int D>
void HourglassControl<D>::accumulate(const PairTile<D>& tile, const PairRecords<D>& /*records*/, double* acceleration,
                                     double* loss) const {
  for (auto i = static_cast<std::size_t>(tile.begin); i < static_cast<std::size_t>(tile.end);
       ++i, acceleration += D, ++loss) {
    Vec<D> sum = Vec<D>::Zero();
    for (std::size_t k = first_pair_[i]; k < first_pair_[i + 1]; ++k) sum += pull(i, pairs_[k]);
    Eigen::Map<Vec<D>> last(last_ + i * D), all(acceleration);
    const Vec<D> velocity = velocity_[i];
    *loss -= 0.5 * (sum + last).dot(velocity);
    last = sum;
    all += sum;
  }
}

template class HourglassControl<1>;
template class HourglassControl<2>;
template class HourglassControl<3>;

}  // namespace anvil
