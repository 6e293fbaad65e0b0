// SPDX-License-Identifier: BSD-3-Clause
#include "verification/simulate.hpp"

namespace anvil {
namespace {

/// One way to smooth, to choose h and to damp shocks per test.
const std::vector<std::vector<std::string>> variants = {
    {"stabiliser.smoothing_form=plain"},
    {"stabiliser.smoothing_form=pairwise", "discretisation.variable_smoothing_length=false"},
    {"stabiliser.smoothing_form=scaled", "shock.method=artificial_viscosity"},
    {"stabiliser.conservative_smoothing=0", "shock.method=artificial_viscosity",
     "discretisation.momentum_form=density_squared"},
    {"discretisation.method=kernel_gradient_correction", "discretisation.momentum_form=adjoint",
     "stabiliser.conservative_smoothing=0", "stabiliser.non_affine_damping=0.2"},
    {"stabiliser.smoothing_form=plain", "material.copper.strength.isotropic_fraction=0.5"},
};

class SameBits : public testing::TestWithParam<std::vector<std::string>> {};

TEST_P(SameBits, ForOneAndTwoThreads) {
  std::unique_ptr<Simulation> one, two;
  {
    const WithThreads threads(1);
    one = coarse_rod(GetParam());
    run_steps(*one, 300);
  }
  {
    const WithThreads threads(2);
    two = coarse_rod(GetParam());
    run_steps(*two, 300);
  }
  EXPECT_GT(audited(*one, "list_builds"), 3.0);
  expect_same_bits(*one, *two);
}

// Also between two neighbour searches, right before and right after one.
TEST_P(SameBits, AfterARestartAtAnyStep) {
  const int last = 120;
  std::vector<State> states;
  const auto whole = coarse_rod(GetParam());
  const double builds_before = audited(*whole, "list_builds");
  for (int step = 0; step < last; ++step) {
    if (step % 15 == 0 || (step > 60 && step < 75)) states.push_back(whole->state());
    whole->advance(1.0);
  }
  EXPECT_GT(audited(*whole, "list_builds"), builds_before + 2.0);
  for (const State& state : states) {
    const auto continued = coarse_rod(GetParam());
    run_steps(*continued, 20);  // into a simulation that has been elsewhere, too
    continued->restore(state);
    run_steps(*continued, last - static_cast<int>(continued->step()));
    expect_same_bits(*whole, *continued);
    if (HasFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Variant, SameBits, testing::ValuesIn(variants),
                         [](const auto& variant) { return std::to_string(variant.index); });

TEST(NumberOfThreads, MayGrowWhileASimulationLives) {
  const auto steady = coarse_rod(), growing = coarse_rod();
  {
    const WithThreads threads(1);
    run_steps(*steady, 40);
    run_steps(*growing, 20);
  }
  {
    const WithThreads threads(4);
    run_steps(*growing, 20);
  }
  expect_same_bits(*steady, *growing);
}

TEST(Restore, RefusesAStateOfAnotherScene) {
  const auto rod = coarse_rod();
  const auto before = rod->state();
  EXPECT_THROW(rod->restore(coarse_rod({"discretisation.variable_smoothing_length=false"})->state()), InputError);
  EXPECT_THROW(rod->restore(simulation_of("bar_elastic_1d")->state()), InputError);
  EXPECT_THROW(rod->restore({}), InputError);
  EXPECT_EQ(std::get<std::vector<double>>(before.at("field/position").values),
            std::get<std::vector<double>>(rod->state().at("field/position").values));
}

}  // namespace
}  // namespace anvil
