#include "capture/scene/room_light.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "capture/mesh_fixture.h"
#include "capture/scene/shadow_map.h"

namespace markerless_mocap {
namespace {

const TexturedRoom kRoom(1, 5, 5, 3.2);
const Eigen::Vector3f kInPane(-0.4f, 0.7f, 0), kOnBar(-0.6f, 0.7f, 0), kOutside(0, 2, 0);

RoomLight sunny() {
  RoomLight light;
  light.sun = 0.8f;
  return light;
}

TEST(RoomLightTest, sunShinesThroughThePanesOnly) {
  EXPECT_NEAR(sunlightAt(sunny(), kInPane).x(), 0.8f, 1e-6f);
  EXPECT_LT(sunlightAt(sunny(), kOnBar).x(), 1e-4f);
  EXPECT_EQ(sunlightAt(sunny(), kOutside).x(), 0.0f);
  EXPECT_EQ(sunlightAt(RoomLight(), kInPane).x(), 0.0f);
  EXPECT_LT(sunlightAt(sunny(), kInPane).z(), sunlightAt(sunny(), kInPane).x());  // warm
}

TEST(RoomLightTest, patchesFollowTheirShiftAndTheSunsRays) {
  RoomLight shifted = sunny();
  shifted.sun_shift << 0.6f, 1.3f;
  EXPECT_EQ(sunlightAt(shifted, kInPane).x(), 0.0f);
  EXPECT_NEAR(sunlightAt(shifted, kInPane + Eigen::Vector3f(0.6f, 1.3f, 0)).x(), 0.8f, 1e-6f);
  const Eigen::Vector3f towards_sun = (sunLamp().position - kInPane) * 0.15f;
  EXPECT_NEAR(sunlightAt(sunny(), kInPane + towards_sun).x(), 0.8f, 1e-6f);
  EXPECT_EQ(sunlightAt(sunny(), kInPane + Eigen::Vector3f(0, 0, towards_sun.z())).x(), 0.0f);
}

TEST(RoomLightTest, mainLampGivesLessLightFurtherAway) {
  const Lamp& lamp = kRoom.lamps()[kMainLamp];
  const auto at = [&](float aside) {
    return mainLampAt(lamp, {lamp.position.x() + aside, lamp.position.y(), 0});
  };
  EXPECT_GT(at(0), 2 * at(3));
  EXPECT_GT(at(3), at(6));
  EXPECT_LT(at(0), 1.0f);
  for (const Lamp& other : kRoom.lamps()) EXPECT_LE(other.fraction, lamp.fraction);
}

TEST(RoomLightTest, lampThatIsOffTakesItsLightAndItsShadow) {
  const ColoredMesh mesh = ball(20, {0.5f, 0.5f, 0.5f});
  const MeshRenderer renderer(sideCamera(), kRoom);
  RoomLight off;
  off.main_lamp = 0.0f;
  const auto lit = [&](const RoomLight& light) {
    return LitScene(kRoom, {placed(mesh, 0.3f, {0, 0, 1})}, 0.5, light);
  };
  const LitScene usual = lit({}), dim = lit(off);
  EXPECT_EQ(usual.lampOn(kMainLamp), 1.0f);
  EXPECT_EQ(dim.lampOn(kMainLamp), 0.0f);
  EXPECT_EQ(dim.lampOn(kMainLamp + 1), 1.0f);
  EXPECT_LT(dim.litColors(0).back().x(), 0.9f * usual.litColors(0).back().x());
  const auto mean = [&](const LitScene& scene) {
    return cv::mean(renderer.render(scene).image)[1];
  };
  EXPECT_LT(mean(dim), 0.97 * mean(usual));
}

TEST(RoomLightTest, objectInASunPatchIsBrightAndCastsAShadowIntoIt) {
  const ColoredMesh mesh = ball(20, {0.4f, 0.4f, 0.4f});
  const Eigen::Vector3f place = kInPane + (sunLamp().position - kInPane) * 0.06f;
  const LitScene scene(kRoom, {placed(mesh, 0.1f, place)}, 0.0, sunny());
  const LitScene without(kRoom, {placed(mesh, 0.1f, place)}, 0.0);
  EXPECT_EQ(without.sunShadow(), nullptr);
  ASSERT_NE(scene.sunShadow(), nullptr);
  EXPECT_NEAR(scene.sunShadow()->occlusion(shadowTexel(sunLamp(), kInPane)), 1.0f, 1e-5f);
  EXPECT_EQ(scene.sunShadow()->occlusion(shadowTexel(sunLamp(), kOutside)), 0.0f);
  // The top sees the sun, the bottom does not.
  EXPECT_GT(scene.litColors(0).back().x(), without.litColors(0).back().x() + 0.1f);
  EXPECT_EQ(scene.litColors(0).front().x(), without.litColors(0).front().x());
}

TEST(RoomLightTest, whatShinesKeepsItsColorsAndCastsNoShadow) {
  const ColoredMesh mesh = ball(20, {0.5f, 0.6f, 0.7f});
  SceneObject object = placed(mesh, 0.3f, {0, 0, 1}, false);
  object.shines = true;
  const LitScene scene(kRoom, {object}, 1.0);
  EXPECT_EQ(scene.litColors(0), mesh.colors);
  for (const ShadowMap& map : scene.shadowMaps()) EXPECT_TRUE(map.empty());
}

}  // namespace
}  // namespace markerless_mocap
