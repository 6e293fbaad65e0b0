// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "anvil/core/field_keys.hpp"
#include "anvil/kernels/kernel.hpp"
#include "anvil/pairs/neighbour_list.hpp"

namespace anvil {

template <int D>
struct Dimension {
  static constexpr int value = D;
};
using Dimensions = testing::Types<Dimension<1>, Dimension<2>, Dimension<3>>;

/// Tests in 1, 2 and 3 dimensions.
template <class T>
class InEachDimension : public testing::Test {};

/// A lattice of per_axis^D points, each moved by up to `jitter` spacings per axis.
template <int D>
std::vector<Vec<D>> jittered_lattice(int per_axis, double spacing, double jitter) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::size_t count = 1;
  for (int a = 0; a < D; ++a) count *= static_cast<std::size_t>(per_axis);
  std::vector<Vec<D>> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t rest = i;
    for (int a = 0; a < D; ++a, rest /= static_cast<std::size_t>(per_axis))
      points[i][a] = spacing * (static_cast<double>(rest % static_cast<std::size_t>(per_axis)) + jitter * unit(random));
  }
  return points;
}

/// What the scalar loops of the tests read of a pair: x_ij = x_i - x_j, v_ij, the mean smoothing length, W_ij, grad_ij.
template <int D>
struct ScalarPair {
  Vec<D> x, v, gradient;
  double h, value;
};

/// The D x D matrix of packed components XX | XX YY XY | XX YY ZZ XY YZ XZ.
template <int D>
Mat<D> symmetric_matrix(const double* packed) {
  Mat<D> full = Mat<D>::Zero();
  for (int a = 0; a < D; ++a) full(a, a) = packed[a];
  if constexpr (D == 2) full(0, 1) = full(1, 0) = packed[2];
  if constexpr (D == 3) {
    full(0, 1) = full(1, 0) = packed[3];
    full(1, 2) = full(2, 1) = packed[4];
    full(0, 2) = full(2, 0) = packed[5];
  }
  return full;
}

/// Particles with unlike smoothing lengths, masses, densities, velocities and stresses, their neighbour list, and what
/// a pair loop is called with.
template <int D>
struct Cloud {
  static constexpr int components = symmetric_components<D>;
  static constexpr double spacing = 1e-3;  // m
  static constexpr int per_axis = D == 1 ? 40 : (D == 2 ? 12 : 7);

  explicit Cloud(const Kernel& kernel_used = CubicSpline())
      : Cloud(kernel_used, jittered_lattice<D>(per_axis, spacing, 0.2)) {}

  Cloud(const Kernel& kernel_used, const std::vector<Vec<D>>& positions)
      : kernel(kernel_used), count(positions.size()), fields(count) {
    for (const FieldKey* key : {&field::position, &field::velocity}) fields.require(*key, D);
    for (const FieldKey* key : {&field::mass, &field::density, &field::smoothing_length, &field::pressure})
      fields.require(*key);
    fields.require(field::deviatoric_stress, components);
    for (std::size_t i = 0; i < count; ++i) position()[i] = positions[i];
    fill_with_random_numbers();
    list.build(position(), fields.scalar(field::smoothing_length), support(), 0.3 * spacing, pair_loops<D>());
    pack();
  }

  [[nodiscard]] VectorView<D> position() { return fields.template vector<D>(field::position); }
  [[nodiscard]] VectorView<D> velocity() { return fields.template vector<D>(field::velocity); }
  [[nodiscard]] double* deviator(std::size_t i) {
    return fields.template vector<components>(field::deviatoric_stress).raw() + i * components;
  }
  [[nodiscard]] double scalar(const FieldKey& key, std::size_t i) const { return fields.scalar(key)[i]; }
  [[nodiscard]] double volume(std::size_t i) const { return scalar(field::mass, i) / scalar(field::density, i); }
  [[nodiscard]] double support() const {
    return std::visit([](const auto& chosen) { return chosen.support; }, kernel);
  }

  /// The stress of a particle as a D x D matrix.
  [[nodiscard]] Mat<D> stress(std::size_t i) {
    return symmetric_matrix<D>(deviator(i)) - scalar(field::pressure, i) * Mat<D>::Identity();
  }

  [[nodiscard]] ScalarPair<D> pair(std::size_t i, std::size_t j) {
    ScalarPair<D> result;
    result.x = position()[i] - position()[j];
    result.v = velocity()[i] - velocity()[j];
    result.h = 0.5 * (scalar(field::smoothing_length, i) + scalar(field::smoothing_length, j));
    const double q = result.x.norm() / result.h;
    std::visit(
        [&]<class K>(const K&) {
          const double scale = K::normalisation(D) / std::pow(result.h, D);
          result.value = scale * K::value(q);
          result.gradient = scale / (result.h * result.h) * K::slope_over_q(q) * result.x;
        },
        kernel);
    return result;
  }

  /// Writes the records as they follow from the fields: after a change of velocities, for example.
  void pack() {
    records.geometry.resize(count);
    records.motion.resize(count);
    records.traction.resize(count);
    records.medium.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      for (int a = 0; a < D; ++a) {
        records.geometry[i][a] = position()[i][a];
        records.motion[i][a] = velocity()[i][a];
      }
      records.geometry[i][D] = scalar(field::smoothing_length, i);
      records.motion[i][D] = volume(i);
      records.medium[i][0] = sound_speed[i];
      records.medium[i][1] = scalar(field::density, i);
      records.medium[i][2] = scalar(field::mass, i);
    }
    std::fill_n(records.geometry[count], D, padding_distance);
    records.geometry[count][D] = 1.0;
    records.medium[count][1] = 1.0;
  }

  /// The particles begin .. end-1 as a tile with gradients and values.
  PairTile<D> tile(std::size_t begin, std::size_t end) {
    PairTile<D> opened;
    opened.begin = static_cast<std::int32_t>(begin);
    opened.end = static_cast<std::int32_t>(end);
    opened.first = list.first();
    opened.neighbour = list.neighbours();
    const auto pairs = static_cast<std::size_t>(list.row_begin(end) - list.row_begin(begin));
    for (std::size_t a = 0; a < D; ++a) {
      gradient[a].assign(pairs, 0.0);
      opened.gradient[a] = opened.plain_gradient[a] = gradient[a].data();
    }
    value.assign(pairs, 0.0);
    opened.value = value.data();
    pair_loops<D>().kernels[kernel.index()].both(opened, records);
    return opened;
  }
  PairTile<D> tile() { return tile(0, count); }

  Kernel kernel;
  std::size_t count;
  FieldStore fields;
  std::vector<double> sound_speed;
  NeighbourList<D> list;
  PairRecords<D> records;
  std::vector<double> gradient[D], value;

 private:
  void fill_with_random_numbers() {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (std::size_t i = 0; i < count; ++i) {
      fields.scalar(field::smoothing_length)[i] = 1.2 * spacing * (1.0 + 0.1 * unit(random));
      fields.scalar(field::density)[i] = 8000.0 * (1.0 + 0.1 * unit(random));
      fields.scalar(field::mass)[i] = 8000.0 * std::pow(spacing, D) * (1.0 + 0.1 * unit(random));
      fields.scalar(field::pressure)[i] = 1e9 * unit(random);
      for (int c = 0; c < components; ++c) deviator(i)[c] = 1e9 * unit(random);
      for (int a = 0; a < D; ++a) velocity()[i][a] = 100.0 * unit(random);
      sound_speed.push_back(5000.0 * (1.0 + 0.1 * unit(random)));
    }
  }
};

}  // namespace anvil
