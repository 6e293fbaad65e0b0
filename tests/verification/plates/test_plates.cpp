// SPDX-License-Identifier: BSD-3-Clause
// The plates of Wang 2002 against their exact solutions in finite strain, at initial positions, with 800 particles.
#include <gtest/gtest.h>

#include "verification/plates/plate.hpp"
#include "verification/simulate.hpp"

namespace anvil {
namespace {

const std::vector<std::string> paper_coefficients = {"shock.diffusion=0.125", "shock.antidiffusion=0.125"};

Scene plate_scene(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return read_scene(std::string(ANVIL_SOURCE_DIR) + "/data/scenes/" + name + ".toml", overrides);
}

/// The comparisons at the given times (s).
std::vector<PlateComparison> run_plate(const Scene& scene, const std::vector<double>& times) {
  const auto exact = exact_profiles(scene, times, scene.name == "plate_two_layer");
  const auto simulation = make_simulation(scene);
  std::vector<PlateComparison> comparisons;
  for (std::size_t k = 0; k < times.size(); ++k) {
    run_to(*simulation, times[k]);
    comparisons.push_back(compare_plate(simulation->frame(), exact[k]));
  }
  return comparisons;
}

struct Expected {
  std::string scene, method;
  std::vector<std::string> overrides;
  std::vector<double> times;  // s
  std::vector<double> l1;     // largest mean error over the peak
};

/// L1 at three times. The limits are the measured errors and a tenth: instruction sets round differently, and a limiter
/// turns round-off into another choice here and there.
class PlateErrors : public testing::TestWithParam<Expected> {};

TEST_P(PlateErrors, StayWithinTheMeasuredOnes) {
  std::vector<std::string> overrides = GetParam().overrides;
  overrides.push_back("shock.method=" + GetParam().method);
  const auto comparisons = run_plate(plate_scene(GetParam().scene, overrides), GetParam().times);
  for (std::size_t k = 0; k < comparisons.size(); ++k)
    EXPECT_LT(comparisons[k].l1, 1.1 * GetParam().l1[k]) << "at " << GetParam().times[k] << " s";
}

const std::vector<double> layer_times = {6e-6, 12e-6, 16e-6}, plastic_times = {4e-6, 8e-6, 14e-6};
INSTANTIATE_TEST_SUITE_P(
    Plates, PlateErrors,
    testing::Values(Expected{"plate_two_layer", "fct", {}, layer_times, {0.0036, 0.0049, 0.0066}},
                    Expected{"plate_two_layer", "fct", paper_coefficients, layer_times, {0.0047, 0.0068, 0.0099}},
                    Expected{"plate_two_layer", "artificial_viscosity", {}, layer_times, {0.0157, 0.0285, 0.0362}},
                    Expected{"plate_two_layer", "none", {}, layer_times, {0.0276, 0.0425, 0.0507}},
                    Expected{"plate_perfect", "fct", {}, plastic_times, {0.0018, 0.0038, 0.0044}},
                    Expected{"plate_perfect", "fct", paper_coefficients, plastic_times, {0.0027, 0.0064, 0.0075}},
                    Expected{"plate_perfect", "artificial_viscosity", {}, plastic_times, {0.0092, 0.0184, 0.0239}},
                    Expected{"plate_hardening", "fct", {}, plastic_times, {0.0019, 0.0022, 0.0043}},
                    Expected{"plate_hardening", "artificial_viscosity", {}, plastic_times, {0.0087, 0.0119, 0.0150}}),
    [](const auto& named) {
      return named.param.scene + "_" + named.param.method + (named.param.overrides.empty() ? "" : "_of_the_paper");
    });

/// Flux-corrected transport must not swallow the elastic precursor, nor shift the plateau of the load.
TEST(PlatePerfect, KeepsPrecursorAndPlateau) {
  for (const auto& overrides : {std::vector<std::string>{}, paper_coefficients}) {
    const auto comparison = run_plate(plate_scene("plate_perfect", overrides), {8e-6})[0];
    // Zones well inside the plateaus, some 20 particles off their fronts at 19.7, 42.7 and 52.5 mm.
    const double precursor = comparison.mean_stress(45e-3, 50.5e-3), plateau = comparison.mean_stress(22e-3, 40e-3);
    EXPECT_NEAR(precursor, -1.9709e9, 0.015 * 1.9709e9);  // within 1.5 %; finite strain takes 0.2 % of it
    EXPECT_NEAR(plateau, -5e9, 0.001 * 5e9);
  }
}

/// The mean error falls with the spacing: first order at best, since shocks stay some particles wide.
TEST(PlateTwoLayer, ConvergesWithFirstOrder) {
  const std::vector<std::pair<std::string, double>> least_order = {
      // Viscosity spreads a shock over a width that grows with its path: order one half at long times.
      {"fct", 0.7},
      {"artificial_viscosity", 0.45}};
  for (const auto& [method, order] : least_order) {
    std::vector<double> errors;
    for (const double spacing : {0.4e-3, 0.2e-3, 0.1e-3})
      errors.push_back(run_plate(plate_scene("plate_two_layer", {"shock.method=" + method,
                                                                 "discretisation.spacing=" + std::to_string(spacing)}),
                                 {6e-6})[0]
                           .l1);
    EXPECT_GT(std::log2(errors[0] / errors[1]), order) << method;
    EXPECT_GT(std::log2(errors[1] / errors[2]), order) << method;
  }
}

/// Impulse and work of the load are the history's and what the plate then holds.
TEST(PlatePerfect, AccountsForTheLoad) {
  const auto simulation = simulation_of("plate_perfect", {"discretisation.spacing=0.4e-3"});
  run_to(*simulation, 8e-6);
  EXPECT_NEAR(audited(*simulation, "pressure_impulse_x"), 5e9 * 5e-6,
              1e-12 * 5e9 * 5e-6);  // a sum of some hundred parts
  // Stress differences conserve momentum on an even line only; the strain of 2 % makes it uneven at the fronts.
  EXPECT_LT(audited(*simulation, "momentum_error"), 1e-3 * audited(*simulation, "pressure_impulse_x"));
  EXPECT_LT(std::abs(audited(*simulation, "energy_error")), 5e-3 * audited(*simulation, "pressure_work"));
  EXPECT_GT(audited(*simulation, "pressure_work"), 0.0);
  EXPECT_EQ(audited(*simulation, "uncorrected_particles"), 0.0);
}

/// After several reflections, in compression and tension: no pair has come apart or together, and particles lie where
/// their densities put them.
TEST(Plates, StayStableForFortyMicroseconds) {
  for (const std::string scene : {"plate_two_layer", "plate_perfect", "plate_hardening"}) {
    for (const std::string method : {"fct", "artificial_viscosity"}) {
      const auto simulation =
          simulation_of(scene, {"time.end=40e-6", "discretisation.spacing=0.2e-3", "shock.method=" + method});
      run_to(*simulation, 40e-6);
      const Frame frame = simulation->frame();
      const auto stress = array_of(frame, "stress"), density = array_of(frame, "density");
      double peak = 0.0, drift = 0.0;
      for (std::size_t i = 0; i < density.size(); ++i) {
        peak = std::max(peak, std::abs(stress[6 * i]));
        if (i + 1 == density.size() || (scene == "plate_two_layer" && i == 249)) continue;
        const double initial = scene == "plate_two_layer" && i < 250 ? 2710.0 : 7800.0;
        const double stretch = 0.5 * (initial / density[i] + initial / density[i + 1]);
        drift = std::max(drift, std::abs((frame.positions[3 * i + 3] - frame.positions[3 * i]) / 0.2e-3 - stretch));
      }
      const double load = scene == "plate_two_layer" ? 0.7567e9 : 6e9;  // the largest exact stress
      EXPECT_LT(peak, 1.1 * load) << scene << " with " << method;
      EXPECT_GT(audited(*simulation, "minimum_pair_distance"), 0.97 * 0.2e-3) << scene << " with " << method;
      // CSPM does not see a zigzag of positions: fronts leave one of half a percent. A filter of densities let it grow
      // to a tenth of the spacing and more.
      EXPECT_LT(drift, 0.01) << scene << " with " << method;
    }
  }
}

TEST(PlateTwoLayer, HasTheSameBitsForAnyNumberOfThreadsAndAfterARestart) {
  const auto run = [](int threads) {
    const WithThreads with(threads);
    auto simulation = simulation_of("plate_two_layer", {"discretisation.spacing=0.01e-3"});
    run_steps(*simulation, 20);
    return simulation;
  };
  const auto one = run(1), three = run(3);
  expect_same_bits(*one, *three);
  const auto restarted = simulation_of("plate_two_layer", {"discretisation.spacing=0.01e-3"});
  restarted->restore(one->state());
  run_steps(*one, 10);
  run_steps(*restarted, 10);
  expect_same_bits(*one, *restarted);
}

/// The rod of Sun 2017 at 15 us: fronts and peak move at sqrt(E / rho).
TEST(ThinRod, CarriesItsPulseAtTheSpeedOfBars) {
  const auto simulation = simulation_of("thin_rod");
  run_to(*simulation, 15e-6);
  const Frame frame = simulation->frame();
  const auto stress = array_of(frame, "stress"), initial = array_of(frame, "initial_position");
  double peak = 0.0, moment = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < stress.size() / 6; ++i) {
    peak = std::min(peak, stress[6 * i]);
    moment += initial[3 * i] * stress[6 * i];
    sum += stress[6 * i];
    EXPECT_NEAR(stress[6 * i + 1], 0.0, 1.0);  // Pa, lateral
  }
  EXPECT_NEAR(peak, -800e6, 0.005 * 800e6);
  // 0.35 % strain at the peak moves a wave of finite strain ahead of the small-strain one by about as much.
  EXPECT_NEAR(moment / sum, 48.54e-3, 0.01 * 48.54e-3);
}

/// Symmetric impact: half the velocity everywhere behind the waves, and the contact is like any other place.
TEST(FlyerPlate, SharesItsVelocityWithTheTarget) {
  const Scene scene = plate_scene("flyer_plate");
  const auto comparison = run_plate(scene, {15e-6})[0];
  EXPECT_LT(comparison.l1, 1.1 * 0.0040);  // measured, and a tenth as above
  for (std::size_t k = 0; k < comparison.position.size() / 2; ++k)
    // Mirror images up to the order of sums.
    EXPECT_NEAR(comparison.stress[k], comparison.stress[comparison.position.size() - 1 - k], 1e-6 * 2.45e9);
}

}  // namespace
}  // namespace anvil
