// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/points/point_loops.hpp"

#include <string_view>
#include <tuple>

#include "anvil/pairs/pair_loops.hpp"

#define ANVIL_DECLARE_LEVEL(level)           \
  namespace anvil::level {                   \
  extern const PointLoops<1> point_loops_1d; \
  extern const PointLoops<2> point_loops_2d; \
  extern const PointLoops<3> point_loops_3d; \
  }
#define ANVIL_LEVEL(level)                                                             \
  {                                                                                    \
#level, { &level::point_loops_1d, &level::point_loops_2d, &level::point_loops_3d } \
  }

ANVIL_DECLARE_LEVEL(baseline)
#ifdef ANVIL_HAS_avx2
ANVIL_DECLARE_LEVEL(avx2)
#endif
#ifdef ANVIL_HAS_avx512
ANVIL_DECLARE_LEVEL(avx512)
#endif

namespace anvil {
namespace {

struct Level {
  std::string_view name;
  std::tuple<const PointLoops<1>*, const PointLoops<2>*, const PointLoops<3>*> loops;
};

constexpr Level levels[] = {
#ifdef ANVIL_HAS_avx512
    ANVIL_LEVEL(avx512),
#endif
#ifdef ANVIL_HAS_avx2
    ANVIL_LEVEL(avx2),
#endif
    ANVIL_LEVEL(baseline),
};

const Level& find_level() {
  const std::string_view chosen = simd_level();
  const Level* level = levels;
  while (level->name != chosen) ++level;  // the same levels as those of pair loops
  return *level;
}

}  // namespace

template <int D>
const PointLoops<D>& point_loops() {
  static const Level& level = find_level();
  return *std::get<const PointLoops<D>*>(level.loops);
}
template const PointLoops<1>& point_loops<1>();
template const PointLoops<2>& point_loops<2>();
template const PointLoops<3>& point_loops<3>();

}  // namespace anvil
