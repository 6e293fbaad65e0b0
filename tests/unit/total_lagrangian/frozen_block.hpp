// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>
#include <vector>

#include "anvil/core/field_keys.hpp"
#include "anvil/kernels/kernel.hpp"
#include "anvil/pairs/neighbour_list.hpp"
#include "anvil/total_lagrangian/deformation.hpp"
#include "anvil/total_lagrangian/edge_points.hpp"
#include "unit/pairs/cloud.hpp"

namespace anvil {

/// A block of particles on the corners of cells, with the pairs, gradients and corrections of its start frozen.
template <int D>
struct FrozenBlock {
  static constexpr double spacing = 1e-3;    // m
  static constexpr double density = 8000.0;  // kg/m3
  static constexpr int per_axis = D == 3 ? 5 : 7;

  FrozenBlock() : start(jittered_lattice<D>(per_axis, spacing, 0.0)), count(start.size()), fields(make_fields()) {
    list.build(fields.template vector<D>(field::initial_position), std::vector<double>(count, 0.8 * spacing), 2.0, 0.0,
               pair_loops<D>());
    records.resize(count, {.nominal = true});
    for (std::size_t i = 0; i < count; ++i) {
      for (int a = 0; a < D; ++a) records.geometry[i][a] = start[i][a];
      records.geometry[i][D] = 0.8 * spacing;
      records.motion[i][D] = fields.scalar(field::mass)[i] / density;
    }
    for (std::size_t a = 0; a < D; ++a) gradient[a].assign(static_cast<std::size_t>(list.first()[count]), 0.0);
    pair_loops<D>().kernels[Kernel(CubicSpline()).index()].gradients(tile(), records);
    uncorrected = deformation.find_corrections(tile(), records);
  }

  /// Half of a cell's volume on faces, a quarter on edges, an eighth in corners.
  FieldStore make_fields() {
    FieldStore store(count);
    for (const FieldKey* key : {&field::position, &field::initial_position, &field::velocity}) store.require(*key, D);
    for (const FieldKey* key : {&field::mass, &field::density, &field::pressure}) store.require(*key);
    for (std::size_t i = 0; i < count; ++i) {
      double volume = std::pow(spacing, D);
      for (int a = 0; a < D; ++a) {
        const double cell = start[i][a] / spacing;
        if (cell < 0.5 || cell > per_axis - 1.5) volume *= 0.5;
      }
      store.template vector<D>(field::position)[i] = store.template vector<D>(field::initial_position)[i] = start[i];
      store.scalar(field::density)[i] = density;
      store.scalar(field::mass)[i] = density * volume;
    }
    return store;
  }

  PairTile<D> tile() {
    PairTile<D> opened;
    opened.end = static_cast<std::int32_t>(count);
    opened.first = list.first();
    opened.neighbour = list.neighbours();
    for (std::size_t a = 0; a < D; ++a) opened.gradient[a] = opened.plain_gradient[a] = gradient[a].data();
    return opened;
  }

  [[nodiscard]] ParticleRange all() const { return {0, static_cast<std::int32_t>(count)}; }
  VectorView<D> position() { return fields.template vector<D>(field::position); }
  VectorView<D> velocity() { return fields.template vector<D>(field::velocity); }

  /// Moves everything at its velocity for time_step (s); returns the velocity gradients in the middle of the step.
  std::vector<double> move(double time_step) {
    for (std::size_t i = 0; i < count; ++i) {
      for (int a = 0; a < D; ++a) records.motion[i][a] = velocity()[i][a];
      position()[i] += time_step * velocity()[i];
    }
    std::vector<double> gradients(count * D * D);
    pair_loops<D>().velocity_gradient(tile(), records, gradients.data());
    deformation.advance(all(), gradients.data(), time_step);
    return gradients;
  }

  void move_at_random(double time_step, double speed) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (std::size_t i = 0; i < count; ++i)
      for (int a = 0; a < D; ++a) velocity()[i][a] = speed * unit(random);
    (void)move(time_step);
  }

  std::vector<Vec<D>> start;
  std::size_t count;
  FieldStore fields;
  Deformation<D> deformation{fields};
  NeighbourList<D> list;
  PairRecords<D> records;
  std::vector<double> gradient[D];
  int uncorrected = -1;
};

}  // namespace anvil
