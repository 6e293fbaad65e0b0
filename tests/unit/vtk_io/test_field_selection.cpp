// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/field_selection.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "anvil/core/error.hpp"
#include "anvil/figures/ticks.hpp"

namespace anvil {
namespace {

FieldRange range_alone(const SelectedField& field) { return range_of(field, std::nullopt, extremes_of(field)); }

Frame make_two_particles() {
  Frame frame;
  frame.positions = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0};
  frame.arrays = {{"velocity", "m/s", 3, false, {3.0, 0.0, -4.0, 0.0, 1.0, 0.0}},
                  {"stress", "Pa", 6, false, {5e6, 0, 0, 0, 0, 0, 1e6, 1e6, 1e6, 0, 2e6, 0}},
                  {"plastic_strain", "", 1, false, {0.03, 1.13}}};
  return frame;
}

TEST(FieldSelection, TakesPlasticStrainWhenNothingIsAskedFor) {
  const auto field = select_field(make_two_particles(), "");
  EXPECT_EQ(field.label, "Plastic strain");
  EXPECT_EQ(field.values, (std::vector<double>{0.03, 1.13}));
}

TEST(FieldSelection, TakesTheLengthOfAVectorAndItsComponents) {
  EXPECT_EQ(select_field(make_two_particles(), "velocity").values, (std::vector<double>{5.0, 1.0}));
  EXPECT_EQ(select_field(make_two_particles(), "velocity.z").values, (std::vector<double>{-4.0, 0.0}));
  EXPECT_EQ(select_field(make_two_particles(), "velocity.z").label, "Velocity z\n[m/s]");
}

TEST(FieldSelection, TakesTheUnitOfTheRangeThatIsShown) {
  const auto field = select_field(make_two_particles(), "stress.xx");
  EXPECT_EQ(field.label, "Stress xx\n[MPa]");
  EXPECT_DOUBLE_EQ(field.values[0], 5.0);
  // A frame of a series with larger stresses.
  const auto of_series = select_field(make_two_particles(), "stress.xx", FieldRange{0.0, 2e9});
  EXPECT_EQ(of_series.label, "Stress xx\n[GPa]");
  EXPECT_DOUBLE_EQ(of_series.values[0], 0.005);
}

TEST(FieldSelection, DerivesVonMises) {
  // Uniaxial tension: the stress itself. Hydrostatic stress with shear tau: sqrt(3) tau. A few roundings of 1e-16.
  const auto field = select_field(make_two_particles(), "von_mises");
  EXPECT_NEAR(field.values[0], 5.0, 1e-14);
  EXPECT_NEAR(field.values[1], 2.0 * std::sqrt(3.0), 1e-14);
}

TEST(FieldSelection, NamesTheFieldsThereAre) {
  for (const std::string name : {"plastic_strian", "velocity.q", "stress", "temperature", "stress.xx + nothing"}) {
    try {
      select_field(make_two_particles(), name);
      ADD_FAILURE() << name << " was accepted";
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find(name.substr(name.rfind(' ') + 1)), std::string::npos) << message;
      EXPECT_NE(message.find("plastic_strain"), std::string::npos) << message;
    }
  }
}

TEST(FieldSelection, RoundsTheRangeOutward) {
  const auto range = range_alone(select_field(make_two_particles(), ""));
  EXPECT_EQ(range.low, 0.0);
  EXPECT_DOUBLE_EQ(range.high, 1.25);  // steps of 0.25 up to 1.13
  const auto both_signs = range_alone(select_field(make_two_particles(), "velocity.z"));
  EXPECT_EQ(both_signs.low, -4.0);
  EXPECT_EQ(both_signs.high, 0.0);
}

TEST(FieldSelection, LeavesWhatIsNoNumberOutOfTheRange) {
  SelectedField field = select_field(make_two_particles(), "");
  field.values = {std::nan(""), 2.0, HUGE_VAL};
  EXPECT_EQ(range_alone(field).high, 2.0);
  field.values = {std::nan("")};
  EXPECT_LT(range_alone(field).low, range_alone(field).high);
}

TEST(FieldSelection, TakesTheRangeOfASeries) {
  const auto field = select_field(make_two_particles(), "stress.xx");
  const auto range = range_of(field, std::nullopt, FieldRange{-1e6, 9e6});
  EXPECT_DOUBLE_EQ(range.low, -2.0);
  EXPECT_DOUBLE_EQ(range.high, 10.0);
}

TEST(FieldSelection, DoesNotStartAtZeroFarFromIt) {
  SelectedField field = select_field(make_two_particles(), "");
  field.values = {8900.0, 8960.0};
  EXPECT_DOUBLE_EQ(range_alone(field).low, 8900.0);
  field.values = {8930.0, 8930.0};
  EXPECT_LT(range_alone(field).low, range_alone(field).high);
}

TEST(FieldSelection, TakesAFixedRangeInSiUnits) {
  const auto range = range_of(select_field(make_two_particles(), "stress.xx"), FieldRange{0.0, 4e8}, std::nullopt);
  EXPECT_DOUBLE_EQ(range.high, 400.0);
  EXPECT_THROW(range_of(select_field(make_two_particles(), ""), FieldRange{1.0, 0.0}, std::nullopt), InputError);
}

TEST(Ticks, AreRoundNumbers) {
  EXPECT_DOUBLE_EQ(nice_step(4.0, 5), 1.0);
  EXPECT_DOUBLE_EQ(nice_step(1.13, 5), 0.25);
  EXPECT_DOUBLE_EQ(nice_step(32e-3, 7), 5e-3);
  EXPECT_EQ(multiples_between(-1.0, 1.0, 0.5), (std::vector<double>{-1.0, -0.5, 0.0, 0.5, 1.0}));
  EXPECT_EQ(multiples_between(0.1, 0.9, 0.25).size(), 3U);
  EXPECT_EQ(tick_format(0.25, 1.0), "%.2f");
  EXPECT_EQ(tick_format(25.0, 100.0), "%.0f");
  EXPECT_EQ(tick_format(1e6, 4e6), "%.2e");
}

}  // namespace
}  // namespace anvil
