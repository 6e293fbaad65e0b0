// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/reader.hpp"

#include "unit/scene/scene_texts.hpp"

namespace anvil {
namespace {

Scene read_with(const std::vector<std::string>& overrides) { return read_scene_text(small_scene, "small", overrides); }

TEST(Overrides, ReplaceAndAddKeys) {
  const Scene scene = read_with({"time.end=2e-6", "discretisation.smoothing_ratio = 1.2", "title=\"two words\""});
  EXPECT_EQ(scene.time.end, 2e-6);
  EXPECT_EQ(scene.discretisation.smoothing_ratio, 1.2);
  EXPECT_EQ(scene.title, "two words");
}

TEST(Overrides, MakeSectionsThatTheFileLacks) {
  EXPECT_EQ(read_with({"stabiliser.conservative_smoothing=0.14"}).stabiliser.conservative_smoothing, 0.14);
  EXPECT_EQ(read_with({"compare.tolerance.length=0.02"}).compare.tolerance.at("length"), 0.02);
}

TEST(Overrides, TakeWordsWithoutQuotes) {
  EXPECT_EQ(read_with({"discretisation.kernel=gaussian"}).discretisation.kernel, "gaussian");
  EXPECT_EQ(read_with({"title=Bar at rest"}).title, "Bar at rest");
}

TEST(Overrides, AddressBodiesAndBoundariesByName) {
  const Scene scene =
      read_scene(locate_scene("rod_square"), {"body.rod.velocity=[0,0,-300]", "boundary.anvil.point=[0,0,-1e-3]"});
  EXPECT_EQ(scene.bodies.at(0).velocity, (std::vector<double>{0.0, 0.0, -300.0}));
  EXPECT_EQ(scene.boundaries.at(0).entry.parameters.numbers("point"), (std::vector<double>{0.0, 0.0, -1e-3}));
}

TEST(Overrides, ReachIntoShapesAndLaws) {
  const Scene scene = read_scene(locate_scene("rod_square"), {"material.copper.strength.yield_stress=3e8",
                                                              "body.rod.shape.max=[3.2e-3,3.2e-3,16e-3]"});
  EXPECT_EQ(scene.materials.at(0).strength.parameters.number("yield_stress"), 3e8);
  EXPECT_EQ(scene.bodies.at(0).shape.parameters.numbers("max").at(2), 16e-3);
}

TEST(Overrides, ChangeABundledMaterialThatAnotherOverrideAskedFor) {
  const Scene scene = read_with({"material.steel.density=7000", "body.bar.material=steel"});
  ASSERT_EQ(scene.materials.size(), 1u);
  EXPECT_EQ(scene.materials[0].density, 7000.0);
  EXPECT_EQ(scene.materials[0].eos.parameters.number("bulk_modulus"), 222.5e9);
}

TEST(Overrides, LaterOnesWin) { EXPECT_EQ(read_with({"time.end=2e-6", "time.end=3e-6"}).time.end, 3e-6); }

struct Refused {
  std::string override_text;
  std::string phrase;
};

class RefusedOverride : public testing::TestWithParam<Refused> {};

TEST_P(RefusedOverride, IsNamedAsThePlace) {
  const auto& [override_text, phrase] = GetParam();
  const std::string message = message_of(small_scene, {override_text});
  EXPECT_TRUE(message.starts_with("--set " + override_text + ": ")) << message;
  EXPECT_TRUE(contains(message, phrase)) << message;
}

INSTANTIATE_TEST_SUITE_P(
    All, RefusedOverride,
    testing::Values(
        Refused{"discretisation.spcing=1e-3", "key 'discretisation.spcing' is unknown; did you mean 'spacing'?"},
        Refused{"discretisation.spacing=small", "must be a positive number in m, found the text \"small\""},
        Refused{"discretisation.spacing=-1", "must be a positive number in m, found -1"},
        Refused{"discretisation.spacing=nan", "must be a positive number in m, found nan"},
        Refused{"discretisation.spacing=", "must be a positive number in m, found the text \"\""},
        Refused{"discretisation.spacing.x=1", "'spacing' is a value and has no keys"},
        Refused{"discretisation.kernel=cubik_spline", "did you mean 'cubic_spline'?"},
        Refused{"discretsation.spacing=1", "section 'discretsation' is unknown; did you mean 'discretisation'?"},
        Refused{"body.ber.velocity=[0,0,1]", "there is no body named 'ber'; did you mean 'bar'?"},
        Refused{"body.bar.velocity=[0,0]", "must be a list of 3 numbers in m/s, as [x, y, z], found 2 of them"},
        Refused{"body.bar=1", "say which key of body 'bar'"},
        Refused{"body.bar.shape.mx=[1,1,1]", "key 'body.bar.shape.mx' is unknown; did you mean 'max'?"},
        Refused{"body.bar.material=copr", "did you mean 'copper'?"},
        Refused{"boundary.wall.point=[0,0,0]", "there is no boundary named 'wall'"},
        Refused{"material.soft.density=heavy", "'material.soft.density' must be a positive number in kg/m3"},
        Refused{"titel=x", "key 'titel' is unknown; did you mean 'title'?"},
        Refused{"time.end", "an override is written KEY=VALUE"}, Refused{"=1", "an override is written KEY=VALUE"},
        Refused{"time..end=1", "something is missing beside a dot"},
        Refused{"time.end=1\ntime.cfl=2", "must be a number in s, zero or more, found the text"}));

}  // namespace
}  // namespace anvil
