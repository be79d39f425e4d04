/// Backgrounds of recordings in which somebody stays on the spot, and most of them never moves.
#include <gtest/gtest.h>

#include "markerless_mocap/products/silhouette_mask.h"
#include "markerless_mocap/silhouette/recording_learner.h"
#include "silhouette/scene.h"

namespace markerless_mocap {
namespace {

constexpr int kFrames = 120;
const cv::Rect kBody(70, 28, 14, 74);     // head, trunk and legs
const cv::Rect kPicture(120, 60, 16, 8);  // on the wall, apart from the person

cv::Rect arm(int frame) {
  const int up = std::abs(frame % 20 - 10);
  return {84, 26 + 2 * up, 14, 6};
}

cv::Mat wall() {
  cv::Mat scene = makeScene(3);
  scene(kPicture).setTo(cv::Scalar(20, 90, 20));
  return scene;
}

cv::Mat waver(int frame) {
  return withNoise(withPerson(withPerson(wall(), kBody), arm(frame)), frame);
}

RecordingLearner watched(cv::Mat (*image)(int)) {
  RecordingLearner learner({}, kFrames);
  for (int i = 0; i < kFrames; ++i) learner.add(image(i));
  return learner;
}

cv::Mat maskOf(const SharedBackground& background, const cv::Mat& image) {
  SilhouetteExtractor extractor{SilhouetteOptions()};
  extractor.useBackground(background);
  return extractor.update(image).mask;
}

TEST(StayingPerson, LegsOfWhoWavesAreUnknownAndTheRoomIsKnown) {
  const cv::Mat mask = maskOf(watched(waver).learn(), waver(3));
  EXPECT_GT(cv::countNonZero(mask(kBody)), 0.95 * kBody.area());
  cv::Mat room = mask.clone();
  room(cv::Rect(kBody.x - 2, kBody.y - 2, kBody.width + 18, kBody.height + 4)).setTo(0);
  EXPECT_LT(cv::countNonZero(room), 20);
}

TEST(StayingPerson, WhoHardlyMovesIsNoEmptyRoom) {
  const auto fidgeter = [](int frame) {
    const cv::Rect hand(84, 60 + frame / 3 % 2, 3, 6);
    return withNoise(withPerson(withPerson(wall(), kBody), hand), frame);
  };
  EXPECT_TRUE(watched(fidgeter).isOccupiedAtFirst());
}

}  // namespace
}  // namespace markerless_mocap
