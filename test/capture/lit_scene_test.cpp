#include "capture/scene/lit_scene.h"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "capture/mesh_fixture.h"
#include "capture/scene/shadow_map.h"
#include "error_text_of.h"

namespace markerless_mocap {
namespace {

const TexturedRoom kRoom(1, 5, 5, 3.2);

std::string refusal(const SceneObject& object, double strength = 0.5) {
  return errorTextOf([&] { LitScene(kRoom, {object}, strength); });
}

TEST(ShadowMapTest, shadowFallsOnTheSideAwayFromTheLamp) {
  const Lamp lamp{{2.0f, 0.0f, 3.0f}, 1.0f, 0.1f};
  const ColoredMesh mesh = ball(20, {1, 1, 1});
  const ShadowMap map(lamp, {placed(mesh, 0.2f, {0, 0, 1})});
  const auto dark = [&](const Eigen::Vector3f& place) {
    return map.occlusion(shadowTexel(lamp, place));
  };
  EXPECT_NEAR(dark({-1, 0, 0}), 1.0, 1e-5);  // lamp, ball's middle and this are in line
  EXPECT_EQ(dark({1, 0, 0}), 0.0f);
  EXPECT_EQ(dark({-1, 0.8f, 0}), 0.0f);
  EXPECT_NEAR(dark({-0.7f, 0, 0.3f}), 1.0, 1e-5);  // a wall's place in the same line
}

TEST(ShadowMapTest, shadowOfSomethingHighIsSofter) {
  const Lamp lamp{{0, 0, 3.0f}, 1.0f, 0.15f};
  const ColoredMesh mesh = ball(30, {1, 1, 1});
  const auto penumbra = [&](float height, float radius) {
    const ShadowMap map(lamp, {placed(mesh, radius, {0, 0, height})});
    int partly = 0;
    for (float x = 0.0f; x < 1.5f; x += 0.01f) {
      const float dark = map.occlusion(shadowTexel(lamp, {x, 0, 0}));
      partly += dark > 0.02f && dark < 0.98f;
    }
    return partly;
  };
  EXPECT_GT(penumbra(1.5f, 0.2f), penumbra(0.3f, 0.2f) + 5);
}

TEST(ShadowMapTest, onlyWhatIsNearerToTheLampHidesIt) {
  const Lamp lamp{{0, 0, 3.0f}, 1.0f, 0.1f};
  const ColoredMesh mesh = ball(20, {1, 1, 1});
  const ShadowMap map(lamp, {placed(mesh, 0.3f, {0.013f, 0.007f, 1})});
  EXPECT_EQ(map.occludedFraction({0, 0, 0.5f}), 1.0f);
  EXPECT_EQ(map.occludedFraction({0, 0, 1.3f}), 0.0f);  // the ball's own top
  EXPECT_EQ(map.occludedFraction({0, 0, 2.0f}), 0.0f);
  EXPECT_EQ(map.occludedFraction({1, 0, 0.5f}), 0.0f);
}

TEST(LitSceneTest, shadowsDarkenTheFloorByTheirStrength) {
  const MeshRenderer renderer(sideCamera(), kRoom);
  const ColoredMesh mesh = ball(20, {1, 1, 1});
  const auto darkest = [&](double strength) {
    const RenderedView view =
        renderer.render(LitScene(kRoom, {placed(mesh, 0.3f, {0, 0, 0.7f})}, strength));
    cv::Mat object;
    cv::dilate(view.mask, object, cv::Mat(), {-1, -1}, 2);
    double least = 1.0;
    for (int y = 70; y < 120; ++y)
      for (int x = 0; x < 160; ++x)
        if (!object.at<uint8_t>(y, x))
          least = std::min(least, double(view.image.at<cv::Vec3b>(y, x)[1]) /
                                      renderer.background().at<cv::Vec3b>(y, x)[1]);
    return least;
  };
  EXPECT_EQ(darkest(0.0), 1.0);
  EXPECT_NEAR(1.0 - darkest(0.4), 0.4 * (1.0 - darkest(1.0)), 0.02);
  EXPECT_LT(darkest(1.0), 0.6);
}

TEST(LitSceneTest, upperSideIsBrighter) {
  const ColoredMesh mesh = ball(10, {0.5f, 0.5f, 0.5f});
  const LitScene scene(kRoom, {placed(mesh, 0.3f, {0, 0, 1})}, 0.0);
  const auto& colors = scene.litColors(0);
  EXPECT_GT(colors.back().x(), 1.5f * colors.front().x());  // the last ring is the top
  for (const Eigen::Vector3f& color : colors) EXPECT_GT(color.minCoeff(), 0.1f);
}

TEST(LitSceneTest, badScenesAreRefused) {
  const ColoredMesh mesh = ball(4, {1, 1, 1});
  EXPECT_NE(refusal(placed(mesh, 1, {0, 0, 1}), 1.5).find("allowed is 0 to 1"), std::string::npos);
  EXPECT_NE(refusal({mesh.vertices, nullptr, true}).find("no mesh"), std::string::npos);
  SceneObject object = placed(mesh, 1, {0, 0, 1});
  object.vertices[3].y() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(refusal(object).find("not finite"), std::string::npos);
  object.vertices.pop_back();
  EXPECT_NE(refusal(object).find("must be equal"), std::string::npos);
  ColoredMesh broken = mesh;
  broken.triangles[0][1] = int(mesh.vertices.size());
  EXPECT_NE(refusal(placed(broken, 1, {0, 0, 1})).find("scene object 0: a triangle has vertex"),
            std::string::npos);
}

}  // namespace
}  // namespace markerless_mocap
