#include <gtest/gtest.h>

#include <cmath>

#include "capture/cameras/camera_rigs.h"
#include "checks/check_rig.h"
#include "checks/faults.h"
#include "checks/seen_studio.h"

namespace markerless_mocap {
namespace {

/// Points on the surface of somebody who stands and sways a little: head, shoulders, hips, feet.
std::vector<Eigen::Vector3d> bodyAt(double seconds) {
  const Eigen::Vector3d place(0.05 * std::sin(2.1 * seconds), 0.05 * std::sin(1.3 * seconds), 0);
  std::vector<Eigen::Vector3d> points{place + Eigen::Vector3d(0, 0, 1.75)};
  const std::pair<double, double> rings[] = {{1.65, 0.08}, {1.4, 0.2}, {0.9, 0.2}, {0.0, 0.15}};
  for (const auto& [height, radius] : rings)
    for (double angle = 0; angle < 2 * M_PI; angle += M_PI / 8)
      points.push_back(place +
                       Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), height));
  return points;
}

Outline outlineOf(const Camera& camera, const std::vector<Eigen::Vector3d>& corners) {
  Outline outline;
  std::vector<cv::Point2f> pixels, hull;
  for (const Eigen::Vector3d& corner : corners)
    if (const auto pixel = camera.project(corner))
      pixels.emplace_back(float(pixel->x()), float(pixel->y()));
  cv::convexHull(pixels, hull);
  for (const cv::Point2f& corner : hull) outline.hull.emplace_back(corner.x, corner.y);
  const cv::Moments moments = cv::moments(hull);
  outline.centre = {moments.m10 / moments.m00, moments.m01 / moments.m00};
  outline.area = moments.m00;
  return outline;
}

/// Somebody who stays on one spot, as the cameras of a rig see their silhouettes.
SeenRig filmedOnOneSpot(const std::string& kind) {
  constexpr int kImages = 120;
  RigPlan plan;
  plan.kind = kind;
  plan.width = 320;
  plan.height = 240;
  SeenRig rig;
  for (const Camera& camera : makeRig(plan)) {
    rig.cameras.push_back(emptyCamera(camera.calibration()));
    rig.cameras.back().masks_only = true;
    for (int i = 0; i < kImages; ++i) {
      SeenImage seen;
      seen.stamp_ns = seen.received_ns = 1000'000'000'000 + std::llround(1e9 * i / kTestRate);
      seen.width = plan.width;
      seen.height = plan.height;
      seen.fingerprint = uint64_t(i) + 1;
      seen.outline = outlineOf(camera, bodyAt(i / kTestRate));
      rig.cameras.back().images.push_back(seen);
    }
  }
  return rig;
}

std::vector<std::string> errorsOf(const SeenRig& rig) {
  std::vector<std::string> errors;
  for (const Finding& finding : checkRig(rig))
    if (finding.severity != Severity::kNote)
      errors.push_back(finding.what + (finding.camera.empty() ? "" : " " + finding.camera));
  return errors;
}

using Errors = std::vector<std::string>;

class RigPoses : public ::testing::TestWithParam<std::string> {};

TEST_P(RigPoses, GoodOnesAreNotComplainedOf) {
  EXPECT_EQ(errorsOf(filmedOnOneSpot(GetParam())), Errors());
}

/// A chair or an arm, which each camera sees elsewhere beside the person.
void moveMarks(SeenRig* rig, double pixels) {
  for (size_t i = 0; i < rig->cameras.size(); ++i)
    for (SeenImage& image : rig->cameras[i].images) {
      const Eigen::Vector2d by(i % 3 == 0 ? pixels : -pixels, i % 2 == 0 ? pixels : -pixels);
      image.outline->centre += by;
      for (Eigen::Vector2d& corner : image.outline->hull) corner += by;
    }
}

/// Towards one spot any rig can be turned, camera by camera, and then fits it better than the
/// truth.
TEST_P(RigPoses, BodyAxesAreNoTurnsOfAllCameras) {
  SeenRig rig = filmedOnOneSpot(GetParam());
  moveMarks(&rig, 1.5);
  Eigen::Matrix3d optical_of_body;
  optical_of_body << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  forAllPoses(&rig, [&](auto& pose) { pose.linear() = pose.linear() * optical_of_body; });
  EXPECT_EQ(errorsOf(rig), Errors{"axes_not_optical"});
}

/// Behind it there is what the cameras across the room see.
TEST_P(RigPoses, ACameraThatLooksOutOfTheRoomSharesNoVolume) {
  SeenRig rig = filmedOnOneSpot(GetParam());
  poseOf(&rig, 2).rotate(turnedBy(170, Eigen::Vector3d::UnitY()));
  for (SeenImage& image : rig.cameras[2].images) image.outline->hull.clear();
  EXPECT_EQ(errorsOf(rig), Errors{"no_common_volume cam2"});
}

INSTANTIATE_TEST_SUITE_P(Rigs, RigPoses,
                         ::testing::Values("ring4", "ring8", "ring7_overhead", "ceiling4",
                                           "random8"),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace markerless_mocap
