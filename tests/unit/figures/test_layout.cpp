// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "anvil/core/error.hpp"
#include "anvil/figures/axis_scale.hpp"
#include "anvil/figures/color_scale.hpp"
#include "anvil/figures/drawing.hpp"
#include "anvil/figures/text_width.hpp"

namespace anvil {
namespace {

std::vector<std::string> labels_of(const AxisScale& scale) {
  std::vector<std::string> labels;
  for (const Tick& tick : scale.ticks())
    if (!tick.label.empty()) labels.push_back(tick.label);
  return labels;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto place = text.find(part); place != std::string::npos; place = text.find(part, place + 1)) ++found;
  return found;
}

PlottedCurve make_curve(const std::string& label, CurveStyle style) {
  PlottedCurve curve{label, style, curve_color(0), {}, {}};
  for (int i = 0; i <= 10; ++i) {
    curve.x.push_back(i);
    curve.y.push_back(i * i - 50.0);
  }
  return curve;
}

Figure make_figure() {
  Figure figure;
  figure.title = "Stress < strength & more";
  figure.panels.resize(2);
  figure.panels[0].x.label = "Place [mm]";
  figure.panels[0].y.label = "Stress [MPa]";
  figure.panels[0].curves = {make_curve("exact", CurveStyle::reference), make_curve("this run", CurveStyle::line),
                             make_curve("measured", CurveStyle::points)};
  figure.panels[1].map = PlottedMap{"Stress [MPa]", {0.0, 4.0}, {0.0, 2.0}, 4, 2, {-1, 0, 1, 2, 3, 2, 1, 0}, {-1, 3}};
  return figure;
}

TEST(AxisScale, RoundsOutwardToTicks) {
  const AxisScale scale({.label = "y"}, {-4.7, 0.3}, false, 6);
  EXPECT_EQ(labels_of(scale), (std::vector<std::string>{"−5", "−4", "−3", "−2", "−1", "0", "1"}));
  EXPECT_DOUBLE_EQ(scale.share_of(-5.0), 0.0);
  EXPECT_DOUBLE_EQ(scale.share_of(1.0), 1.0);
}

TEST(AxisScale, SpendsNoStepOnATrifle) {
  const AxisScale scale({.label = "y"}, {-0.01, 3.0}, false, 6);
  EXPECT_EQ(labels_of(scale).front(), "0");
  EXPECT_EQ(labels_of(scale).back(), "3");
  EXPECT_GT(scale.share_of(-0.01), 0.0);  // and nothing touches the frame
  EXPECT_LT(scale.share_of(3.0), 1.0);
}

TEST(AxisScale, EndsWhereTightValuesDo) {
  // Particles from half a spacing to 80 less half a spacing belong to a body from 0 to 80.
  EXPECT_DOUBLE_EQ(AxisScale({.label = "x"}, {0.05, 79.95}, true, 8).share_of(80.0), 1.0);
  EXPECT_DOUBLE_EQ(AxisScale({.label = "x"}, {0.0, 14.0}, true, 8).share_of(14.0), 1.0);
  EXPECT_DOUBLE_EQ(AxisScale({.label = "x"}, {0.0, 13.0}, true, 8).share_of(13.0), 1.0);
}

TEST(AxisScale, KnowsPowersOfTen) {
  const AxisScale scale({.label = "error", .logarithmic = true, .range = {{1e-4, 1.0}}}, {}, false, 6);
  EXPECT_EQ(labels_of(scale), (std::vector<std::string>{"10⁻⁴", "10⁻³", "10⁻²", "10⁻¹", "10⁰"}));
  EXPECT_DOUBLE_EQ(scale.share_of(1e-2), 0.5);
  EXPECT_TRUE(std::isnan(scale.share_of(0.0)));
  EXPECT_THROW(AxisScale({.label = "error", .logarithmic = true, .range = {{-1.0, 1.0}}}, {}, false, 6), InputError);
}

TEST(AxisScale, DrawsASingleValueAndNoneAtAll) {
  EXPECT_DOUBLE_EQ(AxisScale({.label = "y"}, {0.0, 0.0}, true, 6).share_of(0.0), 0.5);
  EXPECT_DOUBLE_EQ(AxisScale({.label = "y"}, {7.0}, true, 6).share_of(7.0), 0.5);
  EXPECT_FALSE(AxisScale({.label = "y"}, {}, false, 6).ticks().empty());
  EXPECT_FALSE(AxisScale({.label = "y"}, {std::nan("")}, false, 6).ticks().empty());
}

TEST(AxisScale, WritesLargeNumbersWithPowers) {
  EXPECT_EQ(tick_label(2.5e6, 5e5, 3e6), "2.5×10⁶");
  EXPECT_EQ(tick_label(-4e-6, 2e-6, 4e-6), "−4×10⁻⁶");
  EXPECT_EQ(tick_label(-1e-18, 0.1, 1.0), "0.0");
}

TEST(Layout, KeepsEveryTextOnThePage) {
  Figure figure = make_figure();
  for (const auto& size : {std::array{1600, 1800}, std::array{800, 900}, std::array{400, 500}}) {
    figure.size = size;
    for (const auto& shape : lay_out(figure).shapes) {
      const auto* text = std::get_if<DrawnText>(&shape);
      if (text == nullptr) continue;
      SCOPED_TRACE(text->text);
      const double along = text_width(text->text, text->size);
      const double before = text->anchor == Anchor::left ? 0.0 : text->anchor == Anchor::right ? along : 0.5 * along;
      const double start = (text->upright ? text->at.y : text->at.x) - before;
      const double across = text->upright ? text->at.x : text->at.y;
      EXPECT_GE(start, 0.0);
      EXPECT_LE(start + along, text->upright ? size[1] : size[0]);
      EXPECT_GE(across, 0.5 * text->size);
      EXPECT_LE(across + 0.5 * text->size, text->upright ? size[0] : size[1]);
    }
  }
}

TEST(Layout, PutsFramesOfAColumnInLine) {
  Figure figure = make_figure();
  figure.panels[1] = {};
  figure.panels[1].curves = {make_curve("longer numbers", CurveStyle::line)};
  for (double& y : figure.panels[1].curves[0].y) y *= 1000.0;
  std::vector<std::array<double, 2>> sides;
  for (const auto& shape : lay_out(figure).shapes) {
    const auto* line = std::get_if<DrawnLine>(&shape);
    if (line != nullptr && line->dots.size() == 5) sides.push_back({line->dots[0].x, line->dots[1].x});
  }
  ASSERT_EQ(sides.size(), 2U);
  EXPECT_EQ(sides[0], sides[1]);
}

TEST(Layout, PutsReferencesBelowAndInterruptsLines) {
  Figure figure = make_figure();
  figure.panels.resize(1);
  figure.panels[0].curves[1].y[5] = std::numeric_limits<double>::quiet_NaN();
  std::vector<const DrawnLine*> lines;
  const Drawing drawing = lay_out(figure);
  for (const auto& shape : drawing.shapes)
    if (const auto* line = std::get_if<DrawnLine>(&shape); line != nullptr && line->clip) lines.push_back(line);
  ASSERT_EQ(lines.size(), 3U);  // the reference, and the line in two parts
  EXPECT_GT(lines[0]->width, lines[1]->width);
  EXPECT_EQ(lines[1]->dots.size(), 5U);
  EXPECT_EQ(lines[2]->dots.size(), 5U);
}

TEST(Layout, RefusesWhatMakesNoFigure) {
  Figure figure;
  EXPECT_THROW(lay_out(figure), InputError);
  figure = make_figure();
  figure.size = {100000, 100};
  EXPECT_THROW(lay_out(figure), InputError);
}

TEST(Svg, HoldsEveryCurveTextAndPicture) {
  const std::string svg = write_svg(lay_out(make_figure()));
  EXPECT_EQ(count(svg, "<polyline clip-path="), 2U);
  EXPECT_EQ(count(svg, "<circle"), 12U);                  // eleven points and their sample in the legend
  EXPECT_EQ(count(svg, "<image"), 2U);                    // the map and its colours
  EXPECT_EQ(count(svg, "data:image/bmp;base64,Qk"), 2U);  // "BM" in base64
  EXPECT_EQ(count(svg, ">Stress &lt; strength &amp; more</text>"), 1U);
  EXPECT_EQ(count(svg, ">this run</text>"), 1U);
  EXPECT_EQ(count(svg, "nan"), 0U);
  EXPECT_EQ(count(svg, "<svg"), count(svg, "</svg>"));
}

TEST(ColorScale, IsWhiteAtZeroAndDarkestAtTheFurtherEnd) {
  const std::array<double, 2> range = {-5.0, 1.0};
  EXPECT_EQ(color_of(0.0, range), (Color{255, 255, 255}));
  EXPECT_EQ(color_of(std::nan(""), range), (Color{255, 255, 255}));
  EXPECT_EQ(color_of(-9.0, range), color_of(-5.0, range));
  EXPECT_GT(color_of(-5.0, range).blue, color_of(-5.0, range).red);
  EXPECT_GT(color_of(1.0, range).red, color_of(1.0, range).blue);
}

}  // namespace
}  // namespace anvil
