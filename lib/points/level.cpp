// SPDX-License-Identifier: BSD-3-Clause
// Compiled once per instruction set, as the pair loops are: the loops over points of one level.
#include "anvil/materials/strain_deviators_loop.hpp"
#include "anvil/points/point_loops.hpp"
#include "anvil/terms/pack_nominal_loop.hpp"
#include "anvil/total_lagrangian/advance_deformation_loop.hpp"
#include "anvil/total_lagrangian/edge_loops.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {
namespace {

template <int D>
constexpr PointLoops<D> table() {
  return {.lanes = point_lanes,
          .strain_deviators = &strain_deviators<D>,
          .turn_tensors = &turn_tensors<D>,
          .advance_deformation = &advance_deformation<D>,
          .find_least_stretches = &find_least_stretches<D>,
          .deform_edges = &deform_edges<D>,
          .pull_back_edges = &pull_back_edges<D>,
          .sum_edge_forces = &sum_edge_forces<D>,
          .pack_nominal = &pack_nominal<D>};
}

}  // namespace

extern constinit const PointLoops<1> point_loops_1d = table<1>();
extern constinit const PointLoops<2> point_loops_2d = table<2>();
extern constinit const PointLoops<3> point_loops_3d = table<3>();

}  // namespace anvil::ANVIL_SIMD_LEVEL
