// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/pairs/pair_loops.hpp"

#include <tuple>

#include "anvil/core/simd_level.hpp"

#define ANVIL_DECLARE(level)               \
  namespace anvil::level {                 \
  extern const PairLoops<1> pair_loops_1d; \
  extern const PairLoops<2> pair_loops_2d; \
  extern const PairLoops<3> pair_loops_3d; \
  }
ANVIL_FOR_EACH_SIMD_LEVEL(ANVIL_DECLARE)

namespace anvil {
namespace {

using EachDimension = std::tuple<const PairLoops<1>*, const PairLoops<2>*, const PairLoops<3>*>;
#define ANVIL_ENTRY(level) {&level::pair_loops_1d, &level::pair_loops_2d, &level::pair_loops_3d},
constexpr EachDimension loops_by_level[] = {ANVIL_FOR_EACH_SIMD_LEVEL(ANVIL_ENTRY)};

}  // namespace

template <int D>
const PairLoops<D>& pair_loops() {
  return *std::get<const PairLoops<D>*>(loops_by_level[simd_level_index()]);
}
template const PairLoops<1>& pair_loops<1>();
template const PairLoops<2>& pair_loops<2>();
template const PairLoops<3>& pair_loops<3>();

}  // namespace anvil
