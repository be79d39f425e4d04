#include "evaluation/body_silhouette.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <vector>

#include "body/body_fixture.h"

namespace markerless_mocap {
namespace {

/// Looks along the world's +x from (-distance, 0, 0), upright, 500 px focal length.
CameraCalibration frontCamera(double distance) {
  CameraCalibration calibration;
  calibration.name = "front";
  calibration.width = 640;
  calibration.height = 640;
  calibration.K << 500, 0, 319.5, 0, 500, 319.5, 0, 0, 1;
  calibration.T_world_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  calibration.T_world_camera.translation() = Eigen::Vector3d(-distance, 0, 0);
  return calibration;
}

LinkPoses standing(const BodyModel& model, const Eigen::Vector3d& position) {
  Eigen::Isometry3d root = Eigen::Isometry3d::Identity();
  root.translation() = position;
  LinkPoses poses;
  model.forwardKinematics(root, Eigen::VectorXd::Zero(model.angleCount()), poses);
  return poses;
}

/// The slow judge: a pixel is body when its ray comes within some cone's radius of the cone's axis.
bool rayHits(const std::vector<RoundCone>& cones, const LinkPoses& poses, const Camera& camera,
             const Eigen::Vector2d& pixel) {
  const Eigen::Vector3d direction = camera.rayDirection(pixel);
  for (const RoundCone& cone : cones) {
    for (int k = 0; k <= 200; ++k) {
      const double s = k / 200.0;
      const Eigen::Vector3d point =
          poses[cone.link] * Eigen::Vector3d((1 - s) * cone.a + s * cone.b) - camera.position();
      const double radius = (1 - s) * cone.radius_a + s * cone.radius_b;
      if (point.dot(direction) > 0 && point.cross(direction).norm() <= radius) return true;
    }
  }
  return false;
}

/// Compares every fourth pixel in x and y with the judge.
void expectAgreesWithRays(const cv::Mat& mask, const std::vector<RoundCone>& cones,
                          const LinkPoses& poses, const Camera& camera) {
  constexpr int kStep = 4;
  int body = 0, different = 0;
  for (int y = 0; y < mask.rows; y += kStep)
    for (int x = 0; x < mask.cols; x += kStep) {
      const bool hit = rayHits(cones, poses, camera, {x, y});
      body += hit;
      different += hit != (mask.at<uint8_t>(y, x) == 255);
    }
  EXPECT_GT(body, 500);
  EXPECT_LT(different, 0.04 * body);  // pixels on the outline may fall on either side
}

TEST(BodySilhouette, AgreesWithRaysThroughADistortingLens) {
  const BodyModel model = human();
  CameraCalibration calibration = frontCamera(3.0);
  calibration.D = {-0.25, 0.08, 0.001, -0.001};
  const Camera camera(calibration);
  const LinkPoses poses = standing(model, {0, 0, 0});
  expectAgreesWithRays(bodySilhouette(model, poses, camera), model.shape(), poses, camera);
}

TEST(BodySilhouette, BodyBehindTheCameraIsNotSeen) {
  const BodyModel model = human();
  const Camera camera(frontCamera(3.0));
  const LinkPoses poses = standing(model, {-8, 0, 0});
  EXPECT_EQ(cv::countNonZero(bodySilhouette(model, poses, camera)), 0);
}

TEST(BodySilhouette, OnlyShownLinksAreDrawn) {
  const BodyModel model = human();
  const Camera camera(frontCamera(3.0));
  const LinkPoses poses = standing(model, {0, 0, 0});
  std::vector<bool> head_only(model.links().size(), false);
  EXPECT_EQ(cv::countNonZero(bodySilhouette(model, poses, camera, head_only)), 0);
  for (const RoundCone& cone : model.shape())
    if (model.links()[cone.link] == "head_person1") head_only[cone.link] = true;
  const int head = cv::countNonZero(bodySilhouette(model, poses, camera, head_only));
  EXPECT_GT(head, 0);
  EXPECT_LT(head, 0.2 * cv::countNonZero(bodySilhouette(model, poses, camera)));
}

// The body lies with its legs along the camera's view. Cones around and behind the camera are left
// out, the others are drawn.
TEST(BodySilhouette, CameraInsideTheBodySeesTheRestOfIt) {
  const BodyModel model = human();
  const Camera camera(frontCamera(0.0));
  LinkPoses poses = standing(model, {0, 0, 0});
  const Eigen::Isometry3d lying(Eigen::AngleAxisd(-M_PI / 2, Eigen::Vector3d::UnitY()));
  for (Eigen::Isometry3d& pose : poses) pose = lying * pose;

  bool inside = false;
  std::vector<RoundCone> in_front;
  for (const RoundCone& cone : model.shape()) {
    const Eigen::Vector3d a = poses[cone.link] * cone.a, b = poses[cone.link] * cone.b;
    inside = inside || a.norm() < cone.radius_a || b.norm() < cone.radius_b;
    if (a.x() > cone.radius_a && b.x() > cone.radius_b) in_front.push_back(cone);
  }
  ASSERT_TRUE(inside);
  ASSERT_LT(in_front.size(), model.shape().size());
  expectAgreesWithRays(bodySilhouette(model, poses, camera), in_front, poses, camera);
}

TEST(MaskIou, CountsByHand) {
  const cv::Mat a = (cv::Mat_<uint8_t>(2, 3) << 255, 255, 0, 0, 1, 0);
  const cv::Mat b = (cv::Mat_<uint8_t>(2, 3) << 0, 255, 255, 0, 255, 0);
  EXPECT_DOUBLE_EQ(maskIou(a, b), 2.0 / 4.0);
  EXPECT_DOUBLE_EQ(maskIou(a, a), 1.0);
}

TEST(MaskIou, WhatIsUnknownInOneOfTheMasksIsLeftOut) {
  const cv::Mat a = (cv::Mat_<uint8_t>(2, 3) << 255, 128, 0, 128, 1, 0);
  const cv::Mat b = (cv::Mat_<uint8_t>(2, 3) << 0, 255, 128, 0, 255, 0);
  EXPECT_DOUBLE_EQ(maskIou(a, b), 1.0 / 2.0);
  EXPECT_DOUBLE_EQ(maskIou(b, a), 1.0 / 2.0);
}

TEST(MaskIou, TwoEmptyMasksAgreeOnNothing) {
  const cv::Mat empty = cv::Mat::zeros(4, 4, CV_8UC1);
  EXPECT_EQ(maskIou(empty, empty), 0.0);
}

TEST(MaskIou, DifferentSizesAreRefused) {
  EXPECT_THROW(maskIou(cv::Mat::zeros(4, 4, CV_8UC1), cv::Mat::zeros(4, 5, CV_8UC1)),
               std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
