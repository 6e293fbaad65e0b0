// SPDX-License-Identifier: BSD-3-Clause
// The impacts of the Riemann solver's paper in one dimension, 1000 particles, against their exact solutions.
#include <algorithm>
#include <cmath>

#include "anvil/exact/scene_reference.hpp"
#include "anvil/measures/wave_comparison.hpp"
#include "anvil/study/runner.hpp"
#include "verification/simulate.hpp"

namespace anvil {
namespace {

struct Impact {
  Scene scene;
  std::unique_ptr<Simulation> simulation;
  Frame frame;
  SceneReference exact;

  explicit Impact(const std::string& name, const std::vector<std::string>& overrides = {})
      : scene(read_scene(std::string(ANVIL_SOURCE_DIR) + "/data/scenes/" + name + ".toml", overrides)),
        simulation(make_simulation(scene)),
        exact(scene, {scene.time.end}, StrainMeasure::finite) {
    run_to(*simulation, scene.time.end);
    frame = simulation->frame();
  }

  [[nodiscard]] double compared(const std::string& name) const {
    for (const auto& quantity : compare_waves(frame, exact, 0, scene.discretisation.spacing))
      if (quantity.name == name) return quantity.value;
    ADD_FAILURE() << "nothing compares " << name;
    return 0.0;
  }

