// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/reader.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "anvil/core/data_path.hpp"
#include "unit/scene/scene_texts.hpp"

namespace anvil {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(Reader, FillsEveryDefault) {
  const Scene scene = read_scene_text(small_scene, "small");
  EXPECT_EQ(scene.name, "small");
  EXPECT_EQ(scene.title, "");
  EXPECT_EQ(scene.domain.strain_state, "full");
  EXPECT_EQ(scene.discretisation.method, "sph");
  EXPECT_EQ(scene.discretisation.kernel, "cubic_spline");
  EXPECT_EQ(scene.discretisation.spacing, 1e-3);
  EXPECT_EQ(scene.discretisation.smoothing_ratio, 1.0);
  EXPECT_EQ(scene.discretisation.momentum_form, "sum");
  EXPECT_TRUE(scene.discretisation.variable_smoothing_length);
  EXPECT_EQ(scene.shock.method, "none");
  EXPECT_EQ(scene.stabiliser.conservative_smoothing, 0.0);
  EXPECT_EQ(scene.stabiliser.smoothing_form, "plain");
  EXPECT_EQ(scene.time.cfl, 0.3);
  EXPECT_EQ(scene.time.minimum_step_fraction, 1e-4);
  ASSERT_EQ(scene.bodies.size(), 1u);
  EXPECT_EQ(scene.bodies[0].velocity, (std::vector<double>{0.0, 0.0, 0.0}));
  ASSERT_EQ(scene.materials.size(), 1u);
  EXPECT_EQ(scene.materials[0].strength.type, "none");
  EXPECT_TRUE(scene.boundaries.empty());
  EXPECT_EQ(scene.output.interval, scene.time.end / 20.0);
  EXPECT_EQ(scene.output.format, "vtp");
  EXPECT_EQ(scene.output.precision, "float32");
  EXPECT_EQ(scene.compare.reference, "");
}

TEST(Reader, TakesIntegersForNumbers) {
  const Scene scene = read_scene_text(small_scene, "small");
  EXPECT_EQ(scene.materials[0].density, 1000.0);
  EXPECT_EQ(scene.bodies[0].shape.parameters.numbers("min"), (std::vector<double>{0.0, 0.0, 0.0}));
}

TEST(Reader, ChoosesTheStrainStateByDimension) {
  const std::string line = R"(
[discretisation]
spacing = 1e-3
[time]
end = 0
[[body]]
name = "bar"
shape = { type = "interval", min = 0, max = 4e-3 }
material = "steel"
[domain]
dimension = 1
)";
  EXPECT_EQ(read_scene_text(line, "line").domain.strain_state, "uniaxial_strain");
  EXPECT_EQ(read_scene_text(line + "strain_state = 'uniaxial_stress'", "line").domain.strain_state, "uniaxial_stress");
  EXPECT_TRUE(contains(message_of(line + "strain_state = 'full'"), "scene:12:16: key 'domain.strain_state': full"));
}

TEST(Reader, ReportsAllProblemsInTheOrderOfTheirLines) {
  std::string text = small_scene;
  text.replace(text.find("spacing = 1e-3"), 14, "spcing = 1e-3");
  text.replace(text.find("end = 1e-6"), 10, "end = -1");
  text += "[output]\nformat = 'vtx'\n";
  const auto lines = lines_of(message_of(text));
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_TRUE(contains(lines[0], "scene:4:1: 'discretisation' lacks the key 'spacing'"));
  EXPECT_TRUE(contains(lines[1], "scene:5:1: key 'discretisation.spcing' is unknown; did you mean 'spacing'?"));
  EXPECT_TRUE(contains(lines[2], "scene:7:7: key 'time.end' must be a number in s, zero or more, found -1"));
  EXPECT_TRUE(contains(lines[3], "scene:16:10: key 'output.format' must be one of vtp, vtu, hdf5"));
}

TEST(Reader, TakesMaterialsFromTheBundle) {
  std::string text = small_scene.substr(0, small_scene.find("[material"));
  text.replace(text.find("\"soft\""), 6, "\"copper\"");
  const Scene scene = read_scene_text(text, "bundled");
  ASSERT_EQ(scene.materials.size(), 1u);
  EXPECT_EQ(scene.materials[0].name, "copper");
  EXPECT_EQ(scene.materials[0].density, 8930.0);
  EXPECT_EQ(scene.materials[0].strength.type, "j2");
}

TEST(Reader, PrefersTheMaterialOfTheScene) {
  std::string text = small_scene;
  for (auto found = text.find("soft"); found != std::string::npos; found = text.find("soft"))
    text.replace(found, 4, "copper");
  EXPECT_EQ(read_scene_text(text, "own").materials.at(0).density, 1000.0);
}

TEST(Reader, DropsMaterialsThatNoBodyUses) {
  const std::string unused = "[material.unused]\ndensity = 1\neos = { type = 'linear', bulk_modulus = 1 }\n";
  const Scene scene = read_scene_text(small_scene + unused, "small");
  ASSERT_EQ(scene.materials.size(), 1u);
  EXPECT_EQ(scene.materials[0].name, "soft");
}

TEST(Reader, ReadsEveryBundledScene) {
  const auto files = list_bundled("scenes", ".toml");
  ASSERT_FALSE(files.empty());
  for (const auto& file : files) {
    const Scene scene = read_scene(find_bundled("scenes", file));
    EXPECT_FALSE(scene.title.empty()) << file;
    EXPECT_EQ(scene.name + ".toml", file);
  }
}

TEST(Reader, ReadsEveryBundledMaterial) {
  const auto files = list_bundled("materials", ".toml");
  ASSERT_FALSE(files.empty());
  for (const auto& file : files) {
    const std::string name = std::filesystem::path(file).stem().string();
    std::string text = small_scene.substr(0, small_scene.find("[material"));
    text.replace(text.find("soft"), 4, name);
    EXPECT_EQ(read_scene_text(text, "scene").materials.at(0).name, name);
  }
}

TEST(Reader, BundledCopperIsThatOfTheRod) {
  const Scene own = read_scene(locate_scene("rod_square"));
  std::string text = small_scene.substr(0, small_scene.find("[material"));
  text.replace(text.find("soft"), 4, "copper");
  EXPECT_EQ(read_scene_text(text, "scene").materials.at(0), own.materials.at(0));
}

TEST(LocateScene, FindsPathsAndBundledNames) {
  EXPECT_EQ(locate_scene("rod_square").filename(), "rod_square.toml");
  const auto file = find_bundled("scenes", "rod_square.toml");
  EXPECT_EQ(locate_scene(file.string()), file);
}

TEST(LocateScene, NamesTheNearestScene) {
  try {
    locate_scene("rod_sqare");
    FAIL() << "no error was thrown";
  } catch (const InputError& error) {
    EXPECT_TRUE(contains(error.what(), "did you mean 'rod_square'?")) << error.what();
  }
}

}  // namespace
}  // namespace anvil
