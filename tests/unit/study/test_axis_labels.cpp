// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/study/axis_labels.hpp"

#include <gtest/gtest.h>

#include <string>

#include "anvil/study/measures.hpp"

namespace anvil {
namespace {

TEST(AxisLabels, SayEveryMeasureInWords) {
  for (const auto name : study_measure_names()) {
    const std::string label = measure_label(std::string(name));
    EXPECT_EQ(label.find('_'), std::string::npos) << label;
    EXPECT_TRUE(std::isupper(static_cast<unsigned char>(label.front()))) << label;
    const auto unit = find_study_measure(name)->unit;
    EXPECT_EQ(label.find('[') != std::string::npos, !unit.empty()) << label;
  }
  EXPECT_EQ(measure_label("poiseuille_error"), "Largest error of velocity / greatest velocity");
  EXPECT_EQ(measure_label("peak_stress"), "Peak stress [Pa]");
  EXPECT_EQ(measure_label("step_cost"), "Step cost [µs]");
  EXPECT_EQ(measure_label("deviation.foot_half_width_side"), "Relative deviation of foot half width side");
}

TEST(AxisLabels, SayKeysWithTheirUnits) {
  EXPECT_EQ(key_label("discretisation.spacing"), "Spacing [m]");
  EXPECT_EQ(key_label("discretisation.smoothing_ratio"), "Smoothing ratio");
  EXPECT_EQ(key_label("body.rod.velocity"), "Velocity");
}

}  // namespace
}  // namespace anvil
