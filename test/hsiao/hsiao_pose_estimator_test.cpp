#include "hsiao/hsiao_pose_estimator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hsiao/fit/hsiao_hierarchical_fitter.h"
#include "hsiao/model/hsiao_urdf_converter.h"
#include "hsiao/synthetic_person.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

constexpr int64_t kFrame = 33333333;  // ns

class PoseTrackerTest : public testing::Test {
 protected:
  BodyPose show(const HsiaoVector& v) { return show(curvesOf(body_model_, v), v); }
  BodyPose show(const BodyParts& parts, const HsiaoVector& v) {
    stamp_ += kFrame;
    return tracker_.update(stamp_, parts, hullOf(body_model_, shape_, v));
  }
  // Mean and largest distance of the fifteen markers, metres.
  std::pair<double, double> distance(const BodyPose& pose, const HsiaoVector& truth) const {
    HsiaoUrdfConverter conversion(body_, std::make_shared<HsiaoBodyModel>(*body_));
    Eigen::Isometry3d root;
    Eigen::VectorXd angles;
    conversion.convert(truth, root, angles);
    LinkPoses links, true_links;
    body_->forwardKinematics(pose.T_world_body, pose.angles, links);
    body_->forwardKinematics(root, angles, true_links);
    const auto markers = markerPositions(*body_, links),
               truths = markerPositions(*body_, true_links);
    double sum = 0.0, largest = 0.0;
    for (size_t i = 0; i < markers.size(); ++i) {
      const double d = (markers[i] - truths[i]).norm();
      sum += d / markers.size();
      largest = std::max(largest, d);
    }
    return {sum, largest};
  }

  std::shared_ptr<const BodyModel> body_ = testBody();
  HsiaoBodyModel body_model_{*body_};
  HsiaoBodyShape shape_{*body_, body_model_};
  HsiaoPoseEstimator tracker_{body_, HsiaoOptions{}};
  int64_t stamp_ = 0;
};

TEST_F(PoseTrackerTest, RecoversAPoseFromItsOwnCurvesAndHullWhateverItFaces) {
  for (const double yaw : {0.0, 90.0, 180.0, -120.0}) {
    tracker_.reset();
    const HsiaoVector v = stepping(body_model_, degrees(yaw));
    const BodyPose pose = show(v);
    ASSERT_EQ(pose.status, PoseStatus::kReinitialized) << pose.reason;
    const auto [mean, largest] = distance(pose, v);
    EXPECT_LT(mean, 0.02) << "yaw " << yaw;
    EXPECT_LT(largest, 0.02) << "yaw " << yaw;
    EXPECT_GT(pose.hull_explained, 0.97);
  }
}

TEST_F(PoseTrackerTest, FollowsAMovingPersonAndSaysSo) {
  HsiaoVector v = stepping(body_model_, 0.0);
  show(v);
  for (int i = 0; i < 5; ++i) {
    v[0] += 0.04;
    v[3] += 0.04;
    v[hsiaoTheta(9)] -= 0.06;
    v[hsiaoTheta(14)] -= 0.08;
    const BodyPose pose = show(v);
    EXPECT_EQ(pose.status, PoseStatus::kTracked) << pose.reason;
    EXPECT_LT(distance(pose, v).first, 0.02) << "frame " << i;
    EXPECT_TRUE(pose.reason.empty()) << pose.reason;
  }
}

TEST_F(PoseTrackerTest, KeepsLegsApartThatPassEachOther) {
  HsiaoVector v = stepping(body_model_, 0.0);
  const double stride = 0.35;
  const auto stand = [&](double share) {
    v[hsiaoTheta(13)] = stride * share;
    v[hsiaoTheta(14)] = -stride * share;
  };
  stand(1.0);
  show(v);
  for (int i = 1; i <= 10; ++i) {
    stand(1.0 - 0.2 * i);
    BodyParts parts = curvesOf(body_model_, v);
    PartCurve& one = parts.parts[size_t(PartLabel::kLeg1)];
    PartCurve& other = parts.parts[size_t(PartLabel::kLeg2)];
    if (i >= 3 && i <= 7) {  // they touch, and each is drawn where the other is
      one.whole = other.whole = false;
      for (size_t k = 0; k < one.points.size(); ++k) {
        const Vector3d between = other.points[k] - one.points[k];
        one.points[k] += 0.6 * between;
        other.points[k] -= 0.6 * between;
      }
    }
    const BodyPose pose = show(parts, v);
    ASSERT_EQ(pose.status, PoseStatus::kTracked) << i << ": " << pose.reason;
    EXPECT_LT(distance(pose, v).second, 0.1) << i;
  }
  EXPECT_LT(distance(show(v), v).second, 0.03);
}

TEST_F(PoseTrackerTest, StartsAnewWhenThePersonJumps) {
  HsiaoVector v = stepping(body_model_, 0.0);
  show(v);
  ASSERT_EQ(show(v).status, PoseStatus::kTracked);
  v = stepping(body_model_, degrees(170));
  v[1] += 0.9;
  v[4] += 0.9;
  const BodyPose pose = show(v);
  EXPECT_EQ(pose.status, PoseStatus::kReinitialized) << pose.reason;
  EXPECT_LT(distance(pose, v).first, 0.02);
}

