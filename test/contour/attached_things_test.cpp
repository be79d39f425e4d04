#include "contour/track/attached_things.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "contour/drawn_body.h"
#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

class AttachedThingsTest : public ::testing::Test {
 protected:
  AttachedThingsTest() { masks = drawnMasks(rig, body, stride()); }

  std::vector<cv::Mat> cleaned(const ContourPose& predicted = stride()) const {
    return withoutAttachedThings(masks, rig, body, predicted);
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
};

TEST_F(AttachedThingsTest, ABoxBecomesUnknownButForWhatIsNearTheBody) {
  const cv::Mat person = masks[0].clone();
  putBox(0);
  const std::vector<cv::Mat> out = cleaned();
  EXPECT_EQ(cv::countNonZero(out[0] != masks[0]), cv::countNonZero(out[0] == kUnknownPixel));
  EXPECT_EQ(cv::countNonZero((out[0] != kPersonPixel) & (person != 0)), 0);
  const int box = cv::countNonZero(masks[0]) - cv::countNonZero(person);
  EXPECT_GT(cv::countNonZero(out[0] == kUnknownPixel), box / 2);
  EXPECT_EQ(out[1].data, masks[1].data);
}

TEST_F(AttachedThingsTest, ThePersonAloneStays) {
  EXPECT_TRUE(changesNothing());
}

TEST_F(AttachedThingsTest, ArmsAndAShankThatAreElsewhereStay) {
  ContourPose predicted = stride();
  predicted.rotations[SphericalJoint::kLeftShoulder] = Eigen::Matrix3d::Identity();
  predicted.rotations[SphericalJoint::kRightShoulder] = Eigen::Matrix3d::Identity();
  predicted.angles[RevoluteJoint::kLeftKnee] = -1.8;
  EXPECT_TRUE(changesNothing(predicted));
}

TEST_F(AttachedThingsTest, WhatABodyBesideThePersonIsToldOfStays) {
  ContourPose predicted = stride();
  predicted.position += Eigen::Vector3d(0.6, 0.6, 0);
  EXPECT_TRUE(changesNothing(predicted)) << "it would keep itself where it is";
}

TEST_F(AttachedThingsTest, ACameraThatIsCoveredShowsNoThing) {
  cv::circle(masks[0], {160, 120}, 95, kPersonPixel, cv::FILLED);
  EXPECT_TRUE(changesNothing());
  masks[0] = kPersonPixel;
  EXPECT_TRUE(changesNothing());
}

}  // namespace
}  // namespace markerless_mocap
