// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/pairs/pair_loops.hpp"

#include <hwy/targets.h>

#include <cstdlib>
#include <string>
#include <tuple>

#include "anvil/core/error.hpp"

#define ANVIL_DECLARE_LEVEL(level)         \
  namespace anvil::level {                 \
  extern const PairLoops<1> pair_loops_1d; \
  extern const PairLoops<2> pair_loops_2d; \
  extern const PairLoops<3> pair_loops_3d; \
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
  const char* name;
  std::int64_t needs;  // Highway's bit for the instruction set, 0: any machine
  std::tuple<const PairLoops<1>*, const PairLoops<2>*, const PairLoops<3>*> loops;
};

// Best first.
constexpr Level levels[] = {
#ifdef ANVIL_HAS_avx512
    {"avx512", HWY_AVX3, {&avx512::pair_loops_1d, &avx512::pair_loops_2d, &avx512::pair_loops_3d}},
#endif
#ifdef ANVIL_HAS_avx2
    {"avx2", HWY_AVX2, {&avx2::pair_loops_1d, &avx2::pair_loops_2d, &avx2::pair_loops_3d}},
#endif
    {"baseline", 0, {&baseline::pair_loops_1d, &baseline::pair_loops_2d, &baseline::pair_loops_3d}},
};

const Level& choose_level() {
  const std::int64_t present = hwy::SupportedTargets();
  const char* wish = std::getenv("ANVIL_SIMD");
  std::string usable;
  for (const Level& level : levels) {
    if (level.needs != 0 && (present & level.needs) == 0) continue;
    if (wish == nullptr || *wish == '\0' || std::string(wish) == level.name) return level;
    usable += (usable.empty() ? "" : ", ") + std::string(level.name);
  }
  throw InputError("environment variable ANVIL_SIMD is '" + std::string(wish) + "'; this machine can run " + usable);
}

const Level& chosen_level() {
  static const Level& level = choose_level();
  return level;
}

}  // namespace

template <int D>
const PairLoops<D>& pair_loops() {
  return *std::get<const PairLoops<D>*>(chosen_level().loops);
}
template const PairLoops<1>& pair_loops<1>();
template const PairLoops<2>& pair_loops<2>();
template const PairLoops<3>& pair_loops<3>();

const char* simd_level() { return chosen_level().name; }

}  // namespace anvil
