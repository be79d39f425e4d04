#include "region/things_beside.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "contour/drawn_body.h"
#include "contour/regions/placed_contour_body.h"
#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

class ThingsBesideTest : public ::testing::Test {
 protected:
  ThingsBesideTest() { masks = drawnMasks(rig, body, stride()); }

  std::vector<cv::Mat> cleaned(const ContourPose& predicted = stride()) const {
    return withoutThingsBeside(masks, has_colors, rig, placedBody(body, predicted), seconds).masks;
  }
  std::vector<bool> doubted() const {
    return withoutThingsBeside(masks, has_colors, rig, placedBody(body, stride()), seconds).doubted;
  }
  bool changesNothing(const ContourPose& predicted = stride()) const {
    const std::vector<cv::Mat> out = cleaned(predicted);
    for (size_t i = 0; i < masks.size(); ++i)
      if (out[i].data != masks[i].data) return false;
    return true;
  }
  /// A box that begins in the middle of the person and ends beside them.
  void putBox(size_t camera) {
    const cv::Rect person = cv::boundingRect(masks[camera]);
    masks[camera](cv::Rect(person.x + person.width / 2, person.br().y - 50, 90, 50)) = kPersonPixel;
  }

  CameraRig rig = drawnRig(2);
  ContourBody body{ShapeStatistics::handMade().meanShape(1.75)};
  std::vector<cv::Mat> masks;
  std::vector<bool> has_colors;
  double seconds = 1.0 / 30;  ///< of the prediction
};

class ThingsBesideWithColorsTest : public ThingsBesideTest {
 protected:
  ThingsBesideWithColorsTest() { has_colors.assign(masks.size(), true); }
  /// Also without images, but not of an old prediction.
  void expectFirstViewInDoubt() {
    const std::vector<bool> first_only{true, false};
    EXPECT_EQ(doubted(), first_only);
    has_colors.clear();
    EXPECT_TRUE(changesNothing());
    EXPECT_EQ(doubted(), first_only) << "the images should be asked for";
    seconds = 0.3;
    EXPECT_EQ(doubted(), std::vector<bool>(2, false)) << "it is the prediction that may be wrong";
  }
};

TEST_F(ThingsBesideTest, ABoxBecomesUnknownUpToThePredictedBody) {
  const cv::Mat person = masks[0].clone();
  putBox(0);
  const std::vector<cv::Mat> out = cleaned();
  EXPECT_EQ(cv::countNonZero(out[0] != masks[0]), cv::countNonZero(out[0] == kUnknownPixel));
  const cv::Mat box = (masks[0] != 0) & (person == 0);
  EXPECT_GT(cv::countNonZero(box & (out[0] == kUnknownPixel)), 0.9 * cv::countNonZero(box));
  EXPECT_GT(cv::countNonZero((person != 0) & (out[0] == kPersonPixel)),
            0.9 * cv::countNonZero(person));
  EXPECT_EQ(out[1].data, masks[1].data);
}

TEST_F(ThingsBesideTest, ABystanderBecomesBackground) {
  const cv::Mat person = masks[0].clone();
  masks[0](cv::Rect(5, 80, 30, 110)) = kPersonPixel;
  masks[0](cv::Rect(35, 100, 10, 20)) = kUnknownPixel;
  const std::vector<cv::Mat> out = cleaned();
  EXPECT_EQ(cv::norm(out[0], person, cv::NORM_INF), 0.0);
  EXPECT_EQ(masks[0].at<uchar>(100, 10), kPersonPixel) << "the masks given are not changed";
  EXPECT_EQ(out[1].data, masks[1].data);
}

TEST_F(ThingsBesideTest, ThePersonAloneStays) {
  EXPECT_TRUE(changesNothing());
}

TEST_F(ThingsBesideTest, ArmsAndAShankThatAreElsewhereStay) {
  ContourPose predicted = stride();
  predicted.rotations[SphericalJoint::kLeftShoulder] = Eigen::Matrix3d::Identity();
  predicted.rotations[SphericalJoint::kRightShoulder] = Eigen::Matrix3d::Identity();
  predicted.angles[RevoluteJoint::kLeftKnee] = -1.8;
  EXPECT_TRUE(changesNothing(predicted));
}

