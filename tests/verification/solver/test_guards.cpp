// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "verification/simulate.hpp"

namespace anvil {
namespace {

/// What the guard says that stops the run; fails when none does.
std::string guard_message(Simulation& simulation, int steps) {
  try {
    run_steps(simulation, steps);
  } catch (const NumericalError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no guard stopped the run";
  return {};
}

void expect_in(const std::string& message, const std::vector<std::string>& parts) {
  for (const auto& part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << part << " is missing in: " << message;
}

const std::vector<std::string> place_and_values = {"step ",    " s: particle ", "position [",       "velocity [",
                                                   "density ", "pressure ",     "smoothing length "};

/// A state of the coarse rod in which one number of one particle is another.
State with_number(State state, const std::string& field, std::size_t index, double number) {
  std::get<std::vector<double>>(state.at("field/" + field).values)[index] = number;
  return state;
}

TEST(Guards, NameAParticleWhoseDensityIsNotPositive) {
  // A time step so long that the rod strains by more than its whole volume within it.
  const auto rod = coarse_rod({"time.cfl=30", "body.rod.velocity=[0, 0, -50000]"});
  const std::string message = guard_message(*rod, 100);
  expect_in(message, place_and_values);
  expect_in(message, {"not positive"});
}

TEST(Guards, NameAParticleWhoseVelocityIsNotANumber) {
  const auto rod = coarse_rod();
  const State good = rod->state();
  rod->restore(with_number(good, "velocity", 3 * 17 + 1, std::numeric_limits<double>::quiet_NaN()));
  const std::string message = guard_message(*rod, 1);
  expect_in(message, place_and_values);
  expect_in(message, {"not a number", "nan"});
}

TEST(Guards, NameTheParticleThatIsBeyondTheWall) {
  const auto rod = coarse_rod();
  rod->restore(with_number(rod->state(), "position", 2, -1e-6));
  const std::string message = guard_message(*rod, 1);
  expect_in(message, place_and_values);
  expect_in(message, {"step 0 at", "particle 0: it is beyond the boundary 'anvil'"});
}

TEST(Guards, StopAtATimeStepThatCollapses) {
  // A tenth off one smoothing length is a tenth off the step, at once below 95 % of the first one.
  const auto rod = coarse_rod({"time.minimum_step_fraction=0.95"});
  rod->restore(with_number(rod->state(), "smoothing_length", 200, 0.9 * 1.6e-3));
  const std::string message = guard_message(*rod, 1);
  expect_in(message, place_and_values);
  expect_in(message, {"particle 200", "time step of", "time.minimum_step_fraction"});
  const auto tolerant = coarse_rod({"time.minimum_step_fraction=0.85"});
  tolerant->restore(with_number(tolerant->state(), "smoothing_length", 200, 0.9 * 1.6e-3));
  EXPECT_NO_THROW(run_steps(*tolerant, 20));
}

TEST(Guards, LetGoOnceAGoodStateIsRestored) {
  const auto rod = coarse_rod(), untouched = coarse_rod();
  const State good = rod->state();
  rod->restore(with_number(good, "velocity", 0, std::numeric_limits<double>::infinity()));
  (void)guard_message(*rod, 1);
  rod->restore(good);
  ASSERT_NO_THROW(run_steps(*rod, 20));
  run_steps(*untouched, 20);
  expect_same_bits(*rod, *untouched);
}

TEST(Guards, StayQuietOnAHealthyRun) {
  const auto rod = coarse_rod();
  EXPECT_NO_THROW(run_to(*rod, 80e-6));
}

}  // namespace
}  // namespace anvil
