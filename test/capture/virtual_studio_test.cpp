#include "markerless_mocap/capture/virtual_studio.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "capture/sensor_noise.h"
#include "capture/studio_fixture.h"

namespace markerless_mocap {
namespace {

VirtualStudio studio(const StudioOptions& options) {
  return VirtualStudio(humanTemplate(), "person1", options);
}

double difference(const std::vector<cv::Mat>& a, const std::vector<cv::Mat>& b) {
  double most = 0;
  for (size_t i = 0; i < a.size(); ++i) most = std::max(most, cv::norm(a[i], b[i], cv::NORM_INF));
  return most;
}

TEST(VirtualStudioTest, sameOptionsGiveTheSameBytes) {
  const VirtualStudio one = studio(smallStudio()), two = studio(smallStudio());
  two.render(40);  // the order of asking does not matter
  const StudioInstant a = one.render(20), b = two.render(20);
  EXPECT_EQ(difference(a.images, b.images), 0.0);
  EXPECT_EQ(difference(a.masks, b.masks), 0.0);
  EXPECT_EQ(a.body.angles, b.body.angles);
}

TEST(VirtualStudioTest, seedChangesTheNoiseAndNothingElse) {
  StudioOptions other = smallStudio();
  other.seed = 2;
  const StudioInstant a = studio(smallStudio()).render(20), b = studio(other).render(20);
  EXPECT_GT(difference(a.images, b.images), 0.0);
  EXPECT_EQ(difference(a.masks, b.masks), 0.0);
  EXPECT_EQ(a.markers, b.markers);
}

TEST(VirtualStudioTest, firstInstantsShowTheEmptyRoom) {
  StudioOptions options = smallStudio();
  options.noise_levels = 0.0;
  const VirtualStudio room = studio(options);
  EXPECT_EQ(room.instantCount(), 3 + 60);
  const StudioInstant first = room.render(0), last = room.render(2), action = room.render(3);
  for (const cv::Mat& mask : last.masks) EXPECT_EQ(cv::countNonZero(mask), 0);
  EXPECT_FALSE(last.person);
  EXPECT_TRUE(last.markers.empty());
  EXPECT_EQ(difference(first.images, last.images), 0.0);
  EXPECT_TRUE(action.person);
  for (const cv::Mat& mask : action.masks) EXPECT_GT(cv::countNonZero(mask), 300);
}

TEST(VirtualStudioTest, instantsAreEvenlySpacedInTime) {
  const VirtualStudio room = studio(smallStudio());
  EXPECT_EQ(room.render(0).time_ns, 0);
  EXPECT_EQ(room.render(10).time_ns, 333333333);
  EXPECT_EQ(sentenceOf([&] { room.render(-1); }),
            "the index of a studio instant is -1, allowed is 0 and above");
}

TEST(VirtualStudioTest, markersLieInEveryMask) {
  const VirtualStudio room = studio(smallStudio());
  for (const int index : {5, 30, 55}) {
    const StudioInstant instant = room.render(index);
    ASSERT_EQ(instant.markers.size(), markerNames().size());
    for (size_t c = 0; c < room.rig().size(); ++c)
      for (const Eigen::Vector3d& marker : instant.markers) {
        const auto pixel = room.rig()[c].projectInside(marker);
        ASSERT_TRUE(pixel);
        EXPECT_EQ(instant.masks[c].at<uint8_t>(int(std::lround(pixel->y())),
                                               int(std::lround(pixel->x()))),
                  255);
      }
  }
}

TEST(VirtualStudioTest, ringSeesTheWholePersonAllTheTime) {
  StudioOptions options = smallStudio();
  options.overhead = false;
  options.duration = 16.0;
  const VirtualStudio room = studio(options);
  for (int index = 3; index < room.instantCount(); index += 12)
    for (const cv::Mat& mask : room.render(index).masks) {
      cv::Mat border = mask.clone();
      border(cv::Rect(1, 1, mask.cols - 2, mask.rows - 2)) = 0;
      EXPECT_EQ(cv::countNonZero(border), 0) << index;
    }
}

TEST(VirtualStudioTest, personStandsOutFromTheRoom) {
  StudioOptions options = smallStudio();
  options.noise_levels = 0.0;
  const VirtualStudio room = studio(options);
  const StudioInstant empty = room.render(0), action = room.render(20);
  int same = 0, all = 0;
  for (size_t c = 0; c < action.masks.size(); ++c)
    for (int i = 0; i < int(action.masks[c].total()); ++i) {
      if (!action.masks[c].data[i]) continue;
      ++all;
      const cv::Vec3b a = action.images[c].at<cv::Vec3b>(i / 160, i % 160);
      const cv::Vec3b b = empty.images[c].at<cv::Vec3b>(i / 160, i % 160);
      same += cv::norm(a, b, cv::NORM_INF) < 20.0;
    }
  EXPECT_LT(same, 0.02 * all);
}

TEST(VirtualStudioTest, badBodyIdIsRefused) {
  EXPECT_EQ(sentenceOf([] { VirtualStudio(humanTemplate(), "1", smallStudio()); }),
            "body id is \"1\", allowed are letters and digits, a letter first");
}

TEST(SensorNoiseTest, hasTheAskedDeviationAndDiffersByStream) {
  cv::Mat a(120, 160, CV_8UC3, cv::Scalar::all(128)), b = a.clone();
  addSensorNoise(5.0, 1, a);
  addSensorNoise(5.0, 2, b);
  cv::Scalar mean, deviation;
  cv::meanStdDev(a.reshape(1), mean, deviation);
  EXPECT_NEAR(mean[0], 128.0, 0.2);
  EXPECT_NEAR(deviation[0], 5.0, 0.2);
  cv::Mat product;
  cv::multiply(a.reshape(1), b.reshape(1), product, 1.0, CV_64F);
  const double covariance = cv::mean(product)[0] - mean[0] * cv::mean(b.reshape(1))[0];
  EXPECT_LT(std::abs(covariance), 0.5);
}

}  // namespace
}  // namespace markerless_mocap
