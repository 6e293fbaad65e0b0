// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "anvil/core/error.hpp"
#include "anvil/core/summed_unit.hpp"
#include "anvil/measures/balance.hpp"
#include "anvil/measures/measures.hpp"
#include "unit/output/temporary_folder.hpp"

namespace anvil {
namespace {

/// Three rows of a run that loses a tenth of its energy and half a newton second of momentum nobody explains.
History make_history() {
  return History({{"time", "s", {0.0, 40e-6, 80e-6}},
                  {"mass", "kg", {2.0, 2.0, 2.0}},
                  {"momentum_x", "N s", {0.0, 0.0, 0.0}},
                  {"momentum_z", "N s", {-4.0, -1.0, 3.0}},
                  {"kinetic_energy", "J", {100.0, 50.0, 20.0}},
                  {"plastic_work", "J", {0.0, 40.0, 60.0}},
                  {"smoothing_loss", "J", {0.0, 5.0, 10.0}},
                  {"total_energy", "J", {100.0, 95.0, 90.0}},
                  {"wall_impulse_x", "N s", {0.0, 0.0, 0.0}},
                  {"wall_impulse_z", "N s", {0.0, 3.0, 6.5}},
                  {"momentum_error", "N s", {0.0, 0.0, 0.2}},
                  {"minimum_pair_distance", "m", {1e-3, 0.25e-3, 0.5e-3}}});
}

Result make_result() {
  Result result{Scene{}, Frame{}, make_history()};
  result.scene.discretisation.spacing = 1e-3;
  result.frame.time = 80e-6;
  return result;
}

double measured(const std::string& name) { return find_measure(name)->of(make_result()); }

TEST(Measures, ReadTheHistory) {
  EXPECT_DOUBLE_EQ(measured("plastic_work"), 60.0);
  EXPECT_DOUBLE_EQ(measured("start_energy"), 100.0);
  EXPECT_DOUBLE_EQ(measured("centre_of_mass_velocity"), 1.5);
  // Zero a quarter of the way from -1 to 3.
  EXPECT_DOUBLE_EQ(measured("centre_of_mass_stop_time"), 50e-6);
  // From 30 us, at 2.25 N s, to 50 us, at 3.875 N s.
  EXPECT_NEAR(measured("contact_force_plateau"), 1.625 / 20e-6, 1e-6);
}

TEST(Measures, BalanceMomentumAndEnergy) {
  EXPECT_DOUBLE_EQ(measured("momentum_balance"), 0.5 / 20.0);  // of 2 kg with 100 J
  EXPECT_DOUBLE_EQ(measured("unexplained_momentum"), 0.2 / 20.0);
  EXPECT_DOUBLE_EQ(measured("energy_balance"), -0.1);
  EXPECT_DOUBLE_EQ(measured("smoothing_share"), 0.1);
  EXPECT_DOUBLE_EQ(measured("minimum_pair_distance"), 0.25);
  const auto parts = energy_parts(make_history());
  ASSERT_EQ(parts.size(), 4U);
  EXPECT_EQ(parts[1].name, "plastic_work");
  EXPECT_EQ(parts[1].end, 60.0);
}

/// Two bodies of 1 kg that meet at 3 m/s each: the error is not that of a sum that is next to nothing.
TEST(Measures, RelateTheMomentumOfBodiesThatMeetHeadOnToWhatTheyCarry) {
  Result result = make_result();
  result.history = History({{"mass", "kg", {2.0, 2.0}},
                            {"momentum_z", "N s", {0.0, 1e-9}},
                            {"wall_impulse_z", "N s", {0.0, 0.0}},
                            {"kinetic_energy", "J", {9.0, 1.0}},
                            {"momentum_error", "N s", {0.0, 1e-9}}});
  EXPECT_DOUBLE_EQ(find_measure("momentum_balance")->of(result), 1e-9 / 6.0);
  EXPECT_DOUBLE_EQ(find_measure("unexplained_momentum")->of(result), 1e-9 / 6.0);
}

/// A body of 2 kg that falls 5 m in a second and is caught by a wall, which also lifts it: nothing is unaccounted for.
TEST(Measures, CountGravityAndTheWorkOfWalls) {
  Result result = make_result();
  result.history = History({{"momentum_x", "N s/m", {0.0, 1.0, 0.0}},
                            {"momentum_y", "N s/m", {0.0, -20.0, 0.0}},
                            {"wall_impulse_x", "N s/m", {0.0, 0.0, 0.0}},
                            {"wall_impulse_y", "N s/m", {0.0, 0.0, 22.0}},
                            {"gravity_impulse_x", "N s/m", {0.0, 0.0, 0.0}},
                            {"gravity_impulse_y", "N s/m", {0.0, -20.0, -22.0}},
                            {"potential_energy", "J/m", {0.0, -100.0, -90.0}},
                            {"total_energy", "J/m", {0.0, 0.0, 10.0}},
                            {"wall_work", "J/m", {0.0, 0.0, 10.0}}});
  EXPECT_DOUBLE_EQ(find_measure("momentum_balance")->of(result), 0.0);
  EXPECT_DOUBLE_EQ(find_measure("energy_balance")->of(result), 0.0);
  EXPECT_EQ(energy_parts(result.history).size(), 3U);
}

TEST(Measures, SayWhatTheHistoryLacks) {
  Result result = make_result();
  result.history = History({{"time", "s", {0.0}}});
  EXPECT_THROW(find_measure("plastic_work")->of(result), InputError);
  EXPECT_THROW(find_measure("momentum_balance")->of(result), InputError);
  result.history = History({{"time", "s", {0.0, 1.0}}, {"momentum_z", "N s", {-2.0, -1.0}}});
  // What has not happened by the end is no error: it is not there to be judged, and no tolerance allows it.
  EXPECT_TRUE(std::isnan(find_measure("centre_of_mass_stop_time")->of(result)));
  EXPECT_FALSE((ComparedQuantity{"stop", "s", NAN, 1.0, 0.0, NAN, 0.1}.within()));
}

TEST(Comparison, JudgesWhatHasATolerance) {
  const Reference reference{"R", 80e-6, {{"plastic_work", "J", 50.0, 1.0}, {"start_energy", "J", 100.0, 1.0}}, {}};
  const auto quantities = compare(make_result(), reference, {{"plastic_work", 0.1}, {"energy_balance", 0.2}});
  EXPECT_EQ(quantities[0].name, "plastic_work");
  EXPECT_DOUBLE_EQ(quantities[0].deviation, 0.2);
  EXPECT_FALSE(quantities[0].within());
  EXPECT_TRUE(quantities[1].within());  // exact, and not judged
  for (const auto& quantity : quantities)
    if (quantity.name == "energy_balance") {
      EXPECT_DOUBLE_EQ(quantity.deviation, -0.1);
      EXPECT_TRUE(quantity.allowed.has_value());
      EXPECT_TRUE(quantity.within());
    }
}

TEST(Comparison, ANumberThatIsNoneIsOutside) {
  ComparedQuantity quantity{"x", "", NAN, 1.0, 0.0, NAN, 0.1};
  EXPECT_FALSE(quantity.within());
}

TEST(Comparison, RefusesAnotherTimeAndUnknownNames) {
  const Reference later{"R", 90e-6, {}, {}};
  EXPECT_THROW(compare(make_result(), later, {}), InputError);
  const Reference unknown{"R", std::nullopt, {{"plastic_wrok", "J", 1.0, 0.0}}, {}};
  try {
    compare(make_result(), unknown, {});
    FAIL() << "measured something nobody knows";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'plastic_work'"), std::string::npos) << error.what();
  }
  EXPECT_THROW(compare(make_result(), {}, {{"plastic_work", 0.1}}), InputError) << "tolerance without a reference";
}

TEST(Reference, EveryBundledOneNamesWhatIsMeasuredInTheSameUnit) {
  int files = 0;
  for (const auto& item : std::filesystem::directory_iterator(ANVIL_SOURCE_DIR "/data/reference")) {
    if (item.path().extension() != ".toml") continue;
    ++files;
    const Reference reference = read_reference(item.path());
    for (const auto& quantity : reference.quantities) {
      ASSERT_NE(find_measure(quantity.name), nullptr) << item.path() << ": " << quantity.name;
      // Only the shell is a scene in two dimensions.
      const int dimension = item.path().stem().string().starts_with("be_shell") ? 2 : 3;
      EXPECT_EQ(summed_unit(find_measure(quantity.name)->unit, dimension), quantity.unit) << quantity.name;
      EXPECT_GT(quantity.uncertainty, 0.0) << quantity.name;
    }
    for (const auto& profile : reference.profiles) {
      ASSERT_NE(find_profile_measure(profile.name), nullptr) << item.path() << ": " << profile.name;
      EXPECT_GT(profile.curve.x.size(), 10U);
    }
  }
  EXPECT_GE(files, 1);
}

TEST(Reference, ReadsProfilesInSi) {
  const TemporaryFolder folder;
  write_file(folder / "p.csv", "# source\nz_mm,err,side_ref_mm,diag_ref_mm\n0.5,9,8.25,7\n1,9,4.5,6\n");
  const Curve curve = read_profile(folder / "p.csv");
  ASSERT_EQ(curve.x.size(), 2U);
  EXPECT_DOUBLE_EQ(curve.x[0], 0.5e-3);
  EXPECT_DOUBLE_EQ(curve.y[0], 8.25e-3);
  EXPECT_DOUBLE_EQ(curve.y[1], 4.5e-3);
}

TEST(Reference, NamesFileAndLineOfAFault) {
  const TemporaryFolder folder;
  write_file(folder / "p.csv", "z_mm,side_ref_mm\n0.5,x\n");
  write_file(folder / "r.toml", "title = \"R\"\n[[quantity]]\nname = \"length\"\n");
  write_file(folder / "s.toml", "title = \"R\n");
  for (const auto& [name, where] : {std::pair{"p.csv", "p.csv:2"}, {"r.toml", "r.toml:2"}, {"s.toml", "s.toml:1"}}) {
    try {
      if (folder.path() / name == folder / "p.csv") {
        read_profile(folder / name);
      } else {
        read_reference(folder / name);
      }
      FAIL() << "read " << name;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(where), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace anvil
