// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/check.hpp"

#include "unit/scene/scene_texts.hpp"

namespace anvil {
namespace {

std::string second_body(const std::string& shape) {
  return "[[body]]\nname = 'second'\nmaterial = 'soft'\nshape = " + shape + "\n";
}

std::string wall(const std::string& point, const std::string& normal) {
  return "[[boundary]]\nname = 'wall'\ntype = 'rigid_wall'\npoint = " + point + "\nnormal = " + normal + "\n";
}

TEST(Check, BodiesMayTouch) {
  const std::string beside = second_body("{ type = 'box', min = [4e-3, 0, 0], max = [8e-3, 4e-3, 8e-3] }");
  EXPECT_EQ(read_scene_text(small_scene + beside, "touching").bodies.size(), 2u);
}

TEST(Check, BodiesMayNotOverlap) {
  // By a hundredth of a spacing: far more than rounding, far less than a particle.
  const std::string inside = second_body("{ type = 'box', min = [3.99e-3, 0, 0], max = [7.99e-3, 4e-3, 8e-3] }");
  EXPECT_TRUE(contains(message_of(small_scene + inside), "key 'body.second.shape': the body overlaps the body 'bar'"));
}

TEST(Check, CurvedBodiesAreComparedByTheirParticles) {
  const auto bar_at = [](const std::string& x) {
    return second_body("{ type = 'cylinder', base = [" + x + ", 2e-3, 0], radius = 2e-3, length = 8e-3 }");
  };
  // The surrounding boxes overlap in both, the particles only in the second.
  EXPECT_EQ(read_scene_text(small_scene + bar_at("5.9e-3"), "apart").bodies.size(), 2u);
  EXPECT_TRUE(contains(message_of(small_scene + bar_at("4.2e-3")), "the body overlaps the body 'bar'"));
}

TEST(Check, BodiesMayTouchAWall) {
  EXPECT_EQ(read_scene_text(small_scene + wall("[0, 0, 0]", "[0, 0, 5]"), "touching").boundaries.size(), 1u);
}

TEST(Check, BodiesMayNotStartBehindAWall) {
  EXPECT_TRUE(contains(message_of(small_scene + wall("[0, 0, 0.5e-3]", "[0, 0, 1]")),
                       "starts 0.0005 m behind the wall 'wall'"));
  EXPECT_TRUE(
      contains(message_of(small_scene + wall("[0, 0, 0]", "[0, 0, -1]")), "starts 0.008 m behind the wall 'wall'"));
  // An inclined wall through the origin cuts off the corner at x = 4e-3: 4e-3/sqrt(2) deep.
  EXPECT_TRUE(contains(message_of(small_scene + wall("[0, 0, 0]", "[-1, 1, 0]")), "starts 0.00282843 m behind"));
}

TEST(Check, NamesASpacingThatFitsAllSides) {
  const std::string message = message_of(small_scene, {"discretisation.spacing=0.9e-3"});
  EXPECT_TRUE(contains(message, "0.004 m is 4.44444 spacings of 0.0009 m")) << message;
  const auto number = message.find_last_of("0123456789");
  ASSERT_NE(number, std::string::npos);
  const auto begin = message.rfind(' ', number);
  const std::string spacing = message.substr(begin + 1, number - begin);
  EXPECT_NO_THROW(read_scene_text(small_scene, "fitting", {"discretisation.spacing=" + spacing})) << spacing;
}

TEST(Check, FindsFaultsInScenesThatWereNotRead) {
  Scene scene = read_scene_text(small_scene, "small");
  EXPECT_NO_THROW(check_scene(scene));
  scene.domain.strain_state = "plane_strain";
  scene.bodies.at(0).velocity = {0.0, 0.0, 1e9};
  EXPECT_EQ(find_contradictions(scene).size(), 2u);
  EXPECT_THROW(check_scene(scene), InputError);
}

}  // namespace
}  // namespace anvil
