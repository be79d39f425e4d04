#include "contour/track/expected_error.h"

#include <gtest/gtest.h>

namespace markerless_mocap {
namespace {

BodyPose poseOf(double overlap) {
  BodyPose pose;
  pose.silhouette_overlap = overlap;
  pose.part_sigma_m.fill(0.006);
  return pose;
}

TrackedBody bodyOf(bool measured) {
  TrackedBody body;
  body.shape = ShapeStatistics::handMade().meanShape(1.75);
  body.shape_estimated = measured;
  return body;
}

TEST(ExpectedError, OfAMeasuredBodyThatCoversTheMasksIsThatOfTheFit) {
  BodyPose pose = poseOf(0.91);
  widenExpectedErrors(bodyOf(true), {}, pose);
  for (const double sigma : pose.part_sigma_m) EXPECT_EQ(sigma, 0.006);
}

TEST(ExpectedError, OfLengthsThatWereNotMeasuredComesOnTop) {
  BodyPose pose = poseOf(0.95), sure = poseOf(0.95);
  widenExpectedErrors(bodyOf(false), {}, pose);
  PersonOptions person;
  person.stature_sigma = 0.001;
  widenExpectedErrors(bodyOf(false), person, sure);
  EXPECT_NEAR(pose.part_sigma_m[4], 0.03, 0.006);
  EXPECT_NEAR(pose.part_sigma_m[2], 0.02, 0.005);
  for (size_t part = 0; part < kPartCount; ++part)
    EXPECT_LT(sure.part_sigma_m[part], pose.part_sigma_m[part]) << "the stature is known";
}

TEST(ExpectedError, GrowsWhereTheBodyHardlyCoversTheMasks) {
  BodyPose pose = poseOf(0.80);
  widenExpectedErrors(bodyOf(true), {}, pose);
  for (const double sigma : pose.part_sigma_m) EXPECT_NEAR(sigma, 0.1, 0.001);
}

}  // namespace
}  // namespace markerless_mocap