TEST_F(PoseTrackerTest, IsLostWithTheReasonOfTheStageThatFailed) {
  const HsiaoVector v = stepping(body_model_, 0.0);
  BodyParts parts = curvesOf(body_model_, v);
  parts.status = SegmentationStatus::kInvalid;
  parts.reason = "no body is recognised";
  BodyPose pose = show(parts, v);
  EXPECT_EQ(pose.status, PoseStatus::kLost);
  EXPECT_EQ(pose.reason, "no body is recognised");
  VisualHull nobody;
  nobody.status = HullStatus::kEmptyMasks;
  nobody.reason = "all masks are empty";
  pose = tracker_.update(stamp_ += kFrame, curvesOf(body_model_, v), nobody);
  EXPECT_EQ(pose.status, PoseStatus::kLost);
  EXPECT_EQ(pose.reason, "all masks are empty");
}

TEST_F(PoseTrackerTest, ATorsoThatIsNoCurveIsNotSeen) {
  const HsiaoVector v = stepping(body_model_, 0.0);
  for (const size_t points : {0, 1}) {
    BodyParts parts = curvesOf(body_model_, v);
    parts.parts[0].points.resize(points);
    EXPECT_EQ(show(parts, v).reason, "the torso is not seen");
  }
  BodyParts parts = curvesOf(body_model_, v);
  parts.parts[0].whole = false;
  EXPECT_EQ(show(parts, v).reason, "the torso is not seen");
}

BodyParts withoutParts() {
  BodyParts parts;
  parts.reason = "no body is recognised";
  return parts;
}

TEST_F(PoseTrackerTest, HullCarriesAPoseOnForAWhileAndSaysSo) {
  HsiaoVector v = stepping(body_model_, 0.0);
  show(v);
  for (int i = 0; i < 3; ++i) {
    v[0] += 0.03;
    v[3] += 0.03;
    const BodyPose pose = show(withoutParts(), v);
    ASSERT_EQ(pose.status, PoseStatus::kTracked) << pose.reason;
    EXPECT_EQ(pose.reason, "tracked by the hull alone: no body is recognised");
    EXPECT_TRUE(std::isnan(pose.skeleton_error_m));
    EXPECT_LT(distance(pose, v).first, 0.03) << "frame " << i;
  }
  stamp_ += int64_t(HsiaoOptions().max_pose_age * 1e9);
  const BodyPose late = show(withoutParts(), v);
  EXPECT_EQ(late.status, PoseStatus::kLost);
  EXPECT_EQ(late.reason, "no body is recognised");
}

TEST_F(PoseTrackerTest, HullOfAnotherPoseCarriesNothingOn) {
  HsiaoVector v = stepping(body_model_, 0.0);
  show(v);
  v[1] += 0.9;
  v[4] += 0.9;
  EXPECT_EQ(show(withoutParts(), v).status, PoseStatus::kLost);
}

TEST_F(PoseTrackerTest, DoesNotClaimABodyBesideAThingOfItsOwnSize) {
  const HsiaoVector v = stepping(body_model_, 0.0);
  VisualHull hull = hullOf(body_model_, shape_, v);
  const size_t body = hull.voxels.size();
  for (int k = 10; k < 40; ++k)
    for (int j = 70; j < 90; ++j)
      for (int i = 45; i < 60; ++i) {
        HullVoxel voxel;
        voxel.index = hull.lattice.index(i, j, k);
        hull.voxels.push_back(voxel);
      }
  ASSERT_GT(hull.voxels.size(), body * 2);
  const BodyPose pose = tracker_.update(stamp_ += kFrame, curvesOf(body_model_, v), hull);
  EXPECT_EQ(pose.status, PoseStatus::kLost);
  EXPECT_NE(pose.reason.find("of the hull"), std::string::npos) << pose.reason;
}

TEST_F(PoseTrackerTest, ReportsAnArmThatIsNotSeen) {
  const HsiaoVector v = stepping(body_model_, 0.0);
  BodyParts parts = curvesOf(body_model_, v);
  parts.status = SegmentationStatus::kPartial;
  parts.parts[size_t(PartLabel::kArm2)] = PartCurve{};
  const BodyPose pose = show(parts, v);
  ASSERT_NE(pose.status, PoseStatus::kLost) << pose.reason;
  EXPECT_EQ(pose.part_seen, (std::array<bool, kPartCount>{true, true, true, false, true, true}));
  EXPECT_EQ(pose.reason, "right arm not seen");
}

TEST_F(PoseTrackerTest, TimeGoingBackwardsRestartsTheTrack) {
  const HsiaoVector v = stepping(body_model_, 0.0);
  show(v);
  ASSERT_EQ(show(v).status, PoseStatus::kTracked);
  stamp_ = 0;
  EXPECT_EQ(show(v).status, PoseStatus::kReinitialized);
}

