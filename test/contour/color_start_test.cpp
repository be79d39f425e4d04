#include <gtest/gtest.h>

#include "contour/contour_tracker.h"
#include "contour/counted_proposals.h"
#include "contour/unknown_room.h"
#include "markerless_mocap/tracking/tracked_body.h"

namespace markerless_mocap {
namespace {

class ColorStartTest : public testing::Test, protected UnknownRoom {
 protected:
  ColorStartTest() {
    resources.known_shape = body.shape();
    for (const size_t known : {0, 1, 2}) masks[known] = person[known];
  }

  ContourTracker tracker() {
    return {rig, resources, PersonOptions(), ContourOptions(),
            [this](std::shared_ptr<const BodyModel> model) {
              return std::make_unique<CountedProposals>(model, pose, &proposals);
            }};
  }

  /// The pose after so many frames at 30 Hz, in which the colours flicker like those of clothes.
  BodyPose poseAfter(int frames, ContourTracker& tracker) {
    BodyPose found;
    ReadyProducts products({hull, {}, {}});
    for (int64_t frame = 0; frame < frames; ++frame) {
      std::vector<cv::Mat> now;
      for (const cv::Mat& image : images) now.push_back(image + cv::Scalar::all(frame % 2 * 15));
      found =
          tracker.update({1 + frame * 33333333, masks, now, products, [this] { return behind; }});
    }
    return found;
  }

  /// Largest distance of an ankle from its place, metres.
  double ankleError(const BodyPose& found, const ContourTracker& tracker) const {
    const ContourUrdfConverter converter(tracker.body()->model);
    const Eigen::Matrix3Xd off =
        body.points(converter.poseOf(found.T_world_body, found.angles)) - body.points(pose);
    return std::max(off.col(11).norm(), off.col(14).norm());  // ankles of contourPointNames()
  }

  PersonResources resources = PersonResources::standard();
  int proposals = 0;
  bool behind = false;
};

TEST_F(ColorStartTest, AGoodStartIsConfirmedTwiceAndStays) {
  ContourTracker right = tracker();
  const BodyPose found = poseAfter(90, right);
  EXPECT_EQ(found.status, PoseStatus::kTracked) << found.reason;
  EXPECT_EQ(proposals, 1 + 2);
  EXPECT_LT(ankleError(found, right), 0.08);
}

// A slow computer is always behind.
TEST_F(ColorStartTest, AGoodStartIsConfirmedAlsoWhileNewerFrameSetsWait) {
  behind = true;
  ContourTracker right = tracker();
  EXPECT_EQ(poseAfter(60, right).status, PoseStatus::kTracked);
  EXPECT_EQ(proposals, 1 + 2);
}

// Colours would follow the body on; as soon as the background of a view is known they are
// contradicted, unless silhouettes of other views show the body.
TEST_F(ColorStartTest, APoseThatSilhouettesContradictIsNotReported) {
  ContourTracker right = tracker();
  ASSERT_EQ(poseAfter(45, right).status, PoseStatus::kTracked);
  for (const size_t other : {0, 1, 2}) masks[other] = cv::Mat(masks[3].size(), CV_8UC1, 128);
  cv::Mat& unknown = masks[3];
  const cv::Rect all = cv::boundingRect(person[3]);
  unknown.setTo(255, person[3]);
  unknown.rowRange(0, all.y + all.height * 2 / 5).setTo(0);
  ReadyProducts products({hull, {}, {}});
  const BodyPose found = right.update({1 + 45 * 33333333LL, masks, images, products});
  EXPECT_EQ(found.status, PoseStatus::kLost);
  EXPECT_EQ(found.reason, "colours show a person where the silhouettes show background");
}

TEST_F(ColorStartTest, WithAKnownBackgroundAGoodStartIsNotChecked) {
  masks = person;
  ContourTracker right = tracker();
  EXPECT_EQ(poseAfter(30, right).status, PoseStatus::kTracked);
  EXPECT_EQ(proposals, 1);
}

}  // namespace
}  // namespace markerless_mocap
