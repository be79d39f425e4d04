#include "capture/render/mesh_renderer.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "capture/mesh_fixture.h"

namespace markerless_mocap {
namespace {

const TexturedRoom kRoom(1, 5, 5, 3.2);
const Eigen::Vector3f kRed(1, 0, 0), kBlue(0, 0, 1);

struct Hit {
  double distance = std::numeric_limits<double>::infinity();
  bool person = false;
};

/// Moeller and Trumbore's test against every triangle.
Hit cast(const Eigen::Vector3d& eye, const Eigen::Vector3d& ray,
         const std::vector<SceneObject>& objects) {
  Hit nearest;
  for (const SceneObject& object : objects)
    for (const auto& [i, j, k] : object.mesh->triangles) {
      const Eigen::Vector3d a = object.vertices[i].cast<double>();
      const Eigen::Vector3d ab = object.vertices[j].cast<double>() - a;
      const Eigen::Vector3d ac = object.vertices[k].cast<double>() - a;
      const Eigen::Vector3d p = ray.cross(ac), q = (eye - a).cross(ab);
      const double det = ab.dot(p);
      const double u = (eye - a).dot(p) / det, v = ray.dot(q) / det, t = ac.dot(q) / det;
      if (u >= 0 && v >= 0 && u + v <= 1 && t > 0 && t < nearest.distance)
        nearest = {t, object.person};
    }
  return nearest;
}

/// Compares mask and depth with cast() but where an edge passes a pixel's centre closer than a
/// thousandth of a pixel.
void expectSameAsCasting(const Camera& camera, const std::vector<SceneObject>& objects) {
  const RenderedView view = MeshRenderer(camera, kRoom).render(LitScene(kRoom, objects, 0.5));
  int checked = 0, wrong = 0, persons = 0, things = 0;
  for (int y = 0; y < camera.height(); ++y)
    for (int x = 0; x < camera.width(); ++x) {
      const auto hitAt = [&](double dx, double dy) {
        return cast(camera.position(), camera.rayDirection({x + dx, y + dy}), objects);
      };
      const Hit one = hitAt(1e-3, 4e-4), other = hitAt(-1e-3, -4e-4);
      const double depth = one.distance;
      const bool seen = std::isfinite(depth);
      if (one.person != other.person || seen != std::isfinite(other.distance)) continue;
      if (seen && std::abs(other.distance - depth) > 0.01) continue;
      ++checked;
      persons += one.person;
      things += seen && !one.person;
      const float drawn = view.depth.at<float>(y, x);
      const bool same_depth = seen ? std::abs(drawn - depth) < 0.011 : std::isinf(drawn);
      wrong += !same_depth || (view.mask.at<uint8_t>(y, x) == 255) != one.person;
    }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(checked, 0.97 * camera.width() * camera.height());
  EXPECT_GT(persons, 1000);
  EXPECT_GT(things, 1000);
}

TEST(MeshRendererTest, maskAndDepthAreThoseOfRaysThroughPixelCentres) {
  const ColoredMesh soup = triangleSoup(200, {-1, -1, 0.3f}, {1, 1, 1.7f}, 1);
  const ColoredMesh other = triangleSoup(200, {-1, -1, 0.3f}, {1, 1, 1.7f}, 2);
  const std::vector<SceneObject> objects = {placed(soup, 1, {0, 0, 0}),
                                            placed(other, 1, {0, 0, 0}, false)};
  expectSameAsCasting(sideCamera(kLens), objects);
  expectSameAsCasting(sideCamera(), objects);
}

TEST(MeshRendererTest, trianglesThatReachBehindTheCameraAreDrawnAsFarAsTheyAreSeen) {
  const ColoredMesh soup = triangleSoup(60, {1, -2, -0.5f}, {5, 2, 2.5f}, 3);
  const ColoredMesh other = triangleSoup(60, {1, -2, -0.5f}, {5, 2, 2.5f}, 4);
  const std::vector<SceneObject> objects = {placed(soup, 1, {0, 0, 0}),
                                            placed(other, 1, {0, 0, 0}, false)};
  expectSameAsCasting(sideCamera(kLens), objects);
}

TEST(MeshRendererTest, nearObjectHidesTheFarOneInEitherOrder) {
  const MeshRenderer renderer(sideCamera(), kRoom);
  const ColoredMesh red = ball(16, kRed), blue = ball(16, kBlue);
  const SceneObject near = placed(red, 0.1f, {1, 0, 1}), far = placed(blue, 0.8f, {-1, 0, 1});
  for (const auto& objects : {std::vector{near, far}, std::vector{far, near}}) {
    const RenderedView view = renderer.render(LitScene(kRoom, objects, 0.0));
    const cv::Vec3b center = view.image.at<cv::Vec3b>(59, 79),
                    beside = view.image.at<cv::Vec3b>(59, 95);
    EXPECT_GT(center[2], 60);
    EXPECT_EQ(center[0], 0);
    EXPECT_GT(beside[0], 60);
    EXPECT_EQ(beside[2], 0);
    EXPECT_NEAR(view.depth.at<float>(59, 79), 1.9, 2e-3);
  }
}

TEST(MeshRendererTest, maskLeavesOutWhatAThingHides) {
  const MeshRenderer renderer(sideCamera(), kRoom);
  const ColoredMesh red = ball(16, kRed);
  const SceneObject person = placed(red, 0.4f, {-1, 0, 1}),
                    thing = placed(red, 0.1f, {1, 0, 1}, false);
  const RenderedView whole = renderer.render(LitScene(kRoom, {person}, 0.0));
  const RenderedView hidden = renderer.render(LitScene(kRoom, {person, thing}, 0.0));
  const RenderedView alone = renderer.render(LitScene(kRoom, {thing}, 0.0));
  EXPECT_EQ(cv::countNonZero(alone.mask), 0);
  const cv::Mat thing_seen = alone.depth < 100.0;
  EXPECT_GT(cv::countNonZero(thing_seen), 100);
  EXPECT_EQ(cv::norm(hidden.mask, whole.mask & ~thing_seen, cv::NORM_INF), 0.0);
}

TEST(MeshRendererTest, closedSurfaceHasNoPinholes) {
  const Camera camera = sideCamera(kLens);
  const MeshRenderer renderer(camera, kRoom);
  const double radius = 0.5;
  for (const int rings : {6, 31, 120}) {
    const ColoredMesh mesh = ball(rings, kRed);
    const SceneObject object = placed(mesh, float(radius), {0, 0, 1});
    const RenderedView view = renderer.render(LitScene(kRoom, {object}, 0.0));
    // The polyhedron holds a ball of this radius.
    const double inner = radius * std::pow(std::cos(1.5708 / rings), 2);
    for (int y = 0; y < camera.height(); ++y)
      for (int x = 0; x < camera.width(); ++x) {
        const Eigen::Vector3d ray = camera.rayDirection({double(x), double(y)});
        const Eigen::Vector3d to_center = Eigen::Vector3d(0, 0, 1) - camera.position();
        const bool met = ray.cross(to_center).norm() < 0.999 * inner;
        ASSERT_TRUE(!met || view.mask.at<uint8_t>(y, x)) << rings << ": " << x << " " << y;
      }
  }
}

TEST(MeshRendererTest, edgesMixWithWhatIsBehind) {
  const ColoredMesh white = ball(60, {1, 1, 1});
  const MeshRenderer renderer(sideCamera(), kRoom);
  const RenderedView view = renderer.render(LitScene(kRoom, {placed(white, 0.5f, {0, 0, 1})}, 0.0));
  cv::Mat changed = view.image != renderer.background();
  cv::cvtColor(changed, changed, cv::COLOR_BGR2GRAY);
  const int area = cv::countNonZero(view.mask), touched = cv::countNonZero(changed);
  // A rim of up to a pixel's width about a disc of 25 pixels' radius.
  EXPECT_GT(touched, area + 60);
  EXPECT_LT(touched, area + 260);
}

TEST(MeshRendererTest, emptySceneIsTheBackground) {
  const MeshRenderer renderer(sideCamera(kLens), kRoom);
  const ColoredMesh red = ball(8, kRed);
  for (const LitScene& scene :
       {LitScene(kRoom, {}, 1.0), LitScene(kRoom, {placed(red, 0.3f, {4.5f, 0, 1})}, 0.0)}) {
    const RenderedView view = renderer.render(scene);  // nothing, or behind the camera
    EXPECT_EQ(cv::norm(view.image, renderer.background(), cv::NORM_INF), 0.0);
    EXPECT_EQ(cv::countNonZero(view.mask), 0);
    EXPECT_TRUE(std::isinf(view.depth.at<float>(60, 80)));
  }
}

TEST(MeshRendererTest, oneThreadDrawsTheSameBytes) {
  const ColoredMesh soup = triangleSoup(3000, {-1, -1, 0.3f}, {1, 1, 1.7f}, 5);
  const auto draw = [&](size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const MeshRenderer renderer = makeRenderers({sideCamera(kLens)}, kRoom).front();
    return renderer.render(LitScene(kRoom, {placed(soup, 1, {0, 0, 0})}, 0.7));
  };
  const RenderedView one = draw(1), many = draw(4);
  EXPECT_EQ(cv::norm(one.image, many.image, cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(one.mask, many.mask, cv::NORM_INF), 0.0);
}

TEST(MotionBlurTest, imagesAreAveragedAndTheMaskIsTheMiddleOne) {
  std::vector<RenderedView> shots(3);
  for (int i = 0; i < 3; ++i) {
    shots[i].image = cv::Mat(2, 2, CV_8UC3, cv::Scalar(10 * i, 100, 7));
    shots[i].mask = cv::Mat(2, 2, CV_8UC1, cv::Scalar(i == 1 ? 255 : 0));
  }
  const RenderedView blurred = motionBlurred(shots);
  EXPECT_EQ(blurred.image.at<cv::Vec3b>(1, 1), cv::Vec3b(10, 100, 7));
  EXPECT_EQ(blurred.mask.at<uint8_t>(0, 0), 255);
  EXPECT_EQ(shots[1].image.at<cv::Vec3b>(0, 0), cv::Vec3b(10, 100, 7));
  EXPECT_THROW(motionBlurred({}), std::invalid_argument);
  shots[2].image = cv::Mat(3, 2, CV_8UC3);
  EXPECT_THROW(motionBlurred(shots), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
