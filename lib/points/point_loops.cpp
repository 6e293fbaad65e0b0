// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/points/point_loops.hpp"

#include <tuple>

#include "anvil/core/simd_level.hpp"

#define ANVIL_DECLARE(level)                 \
  namespace anvil::level {                   \
  extern const PointLoops<1> point_loops_1d; \
  extern const PointLoops<2> point_loops_2d; \
  extern const PointLoops<3> point_loops_3d; \
  }
ANVIL_FOR_EACH_SIMD_LEVEL(ANVIL_DECLARE)

namespace anvil {
namespace {

using EachDimension = std::tuple<const PointLoops<1>*, const PointLoops<2>*, const PointLoops<3>*>;
#define ANVIL_ENTRY(level) {&level::point_loops_1d, &level::point_loops_2d, &level::point_loops_3d},
constexpr EachDimension loops_by_level[] = {ANVIL_FOR_EACH_SIMD_LEVEL(ANVIL_ENTRY)};

}  // namespace

template <int D>
const PointLoops<D>& point_loops() {
  return *std::get<const PointLoops<D>*>(loops_by_level[simd_level_index()]);
}
template const PointLoops<1>& point_loops<1>();
template const PointLoops<2>& point_loops<2>();
template const PointLoops<3>& point_loops<3>();

}  // namespace anvil
