// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

// DO(level) for each instruction set that loops are compiled for, best first; each has a namespace of its name.
#ifdef ANVIL_HAS_avx512
#define ANVIL_IF_AVX512(DO) DO(avx512)
#else
#define ANVIL_IF_AVX512(DO)
#endif
#ifdef ANVIL_HAS_avx2
#define ANVIL_IF_AVX2(DO) DO(avx2)
#else
#define ANVIL_IF_AVX2(DO)
#endif
#define ANVIL_FOR_EACH_SIMD_LEVEL(DO) ANVIL_IF_AVX512(DO) ANVIL_IF_AVX2(DO) DO(baseline)

namespace anvil {

/// The instruction set in use, part of the provenance since other sets round differently: the best one this machine
/// has, or the lesser one that the environment variable ANVIL_SIMD (baseline, avx2, avx512) asks for; InputError when
/// it names one that cannot run here. Chosen at the first call.
[[nodiscard]] const char* simd_level();
/// The same as its place in ANVIL_FOR_EACH_SIMD_LEVEL.
[[nodiscard]] std::size_t simd_level_index();

}  // namespace anvil
