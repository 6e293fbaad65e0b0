// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/writer.hpp"

#include "anvil/core/data_path.hpp"
#include "unit/scene/scene_texts.hpp"

namespace anvil {
namespace {

TEST(Writer, EveryBundledSceneReadsBackTheSame) {
  for (const auto& file : list_bundled("scenes", ".toml")) {
    const Scene scene = read_scene(find_bundled("scenes", file));
    EXPECT_EQ(read_scene_text(write_scene(scene), scene.name), scene) << file;
  }
}

TEST(Writer, NumbersKeepEveryBit) {
  Scene scene = read_scene_text(small_scene, "small");
  for (const double number : {0.1, 1.0 / 3.0, 1e-6 + 1e-22, 5e-324, 1.7976931348623157e308, 1e22, 3.0}) {
    scene.time.end = number;
    scene.output.interval = number;
    EXPECT_EQ(read_scene_text(write_scene(scene), "small").time.end, number);
  }
}

TEST(Writer, TextsSurviveQuotesAndOtherAlphabets) {
  Scene scene = read_scene_text(small_scene, "small");
  for (const std::string title : {"a \"quoted\" word", "back\\slash", "tab\tand\nline", "Stoßwelle 冲击波", ""}) {
    scene.title = title;
    EXPECT_EQ(read_scene_text(write_scene(scene), "small").title, title);
  }
}

TEST(Writer, RunThatEndsAtOnceReadsBack) {
  const Scene scene = read_scene_text(small_scene, "small", {"time.end=0"});
  EXPECT_GT(scene.output.interval, 0.0);
  EXPECT_EQ(read_scene_text(write_scene(scene), "small"), scene);
}

TEST(Writer, JsonHoldsTheResolvedScene) {
  const std::string json = write_scene_json(read_scene_text(small_scene, "small"));
  EXPECT_TRUE(contains(json, "\"kernel\" : \"cubic_spline\"")) << json;
  EXPECT_TRUE(contains(json, "\"density\" : 1000.0")) << json;
}

}  // namespace
}  // namespace anvil
