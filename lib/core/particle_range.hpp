// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace anvil {

/// A run of consecutive particles.
struct ParticleRange {
  std::int32_t begin = 0, end = 0;
  [[nodiscard]] int count() const { return end - begin; }
  [[nodiscard]] std::size_t first() const { return static_cast<std::size_t>(begin); }
  [[nodiscard]] std::size_t last() const { return static_cast<std::size_t>(end); }  // one behind the last particle
};

}  // namespace anvil