  /// Mean of a value over the particles that started between two places (m).
  template <class Value>
  [[nodiscard]] double mean(double from, double to, const Value& value) const {
    const auto initial = array_of(frame, "initial_position");
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < frame.particle_count(); ++i) {
      if (initial[3 * i] < from || initial[3 * i] > to) continue;
      sum += value(i);
      ++count;
    }
    return sum / count;
  }
};

struct Expected {
  std::string scene;
  double l1;  // largest mean error of the stress over the peak; a finite-volume code with 1000 cells has about as much
};

class EveryImpact : public testing::TestWithParam<Expected> {};

TEST_P(EveryImpact, HasItsPlateausAndConservesEnergy) {
  const Impact impact(GetParam().scene);
  EXPECT_LT(impact.compared("stress_l1"), 1.1 * GetParam().l1);  // the measured one and a tenth
  EXPECT_LT(impact.compared("plateau_error"), 0.002);            // measured: up to 0.0016; asked for: 0.005
  EXPECT_LT(impact.compared("stress_overshoot"), 0.003);
  const double total = audited(*impact.simulation, "total_energy");
  EXPECT_LT(std::abs(audited(*impact.simulation, "energy_error")), 1e-12 * total);  // round-off of some 1000 steps
}

/// Where the stress passes the middle of a front of the exact solution: within two particles of it.
TEST_P(EveryImpact, HasItsFrontsInPlace) {
  const Impact impact(GetParam().scene);
  const auto line = impact.exact.line(0);
  const auto stress = array_of(impact.frame, "stress"), initial = array_of(impact.frame, "initial_position");
  const double spacing = impact.scene.discretisation.spacing;
  double peak = 0.0;
  for (const auto& point : line) peak = std::max(peak, std::abs(point.stress));
  int fronts = 0;
  for (std::size_t k = 1; k < line.size(); ++k) {
    const double before = line[k - 1].stress, after = line[k].stress, place = line[k].initial_position;
    if (std::abs(after - before) < 0.05 * peak) continue;
    ++fronts;
    const double middle = 0.5 * (before + after);
    double nearest = 1.0;
    for (std::size_t i = 0; i + 1 < impact.frame.particle_count(); ++i) {
      const double a = stress[6 * i] - middle, b = stress[6 * i + 6] - middle;
      if (a * b > 0.0 || a == b) continue;
      const double crossing = initial[3 * i] + (initial[3 * i + 3] - initial[3 * i]) * a / (a - b);
      if (std::abs(crossing - place) < std::abs(nearest)) nearest = crossing - place;
    }
    // In al_impact_free a precursor of 200 MPa leaves the foot of a shock of 2.8 GPa, which reaches further ahead than
    // two spacings where it has half of that: docs/riemann.md.
    const bool from_foot = GetParam().scene == "al_impact_free" && std::abs(after - before) < 0.1 * peak;
    const double bound = from_foot ? 6.0 : 2.0;
    EXPECT_LT(std::abs(nearest), bound * spacing) << "front at " << place << " m";
  }
  EXPECT_GE(fronts, 2);
}

INSTANTIATE_TEST_SUITE_P(Riemann, EveryImpact,
                         testing::Values(Expected{"al_impact", 0.0047}, Expected{"al_impact_free", 0.0052},
                                         Expected{"wilkins", 0.0042}, Expected{"cu_al", 0.0049}),
                         [](const auto& named) { return named.param.scene; });

/// An under-damped shock swings past the yield surface and leaves the deviator near -0.166 GPa, the shelf of the
/// release near -5.22 GPa, at any resolution.
TEST(Wilkins, LeavesTheMaterialYieldingBehindTheShock) {
  const Impact impact("wilkins");
  const auto stress = array_of(impact.frame, "stress"), pressure = array_of(impact.frame, "pressure");
  const auto axial = [&](std::size_t i) { return stress[6 * i]; };
  // The shock has passed the material that started before 34.5 mm, the head of the release that before 31 mm.
  EXPECT_NEAR(impact.mean(32e-3, 34e-3, [&](std::size_t i) { return stress[6 * i] + pressure[i]; }), -0.2e9,
              0.01 * 0.2e9);
  EXPECT_NEAR(impact.mean(32e-3, 34e-3, [&](std::size_t i) { return pressure[i]; }), 6.435879e9, 0.005 * 6.435879e9);
  EXPECT_NEAR(impact.mean(27e-3, 29e-3, axial), -5.113585e9, 0.015 * 5.113585e9);
}

TEST(AlImpact, ConvergesWithFirstOrder) {
  std::vector<double> errors;
  for (const std::string spacing : {"8e-3", "4e-3", "2e-3"})
    errors.push_back(Impact("al_impact", {"discretisation.spacing=" + spacing}).compared("stress_l1"));
  // 0.75 and 0.76: the feet of precursors take longer to become as narrow, in time, as the first order would have them.
  EXPECT_GT(std::log2(errors[0] / errors[1]), 0.7);
  EXPECT_GT(std::log2(errors[1] / errors[2]), 0.7);
}

/// The states of the particles instead of those at the middle of a pair, as published: twice the error or more.
TEST(AlImpact, GainsByReconstruction) {
  EXPECT_LT(2.0 * Impact("al_impact").compared("stress_l1"),
            Impact("al_impact", {"shock.reconstruction=constant"}).compared("stress_l1"));
}

TEST(AlImpact, IsTheSameWithThePublishedGradients) {
  const Impact impact("al_impact", {"shock.pair_gradient=corrected"});
  EXPECT_LT(impact.compared("plateau_error"), 0.005);
  EXPECT_LT(std::abs(audited(*impact.simulation, "energy_error")), 1e-3 * audited(*impact.simulation, "total_energy"));
}

/// What is asked of the study contact_oscillation: a tenth of what artificial viscosity leaves.
TEST(CuAl, IsQuietAtTheContact) {
  StudyDescription study = read_study(locate_study("contact_oscillation"));
  std::vector<StudyRun> runs = prepare_study(study, {});
  run_study(study, runs, 2, [](const StudyPosition&) {});
  ASSERT_EQ(runs.size(), 5U);
  for (const std::size_t measure : {0U, 1U}) {
    const double hllc = runs[0].rows.back().values[measure], viscosity = runs[3].rows.back().values[measure];
    EXPECT_LT(hllc, 0.1 * viscosity) << study.grids[0].measures[measure];
  }
}

TEST(Impacts, HaveTheSameBitsAfterARestart) {
  for (const std::string gradient : {"plain", "corrected", "symmetrised"}) {
    const std::vector<std::string> overrides = {"discretisation.spacing=10e-3", "shock.pair_gradient=" + gradient};
    const auto whole = simulation_of("al_impact", overrides), part = simulation_of("al_impact", overrides);
    run_steps(*whole, 37);
    part->restore(whole->state());
    run_steps(*whole, 20);
    run_steps(*part, 20);
    expect_same_bits(*whole, *part);
  }
}

/// Without pairs that exchange energy, the work of the stress is that of corrected gradients, the forces are those of
/// plain ones: equal up to the error of the sums.
TEST(Wilkins, AccountsForItsEnergyWithViscosity) {
  const auto simulation = simulation_of("wilkins", {"shock.method=artificial_viscosity"});
  run_to(*simulation, 5e-6);
  EXPECT_LT(std::abs(audited(*simulation, "energy_error")), 0.001 * audited(*simulation, "total_energy"));
  EXPECT_GT(audited(*simulation, "internal_energy"), 0.5 * audited(*simulation, "total_energy"));
}

}  // namespace
}  // namespace anvil
