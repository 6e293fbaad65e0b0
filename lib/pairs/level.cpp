// SPDX-License-Identifier: BSD-3-Clause
// Compiled once per instruction set: the pair loops of one level, handed out as tables of functions. The tables are
// constants, so that nothing of a level runs before the program has asked the processor what it can do.
#include "anvil/pairs/collect_loop.hpp"
#include "anvil/pairs/correction_loop.hpp"
#include "anvil/pairs/gradient_loop.hpp"
#include "anvil/pairs/line_loop.hpp"
#include "anvil/pairs/pair_loops.hpp"
#include "anvil/terms/density_diffusion_loop.hpp"
#include "anvil/terms/hllc_loop.hpp"
#include "anvil/terms/laminar_viscosity_loop.hpp"
#include "anvil/terms/momentum_loop.hpp"
#include "anvil/terms/nominal_momentum_loop.hpp"
#include "anvil/terms/smoothing_loop.hpp"
#include "anvil/terms/velocity_gradient_loop.hpp"
#include "anvil/terms/viscosity_loop.hpp"

namespace anvil::ANVIL_SIMD_LEVEL {
namespace {

template <int D, class SomeKernel>
constexpr typename PairLoops<D>::KernelLoops loops_of() {
  typename PairLoops<D>::KernelLoops loops{.gradients = &fill_pairs<D, SomeKernel, true, false>,
                                           .values = &fill_pairs<D, SomeKernel, false, true>,
                                           .both = &fill_pairs<D, SomeKernel, true, true>};
  if constexpr (D == 1) {
    loops.corrected_gradients = &fill_corrected_line<SomeKernel>;
    loops.corrected_velocity_gradient = &sum_line_velocity_gradient<SomeKernel>;
  }
  return loops;
}

template <int D, std::size_t... Index>
constexpr auto kernel_loops(std::index_sequence<Index...>) {
  return std::array<typename PairLoops<D>::KernelLoops, sizeof...(Index)>{
      loops_of<D, std::variant_alternative_t<Index, Kernel>>()...};
}

template <int D>
constexpr PairLoops<D> table() {
  return {.lanes = lanes<D>,
          .kernels = kernel_loops<D>(std::make_index_sequence<std::variant_size_v<Kernel>>()),
          .collect = &collect_neighbours<D>,
          .correct_gradients = &correct_gradients<D>,
          .velocity_gradient = &sum_velocity_gradient<D>,
          .momentum = &sum_momentum<D, false>,
          .stress_difference = &sum_momentum<D, true>,
          .nominal_momentum = &sum_nominal_momentum<D>,
          .viscosity = &sum_viscosity<D>,
          .laminar_viscosity = &sum_laminar_viscosity<D>,
          .density_diffusion = &sum_density_diffusion<D>,
          .hllc = &sum_hllc<D>,
          .plain_smoothing = &sum_plain_smoothing<D>,
          .pairwise_smoothing = &sum_pairwise_smoothing<D>};
}

}  // namespace

extern constinit const PairLoops<1> pair_loops_1d = table<1>();
extern constinit const PairLoops<2> pair_loops_2d = table<2>();
extern constinit const PairLoops<3> pair_loops_3d = table<3>();

}  // namespace anvil::ANVIL_SIMD_LEVEL
