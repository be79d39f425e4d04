#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "contour/drawn_body.h"
#include "contour/fit/contour_fitter.h"

namespace markerless_mocap {
namespace {

using Deviations = std::array<double, ContourLimb::kCount>;

/// A body so stout that an arm which hangs lies within its trunk.
ContourBody stout() {
  ShapeParameters shape = ShapeStatistics::handMade().meanShape(1.75);
  for (const int kind : {BodyCone::kPelvis, BodyCone::kChest, BodyCone::kThigh})
    for (const int end : {0, 1}) shape[radiusIndex(kind, end)] *= 2.2;
  return ContourBody(shape);
}

/// Four cameras see a person whose right arm points to the side, while the left one hangs.
class LimbEvidenceTest : public ::testing::Test {
 protected:
  LimbEvidenceTest()
      : rig(drawnRig(4)), slim(ShapeStatistics::handMade().meanShape(1.75)), fitter(rig, options) {
    pose.position.z() = 0.92;
    pose.rotations[SphericalJoint::kRightShoulder] = expSO3({-1.3, 0, 0});
    pose.angles[RevoluteJoint::kLeftElbow] = pose.angles[RevoluteJoint::kRightElbow] = 0.2;
  }
  std::vector<cv::Mat> masksOf(const ContourBody& body) const {
    return drawnMasks(rig, body, pose);
  }
  /// Expected errors of the limbs' ends, metres.
  Deviations expected(const ContourBody& body, const std::vector<cv::Mat>& masks,
                      const std::optional<ContourPrediction>& prediction = std::nullopt) const {
    const ContourFit fit = fitter.fit(ContourObserver(rig, options).observe(masks), body, pose,
                                      prediction, fitter.schedule());
    EXPECT_EQ(fit.status, ContourFitStatus::kFitted);
    Deviations deviations;
    for (size_t i = 0; i < deviations.size(); ++i) deviations[i] = fit.limbs[i].deviation;
    return deviations;
  }

  ContourOptions options;
  CameraRig rig;
  ContourBody slim;
  ContourFitter fitter;
  ContourPose pose;
};

TEST_F(LimbEvidenceTest, AnArmWithinTheTrunkIsExpectedAnywhereNear) {
  const Deviations apart = expected(slim, masksOf(slim));
  const Deviations within = expected(stout(), masksOf(stout()));
  EXPECT_LT(apart[ContourLimb::kLeftArm], 0.02);
  EXPECT_GT(within[ContourLimb::kLeftArm], 0.08);
  EXPECT_LT(within[ContourLimb::kRightArm], 0.02);
  EXPECT_LT(within[ContourLimb::kLeftLeg], 0.02);
}

TEST_F(LimbEvidenceTest, WhatIsPredictedIsNoEvidence) {
  const std::vector<cv::Mat> masks = masksOf(stout());
  const Deviations alone = expected(stout(), masks);
  const Deviations predicted = expected(stout(), masks, ContourPrediction{pose, 1e-3});
  EXPECT_GT(predicted[ContourLimb::kLeftArm], alone[ContourLimb::kLeftArm] - 0.005);
}

TEST_F(LimbEvidenceTest, MasksThatDisagreeWithALimbTellLessOfIt) {
  std::vector<cv::Mat> bitten = masksOf(slim);
  const Eigen::Vector3d forearm = slim.points(pose).middleCols<2>(7).rowwise().mean();
  for (size_t v = 0; v < rig.size(); ++v) {
    const Eigen::Vector2d pixel = *rig[v].project(forearm);
    cv::circle(bitten[v], {int(pixel.x()), int(pixel.y())}, 3, 0, cv::FILLED);
  }
  const Deviations clean = expected(slim, masksOf(slim)), damaged = expected(slim, bitten);
  EXPECT_GT(damaged[ContourLimb::kRightArm], 2.0 * clean[ContourLimb::kRightArm]);
  for (const int leg : {ContourLimb::kLeftLeg, ContourLimb::kRightLeg})
    EXPECT_LT(damaged[size_t(leg)], 1.2 * clean[size_t(leg)]);
}

}  // namespace
}  // namespace markerless_mocap
