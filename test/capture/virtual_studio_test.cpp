#include "capture/virtual_studio.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "capture/ground_truth.h"
#include "capture/studio_fixture.h"

namespace markerless_mocap {
namespace {

VirtualStudio studio(const StudioOptions& options) {
  return VirtualStudio(options, packageFiles(), "person1");
}

/// Without noise and flicker.
StudioOptions calmStudio() {
  StudioOptions options = smallStudio();
  options.degradations.noise_stddev = 0.0;
  options.degradations.flicker = 0.0;
  return options;
}

double difference(const std::vector<cv::Mat>& a, const std::vector<cv::Mat>& b) {
  double most = 0;
  for (size_t i = 0; i < a.size(); ++i) most = std::max(most, cv::norm(a[i], b[i], cv::NORM_INF));
  return most;
}

TEST(VirtualStudioTest, sameOptionsGiveTheSameBytes) {
  StudioOptions options = smallStudio();
  options.rig = "random8";
  options.degradations = {3.0, 0.02, 0.4, 0.3, 0.4, 2.0, 30.0, 0.2, 12.0, 1.0, 1.0};
  DegradationOptions& troubles = options.degradations;
  troubles.bystander_distance = troubles.screen_width = troubles.window_width = 1.8;
  troubles.door_angle = 70.0;
  troubles.sun_patches = troubles.light_switch = troubles.floor_reflection = 0.3;
  troubles.auto_exposure = troubles.auto_white_balance = 0.8;
  const VirtualStudio one = studio(options), two = studio(options);
  two.render(40);  // the order of asking does not matter
  const StudioFrameSet a = one.render(20), b = two.render(20);
  ASSERT_EQ(a.images.size(), 8u);
  for (size_t i = 0; i < 8; ++i) {
    ASSERT_EQ(a.images[i].empty(), b.images[i].empty());
    if (a.images[i].empty()) continue;
    EXPECT_EQ(cv::norm(a.images[i], b.images[i], cv::NORM_INF), 0.0);
    EXPECT_EQ(cv::norm(a.silhouettes[i], b.silhouettes[i], cv::NORM_INF), 0.0);
  }
  EXPECT_EQ(difference(a.masks, b.masks), 0.0);
  EXPECT_EQ(a.body.angles, b.body.angles);
  EXPECT_EQ(a.points, b.points);
}

TEST(VirtualStudioTest, firstInstantsShowTheEmptyRoom) {
  const VirtualStudio room = studio(calmStudio());
  EXPECT_EQ(room.frameSetCount(), 3 + 60);
  const StudioFrameSet first = room.render(0), last = room.render(2), action = room.render(3);
  for (const cv::Mat& mask : last.masks) EXPECT_EQ(cv::countNonZero(mask), 0);
  EXPECT_FALSE(last.person);
  EXPECT_TRUE(last.points.empty());
  EXPECT_EQ(difference(first.images, last.images), 0.0);
  EXPECT_TRUE(action.person);
  for (const cv::Mat& mask : action.masks) EXPECT_GT(cv::countNonZero(mask), 300);
}

TEST(VirtualStudioTest, instantsAreEvenlySpacedInTime) {
  const VirtualStudio room = studio(smallStudio());
  EXPECT_EQ(room.render(0).time_ns, 0);
  EXPECT_EQ(room.render(10).time_ns, 333333333);
  EXPECT_EQ(errorTextOf([&] { room.render(-1); }),
            "the index of a frame set is -1, allowed is 0 and above");
}

TEST(VirtualStudioTest, jointsLieInTheMasks) {
  const VirtualStudio room = studio(smallStudio());
  int inside = 0, all = 0;
  for (const int index : {5, 30, 55}) {
    const StudioFrameSet frame_set = room.render(index);
    ASSERT_EQ(frame_set.points.size(), groundTruthNames().size());
    for (size_t c = 0; c < room.rig().size(); ++c)
      for (size_t i = 0; i < markerNames().size(); ++i) {
        const auto pixel = room.trueRig()[c].projectInside(frame_set.points[i]);
        ASSERT_TRUE(pixel);
        inside += frame_set.masks[c].at<uint8_t>(int(std::lround(pixel->y())),
                                                 int(std::lround(pixel->x()))) == 255;
        ++all;
      }
  }
  EXPECT_GE(inside, 0.98 * all);
}

TEST(VirtualStudioTest, drivenBodyIsWhereThePersonIs) {
  const VirtualStudio room = studio(smallStudio());
  const StudioFrameSet frame_set = room.render(30);
  LinkPoses poses;
  room.body().forwardKinematics(frame_set.body.T_world_body, frame_set.body.angles, poses);
  const auto markers = markerPositions(room.body(), poses);
  double sum = 0.0;
  for (size_t i = 0; i < markers.size(); ++i) sum += (markers[i] - frame_set.points[i]).norm();
  EXPECT_LT(sum / double(markers.size()), 0.025);
  EXPECT_NE(room.urdf().find("body_person1"), std::string::npos);
}

TEST(VirtualStudioTest, theMotionGoesOnWithoutAJump) {
  StudioOptions options = smallStudio();
  options.motion = "wave";
  options.rig = "ring4";
  options.fps = 10.0;
  options.duration = 0.0;
  options.background_frames = 0;
  const VirtualStudio room = studio(options);
  StudioFrameSet last = room.render(room.frameSetCount() - 2);
  for (int i = room.frameSetCount() - 1; i < room.frameSetCount() + 15; ++i) {
    const StudioFrameSet next = room.render(i);
    for (size_t k = 0; k < next.points.size(); ++k)
      EXPECT_LT((next.points[k] - last.points[k]).norm(), 0.35) << i << groundTruthNames()[k];
    last = next;
  }
}

TEST(VirtualStudioTest, personStandsOutFromTheRoom) {
  const VirtualStudio room = studio(calmStudio());
  const StudioFrameSet empty = room.render(0), action = room.render(20);
  for (size_t i = 0; i < action.images.size(); ++i) {
    cv::Mat apart;
    cv::absdiff(action.images[i], empty.images[i], apart);
    EXPECT_GT(cv::mean(apart, action.masks[i])[1], 15.0);
    EXPECT_LT(cv::mean(apart, ~action.masks[i])[1], 6.0);  // shadows
  }
}

TEST(VirtualStudioTest, badOptionsAreNamed) {
  StudioOptions options = smallStudio();
  options.motion = "fly";
  EXPECT_EQ(
      errorTextOf([&] { studio(options); }).rfind("there is no motion \"fly\", allowed are ", 0),
      0u);
  options = smallStudio();
  options.volume_half_width = 0.5;
  options.motion = "walk";
  const std::string sentence = errorTextOf([&] { studio(options); });
  EXPECT_EQ(sentence.rfind("motion walk: the motion reaches ", 0), 0u) << sentence;
  options = smallStudio();
  options.rig = "ring5";
  EXPECT_EQ(errorTextOf([&] { studio(options); }).rfind("the rig is \"ring5\", allowed are ", 0),
            0u);
  options = smallStudio();
  options.degradations.drop_rate = 1.5;
  EXPECT_EQ(errorTextOf([&] { studio(options); }),
            "virtual_studio/drop_rate is 1.5, allowed is 0 to 0.9");
}

}  // namespace
}  // namespace markerless_mocap
