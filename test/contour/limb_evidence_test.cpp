#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "contour/drawn_body.h"
#include "contour/fit/contour_fitter.h"
#include "contour/track/pose_report.h"

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
                                      prediction, fitter.schedule(1.0 / 15));
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

TEST_F(LimbEvidenceTest, AnArmOfWhichAPartIsFarOutsideIsNotSeen) {
  const ContourObservation seen = ContourObserver(rig, options).observe(masksOf(slim));
  ContourPose bent = pose;
  bent.angles[RevoluteJoint::kLeftElbow] = 1.6;
  ContourFit fit = fitter.fit(seen, slim, bent, std::nullopt, {1, 0.03, 0.03});
  LimbEvidence& arm = fit.limbs[ContourLimb::kLeftArm];
  EXPECT_GT(arm.part_outside, 0.10) << "forearm or hand";
  EXPECT_LT(arm.outside, 0.10) << "mean with the upper arm";
  arm.deviation = 0.01;
  BodyPose reported;
  reportEvidence(fit, {1, 1, 1, 1, 1, 1}, reported);
  EXPECT_FALSE(reported.part_seen[size_t(PartLabel::kArm1)]);
  EXPECT_TRUE(reported.part_seen[size_t(PartLabel::kArm2)]);
}

// Nowhere else do arms fit that the masks lack.
TEST_F(LimbEvidenceTest, AnArmThatIsFoldedAsFarAsItGoesOrInsideTheTrunkIsNotSeen) {
  const auto fitted = [&] {
    return fitter.fit(ContourObserver(rig, options).observe(masksOf(slim)), slim, pose,
                      std::nullopt, RobustSchedule{1, 0.03, 0.03});
  };
  const auto areSeen = [](const ContourFit& fit) {
    BodyPose report;
    reportEvidence(fit, {1, 1, 1, 1, 1, 1}, report);
    return std::pair(report.part_seen[size_t(PartLabel::kArm1)],
                     report.part_seen[size_t(PartLabel::kArm2)]);
  };
  ContourFit fit = fitted();
  EXPECT_EQ(areSeen(fit), std::pair(true, true)) << "the left arm hangs";
  fit.pose.angles[RevoluteJoint::kRightElbow] = 2.5;
  EXPECT_EQ(areSeen(fit), std::pair(true, true)) << "guards the face";
  fit.pose.angles[RevoluteJoint::kRightElbow] = 2.68;
  EXPECT_EQ(areSeen(fit), std::pair(true, false)) << "at the end of the elbow's range";
  pose.rotations[SphericalJoint::kRightShoulder] = expSO3({0.2, 0, 0});  // through the trunk
  EXPECT_EQ(areSeen(fitted()), std::pair(true, false));
}

// Legs of somebody who sits still may be taken for background.
TEST_F(LimbEvidenceTest, LegsThatTheMasksLackAreFoldedIntoTheTrunkAndNotSeen) {
  const auto fitted = [&](bool with_legs) {
    ContourFrames frames;
    ContourWorldCones cones;
    slim.place(pose, frames);
    slim.place(frames, cones);
    for (int c = 0; c < kContourCones && !with_legs; ++c)
      if (limbOfCone(c) >= ContourLimb::kLeftLeg) cones[size_t(c)] = cones[0];
    std::vector<cv::Mat> masks;
    for (const Camera& camera : rig) masks.push_back(drawnMask(camera, cones));
    return fitter.fit(ContourObserver(rig, options).observe(masks), slim, pose, std::nullopt,
                      RobustSchedule{200, 0.3, 0.03});
  };
  const ContourFit whole = fitted(true), without = fitted(false);
  for (const int leg : {ContourLimb::kLeftLeg, ContourLimb::kRightLeg}) {
    EXPECT_LT(whole.limbs[size_t(leg)].inside, 0.2);
    EXPECT_GT(without.limbs[size_t(leg)].inside, 0.4);
  }
  std::array<double, ContourLimb::kCount> agreement;
  agreement.fill(1.0);
  ContourFit fit = whole;
  BodyPose report;
  reportEvidence(fit, agreement, report);
  for (const bool seen : report.part_seen) EXPECT_TRUE(seen);
  fit.limbs[ContourLimb::kLeftLeg].inside = 0.5;
  reportEvidence(fit, agreement, report);
  EXPECT_EQ(std::count(report.part_seen.begin(), report.part_seen.end(), false), 1);
  EXPECT_FALSE(report.part_seen[size_t(PartLabel::kLeg1)]);
}

}  // namespace
}  // namespace markerless_mocap
