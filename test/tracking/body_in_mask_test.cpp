#include "tracking/body_in_mask.h"

#include <gtest/gtest.h>

#include "tracking/standing_person.h"

namespace markerless_mocap {
namespace {

class BodyInMask : public ::testing::Test {
 protected:
  bool mayBeSeenBy(const Camera& camera) const { return mayShowBody(camera, mask_, joints_); }

  const std::vector<Eigen::Vector3d> joints_ = standingJoints();
  const Camera camera_ = cameraAt({0.2, -4.0, 1.0}, 300.0);
  const cv::Mat mask_ = silhouetteOf(camera_, joints_);
};

TEST_F(BodyInMask, TheRightCalibrationAndOneNearbyAgree) {
  EXPECT_TRUE(mayBeSeenBy(camera_));
  EXPECT_TRUE(mayBeSeenBy(cameraAt({0.23, -4.0, 1.0}, 305.0)));
}

TEST_F(BodyInMask, AnotherPlaceOrLensDoesNot) {
  EXPECT_FALSE(mayBeSeenBy(cameraAt({0.8, -4.0, 1.0}, 300.0))) << "beside the person";
  EXPECT_FALSE(mayBeSeenBy(cameraAt({30.0, -4.0, 1.0}, 300.0))) << "nobody in view";
  EXPECT_FALSE(mayBeSeenBy(cameraAt({0.2, -4.0, 1.0}, 150.0))) << "half as large";
  EXPECT_FALSE(mayBeSeenBy(cameraAt({0.2, -4.0, 1.0}, 600.0))) << "twice as large";
}

TEST_F(BodyInMask, APersonPartlyInViewAgrees) {
  const Camera low = cameraAt({0.2, -4.0, -0.7}, 300.0);
  EXPECT_TRUE(mayShowBody(low, silhouetteOf(low, joints_), joints_));
}

TEST_F(BodyInMask, OthersInViewDoNotMatter) {
  cv::Mat both = mask_.clone();
  cv::rectangle(both, {5, 60, 60, 150}, cv::Scalar(255), cv::FILLED);
  EXPECT_TRUE(mayShowBody(camera_, both, joints_));
}

TEST_F(BodyInMask, WhereNothingIsKnownNothingContradicts) {
  EXPECT_TRUE(mayShowBody(camera_, cv::Mat(240, 320, CV_8UC1, cv::Scalar(128)), joints_));
  const Camera elsewhere = cameraAt({30.0, -4.0, 1.0}, 300.0);
  EXPECT_TRUE(mayShowBody(elsewhere, cv::Mat(240, 320, CV_8UC1, cv::Scalar(0)), joints_));
  EXPECT_FALSE(mayShowBody(camera_, cv::Mat(240, 320, CV_8UC1, cv::Scalar(0)), joints_));
}

}  // namespace
}  // namespace markerless_mocap
