#include "region/region_segmenter.h"

#include <gtest/gtest.h>

#include <numeric>

#include "region/region_scene.h"

namespace markerless_mocap {
namespace {

const cv::Mat kNothingKnown;

TEST(RegionSegmenter, FindsAFigureNearTheProjectedBody) {
  const RegionScene scene;
  const RegionSegmenter segmenter(RegionScene::kParts);
  const ProjectedBody shifted = RegionScene::bodyAt({4, -3}, 0.08f);
  const RegionMask found = segmenter.segment(scene.image, shifted, kNothingKnown);
  EXPECT_GT(scene.overlapWith(found.mask), 0.95);
  EXPECT_TRUE(found.known.empty());
}

TEST(RegionSegmenter, LearnedColoursHoldWhereTheImageAloneMisleads) {
  RegionSegmenter segmenter(RegionScene::kParts);
  segmenter.learn(RegionScene().image, RegionScene::bodyAt({0, 0}, 0));
  // So far off that a part's core is on the wall.
  const RegionScene scene;
  const ProjectedBody off = RegionScene::bodyAt({0, 9}, 0, 6);
  const double learned = scene.overlapWith(segmenter.segment(scene.image, off, kNothingKnown).mask);
  EXPECT_GT(learned, 0.93);
  segmenter.reset();
  EXPECT_LT(scene.overlapWith(segmenter.segment(scene.image, off, kNothingKnown).mask), learned);
}

TEST(RegionSegmenter, AWallOfTheSameColourNeedsTheKnownBackground) {
  const RegionScene scene(0, {40, 40, 190}, 4);  // the trunk's colour
  const RegionSegmenter segmenter(RegionScene::kParts);
  const ProjectedBody shifted = RegionScene::bodyAt({5, 0}, 0, 3);
  const double blind =
      scene.overlapWith(segmenter.segment(scene.image, shifted, kNothingKnown).mask);
  const double seeing =
      scene.overlapWith(segmenter.segment(scene.image, shifted, scene.person).mask);
  EXPECT_GT(seeing, blind + 0.03);
  EXPECT_GT(seeing, 0.86);
}

TEST(RegionSegmenter, CountsWhereSilhouettesAgreeByPart) {
  const RegionScene scene;
  cv::Mat known = scene.person.clone();
  known.colRange(100, known.cols).setTo(0);          // the hand is missing in the silhouette
  known.rowRange(0, 60).colRange(0, 75).setTo(128);  // the trunk's top is unknown
  const RegionSegmenter segmenter(RegionScene::kParts);
  const RegionMask found = segmenter.segment(scene.image, RegionScene::bodyAt({1, 1}, 0), known);
  ASSERT_EQ(found.known.size(), size_t(RegionScene::kParts));
  const auto agreement = [&](size_t part) {
    return double(found.agreeing[part]) / found.known[part];
  };
  EXPECT_GT(agreement(RegionScene::kTrunk), 0.97);
  EXPECT_LT(found.known[RegionScene::kTrunk], 0.9 * found.colored[RegionScene::kTrunk]);
  EXPECT_EQ(found.known[RegionScene::kArm], found.colored[RegionScene::kArm]);
  EXPECT_LT(agreement(RegionScene::kArm), 0.75);
  EXPECT_GT(agreement(RegionScene::kArm), 0.2);
  EXPECT_EQ(found.silhouette, cv::countNonZero(known == 255));
}

TEST(RegionSegmenter, ProposesAnArmThatIsElsewhereByItsColour) {
  const RegionScene scene(-1.2f);  // the arm is raised
  RegionSegmenter segmenter(RegionScene::kParts);
  segmenter.learn(RegionScene().image, RegionScene::bodyAt({0, 0}, 0));
  const ProjectedBody expected = RegionScene::bodyAt({0, 0}, 0);  // as it was
  const cv::Mat nothing(scene.person.size(), CV_8UC1, cv::Scalar(128));
  const cv::Rect hand(87, 12, 10, 12);
  ASSERT_GT(cv::countNonZero(scene.person(hand)), 60);
  const cv::Mat near = segmenter.segment(scene.image, expected, nothing).mask;
  EXPECT_EQ(cv::countNonZero(near(hand)), 0) << "beyond the expected error";
  const cv::Mat candidates = segmenter.candidates(scene.image, expected, nothing, 60);
  EXPECT_GT(cv::countNonZero(candidates(hand)), 0.8 * cv::countNonZero(scene.person(hand)));
  EXPECT_LT(cv::countNonZero(candidates & ~scene.person), 0.05 * cv::countNonZero(scene.person));
}

TEST(RegionSegmenter, AnArmThatTheSilhouetteKnowsIsKeptWhereverTheBodyHasIt) {
  const RegionScene scene(-1.2f);  // the arm is raised
  const RegionSegmenter segmenter(RegionScene::kParts);
  const ProjectedBody expected = RegionScene::bodyAt({0, 0}, 0);
  const cv::Rect elbow(79, 28, 10, 10);
  ASSERT_GT(cv::countNonZero(scene.person(elbow)), 60);
  cv::Mat known(scene.person.size(), CV_8UC1, cv::Scalar(128));
  const cv::Mat without = segmenter.segment(scene.image, expected, known).mask;
  EXPECT_LT(cv::countNonZero(without(elbow)), 0.5 * cv::countNonZero(scene.person(elbow)));
  known = scene.person.clone();
  known.colRange(0, 65).setTo(128);
  known(cv::Rect(100, 90, 12, 12)).setTo(255);  // something beside the person
  const RegionMask found = segmenter.segment(scene.image, expected, known);
  EXPECT_EQ(cv::countNonZero(found.mask(elbow)), cv::countNonZero(scene.person(elbow)));
  EXPECT_EQ(cv::countNonZero(found.mask(cv::Rect(100, 90, 12, 12))), 0);
  EXPECT_LT(std::accumulate(found.agreeing.begin(), found.agreeing.end(), 0),
            0.95 * found.silhouette)
      << "what colours around the body do not explain";
}

TEST(RegionSegmenter, ABodyOutsideTheImageGivesAnEmptyMask) {
  const RegionScene scene;
  const RegionSegmenter segmenter(RegionScene::kParts);
  const RegionMask found =
      segmenter.segment(scene.image, RegionScene::bodyAt({500, 0}, 0), kNothingKnown);
  EXPECT_EQ(found.mask.size(), scene.image.size());
  EXPECT_EQ(cv::countNonZero(found.mask), 0);
}

}  // namespace
}  // namespace markerless_mocap
