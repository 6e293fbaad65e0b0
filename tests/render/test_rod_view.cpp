// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "anvil/core/error.hpp"
#include "render/mushroom.hpp"
#include "vtk_io/image_comparison.hpp"
#include "vtk_io/particle_series.hpp"
#include "vtk_io/render.hpp"
#include "vtk_io/rod_view.hpp"

namespace anvil {
namespace {

namespace fs = std::filesystem;

const fs::path baseline = fs::path(ANVIL_SOURCE_DIR) / "tests/render/baseline/rod.png";

RenderOptions baseline_options() {
  RenderOptions options;
  options.size = {640, 480};
  options.range = FieldRange{0.0, 4.0};
  options.walls = {WallPlane{}};
  return options;
}

/// Draws into the folder of the test, where a picture that fails can be looked at.
fs::path draw(const std::string& name, const Frame& frame, const RenderOptions& options) {
  const fs::path png = fs::path("pictures") / (name + ".png");
  fs::create_directories(png.parent_path());
  render_rod(frame, options, png);
  return png;
}

testing::AssertionResult same(const ImageComparison& comparison) {
  return (comparison.same() ? testing::AssertionSuccess() : testing::AssertionFailure())
         << "similarity " << comparison.similarity << ", worst region " << comparison.worst_region
         << ", mean difference " << comparison.mean_difference << ", worst colour " << comparison.worst_color;
}

TEST(RodView, LooksLikeTheBaseline) {
  const auto png = draw("rod", test::make_mushroom(8), baseline_options());
  EXPECT_TRUE(same(compare_images(png, baseline)));
}

TEST(RodView, DiffersFromTheBaselineWithAnotherRangeOfColors) {
  RenderOptions options = baseline_options();
  options.range = FieldRange{0.0, 3.5};
  EXPECT_FALSE(same(compare_images(draw("range", test::make_mushroom(8), options), baseline)));
}

TEST(RodView, DiffersFromTheBaselineWithAnotherLabel) {
  RenderOptions options = baseline_options();
  options.title = "Square steel rod on a rigid wall, 227 m/s";
  EXPECT_FALSE(same(compare_images(draw("label", test::make_mushroom(8), options), baseline)));
}

TEST(RodView, DiffersFromTheBaselineWithAnotherField) {
  Frame frame = test::make_mushroom(8);
  for (FrameArray& array : frame.arrays)
    if (array.name == "plastic_strain")
      for (double& strain : array.values) strain *= 0.9;
  EXPECT_FALSE(same(compare_images(draw("field", frame, baseline_options()), baseline)));
}

TEST(RodView, DiffersFromTheBaselineWithAnotherShape) {
  Frame frame = test::make_mushroom(8, 0.98);
  frame.time = test::make_mushroom(8).time;
  EXPECT_FALSE(same(compare_images(draw("shape", frame, baseline_options()), baseline)));
}

TEST(RodView, FillsThePicture) {
  for (const bool surface : {false, true})
    for (const bool cut : {false, true}) {
      RenderOptions options = baseline_options();
      options.surface = surface;
      options.cut = cut;
      const std::string name = std::string(surface ? "surface" : "spheres") + (cut ? "_cut" : "_whole");
      SCOPED_TRACE(name);
      const auto content = measure_content(draw(name, test::make_mushroom(8), options));
      EXPECT_EQ(content.width, 640);
      EXPECT_EQ(content.height, 480);
      // Bodies, walls and colour bar cover a fifth to a third of the picture; an empty view or a black one does not.
      EXPECT_GT(content.share, 0.12);
      EXPECT_LT(content.share, 0.45);
      // Title and rulers on the left, time on the right, title at the top, wall at the bottom; nothing cut off.
      EXPECT_GT(content.box[0], 0);
      EXPECT_LT(content.box[0], 80);
      EXPECT_GT(content.box[1], 0);
      EXPECT_LT(content.box[1], 120);
      EXPECT_GT(content.box[2], 560);
      EXPECT_LT(content.box[2], 639);
      EXPECT_GT(content.box[3], 440);
      EXPECT_LT(content.box[3], 479);
    }
}

TEST(RodView, DrawsTheSamePictureTwice) {
  const auto first = draw("once", test::make_mushroom(4), baseline_options());
  const auto second = draw("twice", test::make_mushroom(4), baseline_options());
  EXPECT_EQ(compare_images(first, second).mean_difference, 0.0);
}

TEST(RodView, ColorsByEveryKindOfField) {
  const auto strain = draw("strain", test::make_mushroom(4), baseline_options());
  for (const std::string field : {"stress.zz", "von_mises", "initial_position", "initial_position.x", "pressure"}) {
    SCOPED_TRACE(field);
    RenderOptions options = baseline_options();
    options.field = field;
    options.range.reset();
    EXPECT_FALSE(compare_images(strain, draw("kind_of_field", test::make_mushroom(4), options)).same());
  }
}

TEST(RodView, RefusesOptionsThatMakeNoSense) {
  const Frame frame = test::make_mushroom(2);
  RenderOptions options;
  options.field = "plastic_strian";
  EXPECT_THROW(render_rod(frame, options, "never.png"), InputError);
  options = {};
  options.range = FieldRange{2.0, 2.0};
  EXPECT_THROW(render_rod(frame, options, "never.png"), InputError);
  options = {};
  options.view_direction = {0.0, 0.0, 1.0};
  EXPECT_THROW(render_rod(frame, options, "never.png"), InputError);
  options = {};
  options.size = {100000, 10};
  EXPECT_THROW(render_rod(frame, options, "never.png"), InputError);
  EXPECT_FALSE(fs::exists("never.png"));
}

TEST(RodView, SurvivesParticlesThatFlewOff) {
  Frame frame = test::make_mushroom(4);
  frame.positions[0] = frame.positions[1] = 10.0;  // m
  RenderOptions options = baseline_options();
  draw("flown_off", frame, options);
  options.surface = true;
  EXPECT_THROW(draw("flown_off", frame, options), InputError);
  frame.positions[0] = std::nan("");
  EXPECT_THROW(draw("flown_off", frame, options), InputError);
}

TEST(RodView, NamesThePictureThatCannotBeWritten) {
  EXPECT_THROW(render_rod(test::make_mushroom(2), baseline_options(), "no/such/folder/rod.png"), MissingResourceError);
}

Frame make_disc() {
  Frame frame;
  frame.scene = "disc";
  frame.dimension = 2;
  FrameArray pressure{"pressure", "Pa", 1, false, {}};
  for (int j = -10; j <= 10; ++j)
    for (int i = -10; i <= 10; ++i)
      if (i * i + j * j <= 100) {
        frame.positions.insert(frame.positions.end(), {1e-3 * i, 1e-3 * j, 0.0});
        pressure.values.push_back(1e6 * i);
      }
  frame.arrays = {pressure};
  return frame;
}

TEST(FlatView, DrawsTwoDimensions) {
  RenderOptions options;
  options.size = {640, 480};
  fs::create_directories("pictures");
  render_flat(make_disc(), options, "pictures/disc.png");
  const auto content = measure_content("pictures/disc.png");
  // A disc in the left five sixths of the picture: about pi/4 of the square of its height.
  EXPECT_GT(content.share, 0.3);
  EXPECT_LT(content.share, 0.6);
}

TEST(RenderResult, DrawsTheFrameAskedFor) {
  std::string pattern = (fs::temp_directory_path() / "anvil_render_XXXXXX").string();
  ASSERT_NE(mkdtemp(pattern.data()), nullptr);
  const fs::path folder = pattern;
  ParticleSeriesWriter writer(folder, "mushroom", {});
  for (int i = 0; i < 3; ++i) writer.write(test::make_mushroom(4, 0.5 * i, i));

  RenderOptions options = baseline_options();
  render_result(folder, options, folder / "last.png");
  options.frame = 2;
  render_result(folder, options, folder / "second.png");
  options.frame = 0;
  render_result(folder / "mushroom.pvd", options, folder / "first.png");
  EXPECT_EQ(compare_images(folder / "last.png", folder / "second.png").mean_difference, 0.0);
  EXPECT_FALSE(compare_images(folder / "last.png", folder / "first.png").same());
  options.frame = 3;
  EXPECT_THROW(render_result(folder, options, folder / "never.png"), InputError);
  EXPECT_THROW(render_result(folder / "nowhere", options, folder / "never.png"), InputError);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace anvil
