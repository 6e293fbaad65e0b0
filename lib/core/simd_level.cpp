// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/core/simd_level.hpp"

#include <hwy/targets.h>

#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <string>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

// Highway's bits for the instruction sets.
[[maybe_unused]] constexpr std::int64_t bit_of_avx512 = HWY_AVX3, bit_of_avx2 = HWY_AVX2;
constexpr std::int64_t bit_of_baseline = 0;  // any machine

struct Level {
  const char* name;
  std::int64_t bit;
};

#define ANVIL_LEVEL(level) {#level, bit_of_##level},
constexpr Level levels[] = {ANVIL_FOR_EACH_SIMD_LEVEL(ANVIL_LEVEL)};

std::size_t choose_level() {
  const std::int64_t present = hwy::SupportedTargets();
  const char* wish = std::getenv("ANVIL_SIMD");
  std::string usable;
  for (std::size_t k = 0; k < std::size(levels); ++k) {
    if (levels[k].bit != 0 && (present & levels[k].bit) == 0) continue;
    if (wish == nullptr || *wish == '\0' || std::string(wish) == levels[k].name) return k;
    usable += (usable.empty() ? "" : ", ") + std::string(levels[k].name);
  }
  throw InputError("environment variable ANVIL_SIMD is '" + std::string(wish) + "'; this machine can run " + usable);
}

}  // namespace

std::size_t simd_level_index() {
  static const std::size_t chosen = choose_level();
  return chosen;
}

const char* simd_level() { return levels[simd_level_index()].name; }

}  // namespace anvil
