/// Somebody who stood still while the background was learned, and then moves.
#include <gtest/gtest.h>

#include "silhouette/scene.h"

namespace markerless_mocap {
namespace {

const cv::Size kRoom(320, 240);
const cv::Rect kStood(60, 90, 30, 110);

class StoodStill : public testing::TestWithParam<int> {
 protected:
  SilhouetteResult update(const cv::Rect& person) {
    ++images_;
    return extractor_.update(withNoise(withPerson(scene_, person), 100 + images_));
  }

  cv::Mat scene_ = makeScene(GetParam(), kRoom);
  SilhouetteExtractor extractor_ = learned(withPerson(scene_, kStood));
  int images_ = 0;
};
INSTANTIATE_TEST_SUITE_P(GreyAndColor, StoodStill, testing::Values(1, 3));

TEST_P(StoodStill, IsSeenAloneSoonAfterLeavingThePlace) {
  EXPECT_EQ(cv::countNonZero(update(kStood).mask), 0);
  cv::Rect person = kStood;
  double uncovered = 0;
  for (int i = 0; i < 30; ++i) {
    person.x += 3;
    uncovered += update(person).uncovered_fraction;
  }
  EXPECT_NEAR(uncovered, double(kStood.area()) / double(kRoom.area()), 0.01);
  person.x += 3;
  EXPECT_GT(iou(update(person).mask, exactMask(person, kRoom)), 0.95);
  EXPECT_GT(iou(update(kStood).mask, exactMask(kStood, kRoom)), 0.95) << "back again";
}

/// Whoever comes into an empty room and stands still is no ghost, on any pattern of the background.
TEST_P(StoodStill, WhoComesIntoAnEmptyRoomStays) {
  cv::Mat shelf(kRoom.height / 12, kRoom.width / 8, scene_.type());
  cv::RNG random(3);
  random.fill(shelf, cv::RNG::UNIFORM, 0, 255);
  cv::resize(shelf, scene_, kRoom, 0, 0, cv::INTER_NEAREST);
  cv::GaussianBlur(scene_, scene_, {3, 3}, 0);
  for (int place = 0; place < 8; ++place) {
    extractor_ = learned(scene_);
    const cv::Rect person(40 + 29 * place, 70, 30, 110);
    const int before = cv::countNonZero(update(person).mask);
    for (int i = 0; i < 30; ++i) {
      const SilhouetteResult result = update(person);
      EXPECT_EQ(result.uncovered_fraction, 0) << place;
      EXPECT_GT(cv::countNonZero(result.mask), 0.95 * before) << place;
    }
  }
}

}  // namespace
}  // namespace markerless_mocap
