// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "anvil/core/error.hpp"
#include "anvil/core/simd_level.hpp"

namespace anvil {
namespace {

/// Skips a whole test program where this machine cannot run the instruction set ANVIL_SIMD asks for.
class SimdEnvironment : public testing::Environment {
  void SetUp() override {
    try {
      (void)simd_level();
    } catch (const InputError& error) {
      GTEST_SKIP() << error.what();
    }
  }
};

[[maybe_unused]] const auto* const environment = testing::AddGlobalTestEnvironment(new SimdEnvironment);

}  // namespace
}  // namespace anvil
