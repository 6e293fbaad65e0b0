// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "anvil/terms/force_term.hpp"
#include "anvil/terms/velocity_filter.hpp"
#include "unit/pairs/cloud.hpp"

namespace anvil {

/// A sum over pairs and the sum of the magnitudes of its parts, to which round-off is proportional.
template <class Value>
struct ScalarSum {
  Value value = Value::Zero();
  double magnitude = 0.0;
  void add(const Value& part) {
    value += part;
    magnitude += part.norm();
  }
};

/// Sums over some fifty pairs in another order, with fused multiply-adds: each part is rounded a few times.
constexpr double round_off = 1e-13;

/// Accelerations and losses of all particles by one force term.
template <int D>
struct Forces {
  std::vector<Vec<D>> acceleration;
  std::vector<double> loss;
};

template <int D>
Forces<D> forces_of(const ForceTerm<D>& term, Cloud<D>& cloud) {
  term.pack({0, static_cast<std::int32_t>(cloud.count)}, cloud.records);
  Forces<D> forces{std::vector<Vec<D>>(cloud.count, Vec<D>::Zero()), std::vector<double>(cloud.count, 0.0)};
  // Two tiles, so that the offset of a tile into the list is used.
  for (const auto& [begin, end] : {std::pair<std::size_t, std::size_t>{0, 13}, {13, cloud.count}})
    term.accumulate(cloud.tile(begin, end), cloud.records, forces.acceleration[begin].data(), &forces.loss[begin]);
  return forces;
}

template <int D>
std::vector<Vec<D>> changes_by(const VelocityFilter<D>& filter, Cloud<D>& cloud, double time_step) {
  std::vector<Vec<D>> changes(cloud.count);
  for (const auto& [begin, end] : {std::pair<std::size_t, std::size_t>{0, 13}, {13, cloud.count}})
    filter.change(cloud.tile(begin, end), cloud.records, time_step, changes[begin].data());
  return changes;
}

/// Sum of m_i a_i, and the sum of their magnitudes.
template <int D>
ScalarSum<Vec<D>> momentum_of(const Cloud<D>& cloud, const std::vector<Vec<D>>& vectors) {
  ScalarSum<Vec<D>> sum;
  for (std::size_t i = 0; i < cloud.count; ++i) sum.add(cloud.scalar(field::mass, i) * vectors[i]);
  return sum;
}

/// Sum of m_i x_i x a_i in two or three dimensions.
template <int D>
ScalarSum<Vec<3>> angular_momentum_of(Cloud<D>& cloud, const std::vector<Vec<D>>& vectors) {
  ScalarSum<Vec<3>> sum;
  for (std::size_t i = 0; i < cloud.count; ++i) {
    Vec<3> arm = Vec<3>::Zero(), vector = Vec<3>::Zero();
    for (int a = 0; a < D; ++a) {
      arm[a] = cloud.position()[i][a];
      vector[a] = vectors[i][a];
    }
    sum.add(cloud.scalar(field::mass, i) * arm.cross(vector));
  }
  return sum;
}

/// Gives everything the same additional velocity.
template <int D>
void board_a_train(Cloud<D>& cloud) {
  for (std::size_t i = 0; i < cloud.count; ++i) cloud.velocity()[i] += Vec<D>::LinSpaced(500.0, -300.0);
  cloud.pack();
}

}  // namespace anvil
