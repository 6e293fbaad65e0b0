// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/figures/description.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

std::string error_of(const std::string& text) {
  try {
    read_figure_description_text(text, "figure.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

testing::AssertionResult says(const std::string& message, const std::vector<std::string>& parts) {
  for (const auto& part : parts)
    if (message.find(part) == std::string::npos)
      return testing::AssertionFailure() << "'" << part << "' is not in: " << message;
  return testing::AssertionSuccess();
}

TEST(FigureDescription, IsReadWithAllItsKeys) {
  const auto figure = read_figure_description_text(R"(
title = "A title"
columns = 2
width = 800
[[panel]]
title = "left"
x = { quantity = "position.x", unit = "mm", label = "Place", range = [0, 80] }
y = { unit = "GPa", logarithmic = true }
[[panel.curve]]
field = "-stress.xx"
times = [4e-6, 8e-6]
exact = true
style = "points"
[[panel.curve]]
file = "measured.csv"
x_column = "x"
y_column = "y"
label = "measured"
[[panel]]
map = { field = "pressure", unit = "MPa", range = [0, 5] }
)",
                                                   "figure.toml");
  EXPECT_EQ(figure.title, "A title");
  EXPECT_EQ(figure.columns, 2);
  EXPECT_EQ(figure.width, 800);
  EXPECT_EQ(figure.height, 0);
  ASSERT_EQ(figure.panels.size(), 2U);
  const auto& left = figure.panels[0];
  EXPECT_EQ(left.x.quantity, "position.x");
  EXPECT_EQ(left.x.range, (std::vector<double>{0.0, 80.0}));
  EXPECT_TRUE(left.y.logarithmic);
  ASSERT_EQ(left.curves.size(), 2U);
  EXPECT_EQ(left.curves[0].times, (std::vector<double>{4e-6, 8e-6}));
  EXPECT_TRUE(left.curves[0].exact);
  EXPECT_EQ(left.curves[0].style, "points");
  EXPECT_EQ(left.curves[1].file, "measured.csv");
  EXPECT_FALSE(left.map.has_value());
  ASSERT_TRUE(figure.panels[1].map.has_value());
  EXPECT_EQ(figure.panels[1].map->unit, "MPa");
}

TEST(FigureDescription, NamesLineAndKeyOfEveryMistakeAtOnce) {
  const std::string message = error_of(
      "titel = 'x'\n"
      "[[panel]]\n"
      "y = { unit = 3 }\n"
      "[[panel.curve]]\n"
      "field = 'pressure'\n"
      "times = [-1e-6]\n"
      "style = 'dotted'\n");
  EXPECT_TRUE(says(message, {"figure.toml:1:1: key 'titel' is unknown; did you mean 'title'?",
                             "figure.toml:3:", "key 'panel.1.y.unit' must be a text, found 3",
                             "figure.toml:6:", "panel.1.curve.1.times", "figure.toml:7:", "line, points, reference"}));
}

TEST(FigureDescription, RefusesWhatCannotBeDrawn) {
  EXPECT_TRUE(says(error_of("title = 'x'\n"), {"no [[panel]]"}));
  EXPECT_TRUE(says(error_of("[[panel]]\n"), {"figure.toml:1:", "shows nothing"}));
  EXPECT_TRUE(says(error_of("[[panel]]\n[[panel.curve]]\nfield = 'a'\nhistory = 'b'\n"),
                   {"figure.toml:2:", "exactly one of the keys field, history and file"}));
  EXPECT_TRUE(says(error_of("[[panel]]\n[[panel.curve]]\nhistory = 'b'\nexact = true\n"), {"has no field"}));
  EXPECT_TRUE(says(error_of("[[panel]]\n[[panel.curve]]\nfile = 'b.csv'\n"), {"x_column"}));
  EXPECT_TRUE(says(error_of("[[panel]]\nx = { range = [2, 1] }\n[[panel.curve]]\nfield = 'a'\n"),
                   {"figure.toml:2:", "'panel.1.x.range' must be two ascending numbers"}));
  EXPECT_TRUE(says(error_of("[[panel]]\nmap = { unit = 'Pa' }\n"), {"lacks the key 'field'"}));
  EXPECT_TRUE(says(error_of("panel = 3\n"), {"figure.toml:1:", "[[panel]]"}));
  EXPECT_TRUE(says(error_of("[[panel]\n"), {"figure.toml:1:", "not valid TOML"}));
}

TEST(FigureDescription, BundledOnesAreFine) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(ANVIL_SOURCE_DIR "/data/figures")) {
    EXPECT_NO_THROW(read_figure_description(entry.path())) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 5);
  EXPECT_THROW(locate_figure("plate_perfekt"), InputError);
}

}  // namespace
}  // namespace anvil