TEST_F(ThingsBesideTest, AWrongPredictionTakesNobodyAway) {
  ContourPose predicted = stride();
  predicted.position += Eigen::Vector3d(0.6, 0.6, 0);
  EXPECT_TRUE(changesNothing(predicted));
}

TEST_F(ThingsBesideTest, ACameraThatIsCoveredShowsNoThing) {
  cv::circle(masks[0], {160, 120}, 95, kPersonPixel, cv::FILLED);
  EXPECT_TRUE(changesNothing());
  masks[0] = kPersonPixel;
  EXPECT_TRUE(changesNothing());
}

TEST_F(ThingsBesideWithColorsTest, TheSunAtTheFeetBecomesUnknown) {
  const cv::Mat person = masks[0].clone();
  cv::Mat toes;
  cv::findNonZero(person.row(cv::boundingRect(person).br().y - 1), toes);
  const cv::Point toe(toes.at<cv::Point>(0).x, cv::boundingRect(person).br().y - 1);
  masks[0](cv::Rect(toe.x - 4, toe.y - 6, 22, 14)) = kPersonPixel;
  const std::vector<cv::Mat> out = cleaned();
  const cv::Mat only_sun = (masks[0] != 0) & (person == 0);
  EXPECT_GT(cv::countNonZero(only_sun & (out[0] == kUnknownPixel)),
            0.7 * cv::countNonZero(only_sun));
  EXPECT_GT(cv::countNonZero(person & (out[0] == kPersonPixel)), 0.9 * cv::countNonZero(person));
  EXPECT_EQ(out[1].data, masks[1].data);
  expectFirstViewInDoubt();
}

TEST_F(ThingsBesideWithColorsTest, TrousersLikeTheWallBecomeUnknown) {
  const cv::Mat person = masks[0].clone();
  const cv::Rect box = cv::boundingRect(person);
  const cv::Rect legs(box.x, box.y + box.height / 2, box.width, box.height / 3);
  masks[0](legs) = kBackgroundPixel;
  const std::vector<cv::Mat> out = cleaned();
  EXPECT_GT(cv::countNonZero(person(legs) & (out[0](legs) == kUnknownPixel)),
            0.7 * cv::countNonZero(person(legs)));
  EXPECT_EQ(out[1].data, masks[1].data);
  expectFirstViewInDoubt();
}

TEST_F(ThingsBesideWithColorsTest, WhatMostMasksLackIsNotThere) {
  for (cv::Mat& mask : masks) {
    const cv::Rect box = cv::boundingRect(mask);
    mask(cv::Rect(box.x, box.y + box.height / 2, box.width, box.height / 2)) = kBackgroundPixel;
  }
  EXPECT_TRUE(changesNothing());
}

TEST_F(ThingsBesideWithColorsTest, ThePersonAloneStays) {
  EXPECT_TRUE(changesNothing());
  EXPECT_EQ(doubted(), std::vector<bool>(2, false));
}

TEST_F(ThingsBesideWithColorsTest, AForearmThatIsElsewhereStays) {
  ContourPose predicted = stride();
  predicted.angles[RevoluteJoint::kLeftElbow] += 0.8;
  EXPECT_TRUE(changesNothing(predicted));
}

TEST_F(ThingsBesideWithColorsTest, ShanksThatAreElsewhereAreInDoubtButStayWithoutColors) {
  ContourPose predicted = stride();
  predicted.angles[RevoluteJoint::kLeftKnee] = predicted.angles[RevoluteJoint::kRightKnee] = -2.2;
  EXPECT_GT(cv::countNonZero(cleaned(predicted)[0] == kUnknownPixel), 50);
  has_colors.clear();
  EXPECT_TRUE(changesNothing(predicted));
}

TEST_F(ThingsBesideWithColorsTest, AWrongPredictionTakesNobodyAway) {
  ContourPose predicted = stride();
  predicted.position += Eigen::Vector3d(0.6, 0.6, 0);
  EXPECT_TRUE(changesNothing(predicted));
}

}  // namespace
}  // namespace markerless_mocap
