// SPDX-License-Identifier: BSD-3-Clause
// Water that is pushed into a mould: what the gate brings, and what the walls hold.
#include <cstdlib>

#include "verification/walls/flow.hpp"

namespace anvil {
namespace {

constexpr double density = 1000.0, speed = 8.7, width = 0.04, gate = -0.062, end = 53.64e-3;

void expect_filling(double spacing) {
  const auto mould = simulation_of("mould_filling", {"discretisation.spacing=" + std::to_string(spacing)});
  run_to(*mould, end);
  EXPECT_EQ(audited(*mould, "penetrations"), 0.0);
  const Frame frame = mould->frame();
  const auto body = array_of(frame, "body");
  double brought = 0.0;
  for (std::size_t i = 0; i < body.size(); ++i)
    if (body[i] == 0.0 && frame.positions[3 * i + 1] > gate) brought += density * spacing * spacing;
  const double waited = -gate * width * density, row = width * spacing * density;
  EXPECT_NEAR(brought - waited, density * speed * width * end, row);
}

// Of the forms for plain gradients the only one that is adjoint to the rate of density, as a spray needs it
// (docs/walls.md; the property itself: MomentumIn.SumFormStoresInDropsWhatItTakesFromTheirMotion).
TEST(Mould, TakesThePairForceThatStoresWhatItTakes) {
  const Scene scene = read_scene(std::string(ANVIL_SOURCE_DIR) + "/data/scenes/mould_filling.toml", {});
  EXPECT_EQ(scene.discretisation.momentum_form, "sum");
}

TEST(Mould, IsFilledWithoutLeaks) { expect_filling(5e-3); }

TEST(Mould, IsFilledWithoutLeaksAtOneMillimetre) {
  if (std::getenv("ANVIL_LONG_TESTS") == nullptr)
    GTEST_SKIP() << "takes a quarter of an hour of CPU time: set ANVIL_LONG_TESTS=1";
  expect_filling(1e-3);
}

}  // namespace
}  // namespace anvil
