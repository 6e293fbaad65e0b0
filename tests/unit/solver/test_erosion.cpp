// SPDX-License-Identifier: BSD-3-Clause
// Erosion of total Lagrangian bodies: far too early here, so that a few particles show what it does.
#include <gtest/gtest.h>

#include <cmath>

#include "verification/simulate.hpp"

namespace anvil {
namespace {

constexpr double start_energy = 301.57 / 4.0;     // J
constexpr double start_momentum = 2.65703 / 4.0;  // N s

std::unique_ptr<Simulation> eroding_rod(std::vector<std::string> overrides = {}) {
  overrides.insert(overrides.begin(), {"discretisation.spacing=1.6e-3", "stabiliser.erosion_stretch=0.9"});
  return simulation_of("rod_square_quarter", overrides);
}

TEST(Erosion, TakesStressAwayAndCountsWhatItHeld) {
  for (const std::string stabiliser : {"edge_stress_points", "none"}) {
    const auto rod = eroding_rod({"stabiliser.method=" + stabiliser, "time.local_steps=false"});
    run_to(*rod, 20e-6);
    const Frame frame = rod->frame();
    const auto eroded = array_of(frame, "eroded"), pressure = array_of(frame, "pressure"),
               stress = array_of(frame, "stress");
    int gone = 0;
    for (std::size_t i = 0; i < eroded.size(); ++i) {
      if (eroded[i] < 1.0) continue;
      ++gone;
      if (stabiliser == "none") {
        EXPECT_EQ(pressure[i], 0.0);
      }
      for (int c = 0; c < 6; ++c) EXPECT_EQ(stress[6 * i + static_cast<std::size_t>(c)], c < 3 ? -pressure[i] : 0.0);
    }
    EXPECT_GT(gone, 0) << stabiliser;
    EXPECT_GT(audited(*rod, "eroded_mass"), 0.0);
    // Compressed by a strong shock, the points held a good part of the energy when they went.
    EXPECT_GT(audited(*rod, "erosion_loss"), 1e-3 * start_energy) << stabiliser;
    EXPECT_LT(std::abs(audited(*rod, "energy_error")), 0.003 * start_energy) << stabiliser;
    EXPECT_LT(audited(*rod, "momentum_error"), 1e-10 * start_momentum) << stabiliser;
  }
}

TEST(Erosion, LeavesARodAloneThatIsNotSqueezedAsFar) {
  const auto with = simulation_of("rod_square_quarter", {"discretisation.spacing=1.6e-3"});
  const auto without =
      simulation_of("rod_square_quarter", {"discretisation.spacing=1.6e-3", "stabiliser.erosion_stretch=0"});
  for (const auto& rod : {with.get(), without.get()}) run_to(*rod, 10e-6);
  EXPECT_EQ(audited(*with, "eroded_mass"), 0.0);
  EXPECT_EQ(audited(*with, "eroded_edge_mass"), 0.0);
  EXPECT_EQ(with->frame().positions, without->frame().positions);
}

TEST(Erosion, SameBitsForAnyNumberOfThreadsAndAfterARestart) {
  for (const std::string local : {"true", "false"}) {
    const std::vector<std::string> steps = {"time.local_steps=" + local};
    const auto reference = eroding_rod(steps), other = eroding_rod(steps), restarted = eroding_rod(steps);
    {
      const WithThreads one(1);
      run_steps(*reference, 60);
    }
    const WithThreads two(2);
    run_steps(*other, 40);
    restarted->restore(other->state());
    for (const auto& rod : {other.get(), restarted.get()}) {
      run_steps(*rod, 20);
      expect_same_bits(*reference, *rod);
    }
    EXPECT_GT(audited(*reference, "eroded_mass"), 0.0);
  }
}

}  // namespace
}  // namespace anvil
