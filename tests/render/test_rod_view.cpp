// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "anvil/core/error.hpp"
#include "anvil/measures/frame_parts.hpp"
#include "render/mushroom.hpp"
#include "vtk_io/body_surface.hpp"
#include "vtk_io/drawn_particles.hpp"
#include "vtk_io/image_comparison.hpp"
#include "vtk_io/render.hpp"

namespace anvil {
namespace {

namespace fs = std::filesystem;

const fs::path baselines = fs::path(ANVIL_SOURCE_DIR) / "tests/render/baseline";
const fs::path baseline = baselines / "rod.png";

RenderOptions baseline_options() {
  RenderOptions options;
  options.size = {640, 480};
  options.range = FieldRange{0.0, 4.0};
  options.walls = {Plane{}};
  return options;
}

/// Draws into a folder of the test's own, where a picture that fails can be looked at: tests run side by side.
fs::path draw(const std::string& name, const Frame& frame, const RenderOptions& options) {
  const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
  const fs::path png = fs::path("pictures") / test->test_suite_name() / test->name() / (name + ".png");
  fs::create_directories(png.parent_path());
  render_frame(frame, options, png);
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

TEST(RodView, DiffersFromTheBaselineWithAnotherColorMap) {
  RenderOptions options = baseline_options();
  options.color_map = "earth";
  EXPECT_FALSE(same(compare_images(draw("colors", test::make_mushroom(8), options), baseline)));
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

/// A cube of 8 mm: `across` particles along an edge, on its faces or half a spacing inside.
Frame make_cube(int across, bool on_faces) {
  Frame frame;
  frame.scene = "cube";
  const double spacing = 8e-3 / (on_faces ? across - 1 : across);
  const double first = on_faces ? 0.0 : 0.5 * spacing;
  for (int k = 0; k < across; ++k)
    for (int j = 0; j < across; ++j)
      for (int i = 0; i < across; ++i)
        frame.positions.insert(frame.positions.end(), {first + i * spacing, first + j * spacing, first + k * spacing});
  frame.arrays = {{"initial_position", "m", 3, false, frame.positions},
                  {"plastic_strain", "", 1, false, std::vector<double>(frame.particle_count(), 1.0)}};
  return frame;
}

TEST(BodySurface, LiesOnTheFacesOfBothLattices) {
  for (const bool on_faces : {false, true}) {
    SCOPED_TRACE(on_faces);
    Frame cube = make_cube(9, on_faces);
    if (on_faces) add_masses_of_face_lattice(cube);
    const auto particles = make_drawn_particles(cube, cube.find("plastic_strain")->values, on_faces);
    ASSERT_EQ(particles.undeformed.size(), 1U);
    double outline[6];
    particles.undeformed.front().GetBounds(outline);
    double surface[6];
    make_body_surface(make_filling(particles), std::nullopt)->GetBounds(surface);
    for (int i = 0; i < 6; ++i) {
      EXPECT_NEAR(outline[i], i % 2 == 0 ? 0.0 : 8.0, 1e-9);
      EXPECT_NEAR(surface[i], outline[i], 0.1 * particles.spacing);  // the edges are rounded
    }
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
  EXPECT_THROW(render_frame(frame, options, "never.png"), InputError);
  options = {};
  options.range = FieldRange{2.0, 2.0};
  EXPECT_THROW(render_frame(frame, options, "never.png"), InputError);
  options = {};
  options.view_direction = {0.0, 0.0, 1.0};
  EXPECT_THROW(render_frame(frame, options, "never.png"), InputError);
  options = {};
  options.size = {100000, 10};
  EXPECT_THROW(render_frame(frame, options, "never.png"), InputError);
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
  EXPECT_THROW(render_frame(test::make_mushroom(2), baseline_options(), "no/such/folder/rod.png"),
               MissingResourceError);
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

TEST(ParticlesView, DrawsTwoDimensions) {
  RenderOptions options;
  options.size = {640, 480};
  const auto content = measure_content(draw("disc", make_disc(), options));
  // 317 discs that touch: pi/4 of a disc whose diameter is about 0.8 of the height, so 0.3 of the picture; then scales
  // and colour bar. Half as many particles, or discs of half the radius, are outside.
  EXPECT_GT(content.share, 0.25);
  EXPECT_LT(content.share, 0.4);
}

/// `name`.png is what the picture must look like, and not with other colours, another title or a tenth less of the
/// field.
void compare_with_baseline(const std::string& name, Frame frame, const RenderOptions& options) {
  const fs::path right = baselines / (name + ".png");
  EXPECT_TRUE(same(compare_images(draw(name, frame, options), right)));
  RenderOptions other = options;
  other.color_map = "viridis";
  EXPECT_FALSE(same(compare_images(draw(name + "_colors", frame, other), right)));
  other = options;
  other.title = "Another title";
  EXPECT_FALSE(same(compare_images(draw(name + "_label", frame, other), right)));
  for (FrameArray& array : frame.arrays)
    if (array.name == options.field)
      for (double& value : array.values) value *= 0.9;
  EXPECT_FALSE(same(compare_images(draw(name + "_field", frame, options), right)));
}

TEST(ParticlesView, LooksLikeTheBaseline) {
  RenderOptions options = baseline_options();
  options.view = View::particles;
  options.field = "pressure";
  options.range = FieldRange{-10e6, 10e6};
  options.walls = {Plane{{0.0, -10.5e-3, 0.0}, {0.0, 1.0, 0.0}}};
  options.title = "Disc";
  compare_with_baseline("particles_flat", make_disc(), options);
}

TEST(ParticlesView, ColorsByBodyWithTheirNames) {
  Frame frame = make_disc();
  FrameArray body{"body", "", 1, true, {}};
  for (std::size_t i = 0; i < frame.particle_count(); ++i) body.values.push_back(frame.positions[3 * i] > 0.0 ? 1 : 0);
  frame.arrays.push_back(body);
  RenderOptions options;
  options.size = {640, 480};
  const auto by_pressure = draw("by_pressure", frame, options);
  options.field = "body";
  const auto by_number = draw("by_number", frame, options);
  options.body_names = {"flyer", "target"};
  const auto by_name = draw("by_name", frame, options);
  EXPECT_FALSE(compare_images(by_pressure, by_number).same());
  EXPECT_FALSE(compare_images(by_number, by_name).same());
}

TEST(ParticlesView, DrawsWallsGreyWhateverTheirField) {
  Frame frame = make_disc();
  frame.arrays.push_back({"body", "", 1, true, std::vector<double>(frame.particle_count(), 0.0)});
  const Frame alone = frame;
  for (int i = -12; i <= 12; ++i) {
    frame.positions.insert(frame.positions.end(), {1e-3 * i, -11e-3, 0.0});
    frame.arrays[0].values.push_back(5e9);  // would set the range of colours
    frame.arrays[1].values.push_back(1.0);
  }
  RenderOptions options;
  options.size = {640, 480};
  options.first_wall = 1;
  const auto grey = draw("grey", frame, options);
  for (double& pressure : frame.arrays[0].values) pressure = std::min(pressure, 10e6);
  EXPECT_EQ(compare_images(grey, draw("other_field", frame, options)).mean_difference, 0.0);
  EXPECT_GT(measure_content(grey).share, 0.2);
  options.first_wall.reset();
  EXPECT_FALSE(compare_images(grey, draw("coloured", frame, options)).same());
  options.first_wall = 1;
  EXPECT_FALSE(compare_images(grey, draw("alone", alone, options)).same());

  SeriesExtent extent;
  frame.arrays[0].values.back() = 5e9;
  include_frame(extent, frame, options);
  EXPECT_DOUBLE_EQ(extent.values->high, 10e6);
  EXPECT_DOUBLE_EQ((*extent.bounds)[1], 12e-3);
}

TEST(ParticlesView, DrawsLargerParticlesLarger) {
  RenderOptions options;
  options.size = {640, 480};
  options.glyph_radius = 0.2;
  const double small = measure_content(draw("small", make_disc(), options)).share;
  options.glyph_radius = 0.5;
  EXPECT_GT(measure_content(draw("large", make_disc(), options)).share, 2.0 * small);
  options.glyph_radius = -1.0;
  EXPECT_THROW(draw("never", make_disc(), options), InputError);
}

TEST(ParticlesView, DrawsSpheresInThreeDimensions) {
  RenderOptions options = baseline_options();
  options.view = View::particles;
  const auto content = measure_content(draw("particles", test::make_mushroom(8), options));
  EXPECT_GT(content.share, 0.08);
  EXPECT_LT(content.share, 0.45);
}

TEST(SectionView, ShowsTheInsideWhereverThePlaneIs) {
  RenderOptions options = baseline_options();
  options.view = View::section;
  const auto middle = draw("section", test::make_mushroom(8), options);
  const auto content = measure_content(middle);
  // The undeformed outline, 32 mm, sets the scale: 12 pixels a millimetre. At that scale the 1024 mm3 of the rod, 21 mm
  // high and on average 7 mm across, cover 0.07 of the picture; outlines, scales, wall and colour bar the rest.
  EXPECT_GT(content.share, 0.09);
  EXPECT_LT(content.share, 0.2);
  options.section = Plane{{0.0, 0.0, 4e-3}, {0.0, 0.0, 1.0}};
  EXPECT_FALSE(compare_images(middle, draw("section_z", test::make_mushroom(8), options)).same());
  options.section = Plane{{0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}};
  EXPECT_THROW(draw("never", test::make_mushroom(8), options), InputError);
}

TEST(SectionView, LooksLikeTheBaseline) {
  RenderOptions options = baseline_options();
  options.view = View::section;
  options.field = "plastic_strain";
  compare_with_baseline("section", test::make_mushroom(8), options);
}

TEST(SectionView, ShowsTheWholeOfAFlatScene) {
  RenderOptions options;
  options.size = {640, 480};
  options.view = View::section;
  const auto content = measure_content(draw("flat_section", make_disc(), options));
  EXPECT_GT(content.share, 0.3);
  EXPECT_LT(content.share, 0.6);
}

SeriesExtent extent_of(const std::vector<Frame>& frames, const RenderOptions& options) {
  SeriesExtent extent;
  for (const Frame& frame : frames) include_frame(extent, frame, options);
  return extent;
}

TEST(RenderFrame, FindsTheExtentOfASeries) {
  RenderOptions options;
  const Frame half = test::make_mushroom(6, 0.5, 0);
  const Frame last = test::make_mushroom(6, 1.0, 1);
  const SeriesExtent extent = extent_of({half, last}, options);
  ASSERT_TRUE(extent.values && extent.bounds);
  const auto extreme = [](const Frame& frame, auto pick) {
    const auto& strains = frame.find("plastic_strain")->values;
    return *pick(strains.begin(), strains.end());
  };
  const auto greatest = [](auto begin, auto end) { return std::max_element(begin, end); };
  const auto least = [](auto begin, auto end) { return std::min_element(begin, end); };
  EXPECT_DOUBLE_EQ(extent.values->high, extreme(last, greatest));
  EXPECT_DOUBLE_EQ(extent.values->low, extreme(half, least));
  // From frame to frame it grows shorter and its foot wider.
  EXPECT_DOUBLE_EQ((*extent.bounds)[5], half.positions.back());
  double widest = 0.0;
  for (std::size_t i = 0; i < last.positions.size(); i += 3) widest = std::min(widest, last.positions[i]);
  EXPECT_DOUBLE_EQ((*extent.bounds)[0], widest);
}

TEST(RenderFrame, KeepsColorsAndCameraOverASeries) {
  RenderOptions options = baseline_options();
  options.range.reset();
  const Frame first = test::make_mushroom(6, 0.1, 0);
  const Frame last = test::make_mushroom(6, 1.0, 1);
  const SeriesExtent extent = extent_of({first, last}, options);
  const auto alone = draw("first_alone", first, options);
  // Another range of colours, and a camera that has room for the foot to come: each makes another picture.
  options.series = SeriesExtent{extent.values, std::nullopt};
  EXPECT_FALSE(compare_images(alone, draw("first_colors", first, options)).same());
  options.series = SeriesExtent{std::nullopt, extent.bounds};
  EXPECT_FALSE(compare_images(alone, draw("first_camera", first, options)).same());
  // What the last frame shows is the whole extent: it looks the same alone.
  options.series = extent;
  const auto last_in_series = draw("last_series", last, options);
  options.series.reset();
  EXPECT_TRUE(same(compare_images(last_in_series, draw("last_alone", last, options))));
}

TEST(RenderFrame, DrawsOnlyWhatSuitsTheFrame) {
  RenderOptions options;
  options.view = View::rod;
  EXPECT_THROW(draw("never", make_disc(), options), InputError);
  options.view = View::particles;
  options.color_map = "rainbow";
  EXPECT_THROW(draw("never", make_disc(), options), InputError);
}

}  // namespace
}  // namespace anvil
