// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "anvil/core/error.hpp"
#include "anvil/figures/color_scale.hpp"
#include "vtk_io/figure_painter.hpp"
#include "vtk_io/image_comparison.hpp"

namespace anvil {
namespace {

namespace fs = std::filesystem;

const fs::path baseline = fs::path(ANVIL_SOURCE_DIR) / "tests/render/baseline/figure.png";

/// Lines, points, a reference and a map, Greek and raised letters, a logarithmic axis.
Figure make_figure() {
  Figure figure;
  figure.title = "Waves: Δσ, 10⁻³";
  figure.size = {640, 480};
  figure.columns = 2;
  figure.panels.resize(2);
  Panel& lines = figure.panels[0];
  lines.x.label = "Time [µs]";
  lines.y.label = "Error";
  lines.y.logarithmic = true;
  for (const CurveStyle style : {CurveStyle::reference, CurveStyle::line, CurveStyle::points}) {
    PlottedCurve curve{style == CurveStyle::line ? "run" : "exact", style, curve_color(0), {}, {}};
    for (int i = 0; i <= 20; ++i) {
      curve.x.push_back(i);
      curve.y.push_back(std::pow(10.0, -0.1 * i) * (style == CurveStyle::points ? 0.5 : 1.0));
    }
    lines.curves.push_back(curve);
  }
  PlottedMap map{"Stress [GPa]", {0.0, 8.0}, {0.0, 4.0}, 8, 4, {}, {-3.0, 2.0}};
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 8; ++column) map.values.push_back(column - row - 3.0);
  figure.panels[1].x.label = "Place [mm]";
  figure.panels[1].map = map;
  return figure;
}

fs::path paint(const Figure& figure, const char* name) {
  const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
  const fs::path png = fs::path("pictures") / test->test_suite_name() / test->name() / name;
  fs::create_directories(png.parent_path());
  paint_png(lay_out(figure), png);
  return png;
}

TEST(FigurePainter, LooksLikeTheBaseline) {
  const auto comparison = compare_images(paint(make_figure(), "figure.png"), baseline);
  EXPECT_TRUE(comparison.same()) << "similarity " << comparison.similarity << ", worst region "
                                 << comparison.worst_region << ", mean difference " << comparison.mean_difference;
}

TEST(FigurePainter, DiffersFromTheBaselineWithAnotherLabel) {
  Figure figure = make_figure();
  figure.panels[0].x.label = "Time [ms]";
  EXPECT_FALSE(compare_images(paint(figure, "label.png"), baseline).same());
}

TEST(FigurePainter, DiffersFromTheBaselineWithOtherColors) {
  Figure figure = make_figure();
  for (PlottedCurve& curve : figure.panels[0].curves) curve.color = curve_color(3);
  EXPECT_FALSE(compare_images(paint(figure, "colors.png"), baseline).same());
}

TEST(FigurePainter, DiffersFromTheBaselineWithoutACurveOrWithAnotherMap) {
  Figure figure = make_figure();
  figure.panels[0].curves.pop_back();
  EXPECT_FALSE(compare_images(paint(figure, "fewer.png"), baseline).same());
  figure = make_figure();
  for (double& value : figure.panels[1].map->values) value = -value;
  EXPECT_FALSE(compare_images(paint(figure, "map.png"), baseline).same());
}

TEST(FigurePainter, LeavesAMarginOnAllSides) {
  const auto content = measure_content(paint(make_figure(), "margins.png"));
  EXPECT_EQ(content.width, 640);
  EXPECT_EQ(content.height, 480);
  EXPECT_GT(content.box[0], 1);
  EXPECT_GT(content.box[1], 1);
  EXPECT_LT(content.box[2], 638);
  EXPECT_LT(content.box[3], 478);
  EXPECT_GT(content.share, 0.1);
  EXPECT_LT(content.share, 0.6);
}

TEST(FigurePainter, NamesThePictureThatCannotBeWritten) {
  EXPECT_THROW(paint_png(lay_out(make_figure()), "no/such/folder/figure.png"), MissingResourceError);
}

}  // namespace
}  // namespace anvil
