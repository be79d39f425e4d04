#include "evaluation/body_overlay.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "body/body_fixture.h"
#include "evaluation/body_silhouette.h"

namespace markerless_mocap {
namespace {

const cv::Size kSize(320, 240);
const cv::Vec3b kGrey(90, 90, 90);

class Overlay : public testing::Test {
 protected:
  static Camera camera() {
    CameraCalibration calibration;
    calibration.name = "front";
    calibration.width = kSize.width;
    calibration.height = kSize.height;
    calibration.K << 250, 0, 159.5, 0, 250, 119.5, 0, 0, 1;
    calibration.T_world_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    calibration.T_world_camera.translation() = Eigen::Vector3d(-4, 0, 1);
    return Camera(calibration);
  }
  void SetUp() override {
    Eigen::Isometry3d root = Eigen::Isometry3d::Identity();
    root.translation().z() = 1.0;
    model_.forwardKinematics(root, Eigen::VectorXd::Zero(model_.angleCount()), T_world_link_);
  }
  cv::Mat drawn(const cv::Mat& image, const cv::Mat& mask, const std::vector<OverlayPart>& parts) {
    return bodyOverlay(camera(), image, mask, model_, T_world_link_, parts, "");
  }

  const BodyModel model_ = human();
  LinkPoses T_world_link_;
  const cv::Mat image_ = cv::Mat(kSize, CV_8UC3, cv::Scalar(kGrey));
};

TEST_F(Overlay, TintsTheBodyAndLeavesTheRest) {
  const std::vector<bool> all(model_.links().size(), true);
  const cv::Mat picture = drawn(image_, {}, {{all, {0, 255, 0}}});
  const cv::Mat body = bodySilhouette(model_, T_world_link_, camera());
  cv::Mat outside, inside;
  cv::dilate(body, outside, {}, {-1, -1}, 3);
  cv::erode(body, inside, {}, {-1, -1}, 2);
  ASSERT_GT(cv::countNonZero(inside), 500);
  for (int y = 0; y < kSize.height; ++y)
    for (int x = 0; x < kSize.width; ++x) {
      const auto pixel = picture.at<cv::Vec3b>(y, x);
      if (!outside.at<uchar>(y, x)) {
        ASSERT_EQ(pixel, kGrey) << x << ", " << y;
      }
      if (inside.at<uchar>(y, x)) {
        ASSERT_NEAR(pixel[1], 0.6 * 90 + 0.4 * 255, 1);  // the image shows through
        ASSERT_NEAR(pixel[0], 0.6 * 90, 1);
      }
    }
}

TEST_F(Overlay, DrawsThePersonOfTheMaskButNotWhatIsUnknown) {
  cv::Mat mask = cv::Mat::zeros(kSize, CV_8UC1);
  mask(cv::Rect(20, 30, 40, 50)).setTo(255);
  mask(cv::Rect(200, 30, 40, 50)).setTo(128);
  const cv::Mat picture = drawn(image_, mask, {});
  EXPECT_GT(picture.at<cv::Vec3b>(50, 20)[0], 200);
  EXPECT_EQ(picture.at<cv::Vec3b>(50, 40), kGrey);
  EXPECT_EQ(picture.at<cv::Vec3b>(50, 200), kGrey);
}

TEST_F(Overlay, TakesGreyImagesAndRefusesOtherSizes) {
  const cv::Mat grey(kSize, CV_8UC1, cv::Scalar(90));
  EXPECT_EQ(cv::norm(drawn(grey, {}, {}), image_, cv::NORM_INF), 0);
  EXPECT_THROW(drawn(cv::Mat::zeros(10, 10, CV_8UC3), {}, {}), std::invalid_argument);
  EXPECT_THROW(drawn(image_, cv::Mat::zeros(10, 10, CV_8UC1), {}), std::invalid_argument);
  EXPECT_THROW(drawn(cv::Mat::zeros(kSize, CV_32FC1), {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
