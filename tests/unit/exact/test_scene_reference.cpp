// SPDX-License-Identifier: BSD-3-Clause
// Scenes of made-up layers, materials and loads against the solutions they stand for.
#include "anvil/exact/scene_reference.hpp"

#include <gtest/gtest.h>

#include <string>

#include "anvil/core/error.hpp"
#include "anvil/scene/reader.hpp"

namespace anvil {
namespace {

/// A soft layer on a hard one, 3 and 2 mm; `load` is the boundary, `strength` what both have besides the elastic shear.
std::string two_layers(const std::string& load, const std::string& type = "elastic", const std::string& yield = "",
                       const std::string& strain_state = "uniaxial_strain") {
  return "domain = { dimension = 1, strain_state = '" + strain_state +
         "' }\n"
         "discretisation = { spacing = 0.1e-3 }\n"
         "time = { end = 2e-6 }\n"
         "[[body]]\nname = 'hard'\nshape = { type = 'interval', min = 1e-3, max = 3e-3 }\nmaterial = 'hard'\n"
         "[[body]]\nname = 'soft'\nshape = { type = 'interval', min = -2e-3, max = 1e-3 }\nmaterial = 'soft'\n"
         "[material.soft]\ndensity = 1500\neos = { type = 'linear', bulk_modulus = 20e9 }\n"
         "strength = { type = '" +
         type + "', shear_modulus = 9e9" + yield +
         " }\n"
         "[material.hard]\ndensity = 9000\neos = { type = 'linear', bulk_modulus = 150e9 }\n"
         "strength = { type = '" +
         type + "', shear_modulus = 60e9" + yield + " }\n" + load;
}

const std::string pulse =
    "[[boundary]]\nname = 'load'\ntype = 'pressure'\nbody = 'soft'\nface = 'left'\nhistory = 'half_sine'\n"
    "value = 40e6\nduration = 0.7e-6\n";

Scene scene_of(const std::string& text) { return read_scene_text(text, "made_up"); }

PlateProblem expected_problem() {
  PlateProblem problem;
  problem.left_position = -2e-3;
  problem.layers = {{3e-3, WaveMaterial::small_strain(1500, 20e9, {.shear_modulus = 9e9})},
                    {2e-3, WaveMaterial::small_strain(9000, 150e9, {.shear_modulus = 60e9})}};
  problem.left_face.pressure = PressureHistory::half_sine(40e6, 0.7e-6);
  return problem;
}

TEST(SceneReference, IsDAlembertsSolutionOfElasticLayers) {
  const SceneReference reference(scene_of(two_layers(pulse)), {0.3e-6, 1.4e-6}, StrainMeasure::small);
  EXPECT_NE(reference.description().find("small strain"), std::string::npos);
  EXPECT_DOUBLE_EQ(reference.begin(), -2e-3);
  EXPECT_DOUBLE_EQ(reference.end(), 3e-3);
  const LayeredPlate plate(expected_problem(), 2e-6);
  double largest = 0.0;
  for (std::size_t t = 0; t < 2; ++t)
    for (double x = -1.97e-3; x < 3e-3; x += 0.11e-3) {
      const auto point = plate.at(x, reference.times()[t]);
      const ExactPoint found = reference.at(t, x);
      EXPECT_DOUBLE_EQ(found.stress, point.stress);
      EXPECT_DOUBLE_EQ(found.velocity, point.velocity);
      EXPECT_NEAR(found.deviator - found.pressure, found.stress, 1e-6);
      largest = std::max(largest, std::abs(found.stress));
    }
  EXPECT_GT(largest, 30e6);  // otherwise nothing was compared
}

TEST(SceneReference, TendsToSmallStrainUnderSmallLoads) {
  const Scene scene = scene_of(two_layers(pulse));
  const SceneReference small(scene, {1.4e-6}, StrainMeasure::small);
  const SceneReference finite(scene, {1.4e-6}, StrainMeasure::finite);
  EXPECT_NE(finite.description().find("finite strain"), std::string::npos);
  // Strains of 1e-3 and steps of the load of a hundredth of its peak.
  for (double x = -1.95e-3; x < 3e-3; x += 0.1e-3) EXPECT_NEAR(small.at(0, x).stress, finite.at(0, x).stress, 1e6);
}

TEST(SceneReference, SolvesARodByYoungsModulus) {
  const SceneReference rod(scene_of(two_layers(pulse, "elastic", "", "uniaxial_stress")), {0.5e-6},
                           StrainMeasure::finite);
  EXPECT_NE(rod.description().find("small strain"), std::string::npos);
  const double young = 9.0 * 20e9 * 9e9 / (3.0 * 20e9 + 9e9);
  const double speed = std::sqrt(young / 1500.0);
  // In the middle of the pulse that entered: half its duration behind the front.
  EXPECT_NEAR(rod.at(0, -2e-3 + speed * 0.15e-6).stress, -40e6, 1.0);
  EXPECT_NEAR(rod.at(0, -2e-3 + speed * 0.15e-6).pressure, 40e6 / 3.0, 1.0);
  EXPECT_EQ(rod.at(0, -2e-3 + speed * 0.51e-6).stress, 0.0);
}

TEST(SceneReference, YieldsWhereTheSceneDoes) {
  const Scene scene =
      scene_of(two_layers("[[boundary]]\nname = 'load'\ntype = 'pressure'\nbody = 'soft'\nhistory = "
                          "'rectangular'\nvalue = 500e6\nduration = 1e-6\n",
                          "j2", ", yield_stress = 100e6"));
  const SceneReference reference(scene, {0.4e-6}, StrainMeasure::small);
  const WaveMaterial soft = WaveMaterial::small_strain(1500, 20e9, {.shear_modulus = 9e9, .yield_stress = 100e6});
  const double elastic = soft.elastic_wave_speed() * 0.4e-6;
  const double plastic = soft.plastic_wave_speed() * 0.4e-6;
  EXPECT_NEAR(reference.at(0, -2e-3 + 0.5 * plastic).stress, -500e6, 1.0);
  EXPECT_NEAR(reference.at(0, -2e-3 + 0.5 * (plastic + elastic)).stress, -soft.elastic_limit(), 1.0);
  EXPECT_EQ(reference.at(0, -2e-3 + 1.01 * elastic).stress, 0.0);
  // A line to draw has each front twice.
  const auto line = reference.line(0);
  ASSERT_GE(line.size(), 6U);
  EXPECT_DOUBLE_EQ(line[1].initial_position, line[2].initial_position);
  EXPECT_NE(line[1].stress, line[2].stress);
}

std::string refusal_of(const std::string& text, double time = 1e-6) {
  try {
    SceneReference(scene_of(text), {time}, StrainMeasure::finite);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(SceneReference, SaysWhyAnotherSceneHasNone) {
  std::string gap = two_layers(pulse);
  gap.replace(gap.find("max = 1e-3"), 10, "max = 0.5e-3");
  EXPECT_TRUE(contains(refusal_of(gap), "'soft' and 'hard' do not touch")) << refusal_of(gap);
  const std::string voce =
      two_layers(pulse, "voce", ", yield_stress = 1e8, saturation_stress = 1e7, saturation_rate = 10");
  EXPECT_TRUE(contains(refusal_of(voce), "voce")) << refusal_of(voce);
  const std::string rod = two_layers(pulse, "j2", ", yield_stress = 1e8", "uniaxial_stress");
  EXPECT_TRUE(contains(refusal_of(rod), "hardening")) << refusal_of(rod);
}

TEST(SceneReference, EndsWhenTheBodiesLeaveAWall) {
  const std::string wall = "[[boundary]]\nname = 'wall'\ntype = 'rigid_wall'\npoint = [-2e-3]\nnormal = [1]\n";
  std::string text = two_layers(wall);
  for (const std::string name : {"'hard'\n", "'soft'\n"})
    text.insert(text.find("material = " + name) + 11 + name.size(), "velocity = [-10]\n");
  EXPECT_EQ(refusal_of(text, 0.5e-6), "");
  const SceneReference reference(scene_of(text), {0.5e-6}, StrainMeasure::finite);
  const double impedance = std::sqrt(1500.0 * (20e9 + 12e9));
  EXPECT_NEAR(reference.at(0, -1.9e-3).stress, -10.0 * impedance, 0.01 * 10.0 * impedance);  // finite strain: 0.2 %
  EXPECT_EQ(reference.at(0, -1.9e-3).velocity, 0.0);
  EXPECT_TRUE(contains(refusal_of(text, 8e-6), "leave the wall")) << refusal_of(text, 8e-6);
}

}  // namespace
}  // namespace anvil