TEST_F(PoseTrackerTest, GivesTheSameBytesTwice) {
  const HsiaoVector v = stepping(body_model_, 1.0);
  const BodyPose first = show(v);
  HsiaoPoseEstimator again(body_, HsiaoOptions{});
  const BodyPose second =
      again.update(kFrame, curvesOf(body_model_, v), hullOf(body_model_, shape_, v));
  EXPECT_EQ(first.angles, second.angles);
  EXPECT_EQ(first.T_world_body.matrix(), second.T_world_body.matrix());
}

TEST(HsiaoHierarchicalFitter, ObeysTheJointLimits) {
  const HsiaoBodyModel body_model(*testBody());
  HsiaoFitterSettings settings;
  settings.limits.upper[14] = settings.limits.upper[15] = 0.1;  // stiff knees
  const HsiaoVector v = stepping(body_model, 0.0);
  const HsiaoSkeletonError error(body_model, curvesOf(body_model, v), 16);
  const HsiaoHierarchicalFitter fitter(body_model, settings);
  for (const HsiaoFit& fit : fitter.fitBasic(error, standing(body_model), 1))
    for (int k = 1; k <= kHsiaoAngles; ++k) {
      EXPECT_GE(fit.v[hsiaoTheta(k)], settings.limits.lower[k - 1]) << "theta " << k;
      EXPECT_LE(fit.v[hsiaoTheta(k)], settings.limits.upper[k - 1]) << "theta " << k;
    }
}

TEST(HsiaoHierarchicalFitter, TemporalFitStaysWithinReachOfTheLastPose) {
  const HsiaoBodyModel body_model(*testBody());
  const HsiaoHierarchicalFitter fitter(body_model, HsiaoFitterSettings{});
  const HsiaoVector last = stepping(body_model, 0.0);
  HsiaoVector v = last;
  v[hsiaoTheta(15)] += 0.8;
  const HsiaoSkeletonError error(body_model, curvesOf(body_model, v), 16);
  const HsiaoVector reach = HsiaoVector::Constant(0.2);
  const HsiaoFit fit = fitter.fitTemporal(error, last, reach, {}, 1);
  // The neck is put back to its distance from the centre, so it is left out here.
  const auto moved = [&](int first, int count) {
    return (fit.v - last).segment(first, count).cwiseAbs().maxCoeff();
  };
  EXPECT_LE(moved(kHsiaoCenter, 3), 0.2 + 1e-9);
  EXPECT_LE(moved(kHsiaoSpin, 17), 0.2 + 1e-9);
  EXPECT_GT(fit.v[hsiaoTheta(15)], last[hsiaoTheta(15)] + 0.15);
}

HsiaoOptions asPublished() {
  HsiaoOptions options;
  options.search = options.part_error = "published";
  options.use_hull = false;
  options.refinement_iterations = 0;
  options.particles_per_parameter = options.iterations_per_parameter = 4.0;
  options.max_skeleton_error = 0.15;
  return options;
}

// Hsiao 2008, 3.2.1.2: the spin is found although torso and head say nothing of it.
TEST_F(PoseTrackerTest, AsPublishedFindsAPoseWhateverItFacesByCurvesAlone) {
  HsiaoPoseEstimator tracker(body_, asPublished());
  for (const double yaw : {0.0, 90.0, 180.0, -120.0}) {
    tracker.reset();
    const HsiaoVector v = stepping(body_model_, degrees(yaw));
    stamp_ += kFrame;
    const BodyPose pose =
        tracker.update(stamp_, curvesOf(body_model_, v), hullOf(body_model_, shape_, v));
    ASSERT_EQ(pose.status, PoseStatus::kReinitialized) << pose.reason;
    EXPECT_LT(distance(pose, v).first, 0.06) << "yaw " << yaw;
  }
}

// 3.2.2.5: around the last pose, and anew where that is worse by more than the threshold.
TEST_F(PoseTrackerTest, AsPublishedFollowsAndStartsAnewAfterAJump) {
  HsiaoPoseEstimator tracker(body_, asPublished());
  HsiaoVector v = stepping(body_model_, 0.0);
  const auto next = [&] {
    stamp_ += kFrame;
    return tracker.update(stamp_, curvesOf(body_model_, v), hullOf(body_model_, shape_, v));
  };
  next();
  for (int i = 0; i < 3; ++i) {
    v[0] += 0.03;
    v[3] += 0.03;
    const BodyPose pose = next();
    EXPECT_EQ(pose.status, PoseStatus::kTracked) << pose.reason;
    EXPECT_LT(distance(pose, v).first, 0.06) << "frame " << i;
  }
  v = stepping(body_model_, degrees(100));
  v[1] += 0.4;
  v[4] += 0.4;
  const BodyPose jumped = next();
  EXPECT_EQ(jumped.status, PoseStatus::kReinitialized) << jumped.reason;
  EXPECT_LT(distance(jumped, v).first, 0.06);
}

TEST(HsiaoPoseEstimator, RefusesOptionsOutOfRange) {
  HsiaoOptions options;
  options.initial_headings = 0;
  EXPECT_THROW(HsiaoPoseEstimator(testBody(), options), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
