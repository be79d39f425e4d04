#include "fleischmann/fleischmann_body_model.h"

#include <gtest/gtest.h>

#include <random>

#include "appearance_scene.h"

namespace markerless_mocap {
namespace {

constexpr double kTight = 1e-9;

TEST(FleischmannBodyModel, zeroIsTheModelsZeroPose) {
  const FleischmannBodyModel body_model(sampleBody());
  FleischmannFrames frames;
  body_model.frames(FleischmannVector::Zero().eval().data(), frames);
  LinkPoses links;
  sampleBody().forwardKinematics(Eigen::Isometry3d::Identity(),
                                 Eigen::VectorXd::Zero(sampleBody().angleCount()), links);
  for (int s = 0; s < kFleischmannSegments; ++s) {
    const Eigen::Isometry3d& link = links[size_t(body_model.link(FleischmannSegment(s)))];
    EXPECT_LT((frames.p[s] - link.translation()).norm(), kTight) << s;
    EXPECT_TRUE(frames.R[s].isIdentity(kTight)) << s;
  }
}

TEST(FleischmannBodyModel, takesAnyPoseOfTheModel) {
  const FleischmannBodyModel body_model(sampleBody());
  const BodyModel& model = sampleBody();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int trial = 0; trial < 50; ++trial) {
    Eigen::VectorXd angles(model.angleCount());
    for (const BodyJoint& joint : model.joints())
      if (joint.angle_index >= 0)
        angles[joint.angle_index] = joint.lower + share(random) * (joint.upper - joint.lower);
    Eigen::Isometry3d root(
        Eigen::AngleAxisd(6.0 * share(random), Eigen::Vector3d(0.3, 0.2, 1).normalized()));
    root.translation() << 1, 2, 0.9;
    LinkPoses links;
    model.forwardKinematics(root, angles, links);
    FleischmannFrames frames;
    body_model.frames(body_model.parametersOf(links, FleischmannVector::Zero()).data(), frames);
    for (int s = 0; s < kFleischmannSegments; ++s) {
      const Eigen::Isometry3d& link = links[size_t(body_model.link(FleischmannSegment(s)))];
      EXPECT_LT((frames.p[s] - link.translation()).norm(), kTight) << s;
      EXPECT_LT((frames.R[s] - link.linear()).norm(), kTight) << s;
    }
    const std::vector<Eigen::Vector3d> markers = body_model.markers(frames);
    const std::vector<Eigen::Vector3d> expected = markerPositions(model, links);
    ASSERT_EQ(markers.size(), expected.size());
    for (size_t m = 0; m < markers.size(); ++m)
      EXPECT_LT((markers[m] - expected[m]).norm(), kTight) << markerNames()[m];
  }
}

TEST(FleischmannBodyModel, findsTheParametersNearestToTheLast) {
  const FleischmannBodyModel body_model(sampleBody());
  FleischmannVector v = stride();
  v[kPelvisOrientation + 2] += 4.0 * M_PI;  // twice round
  FleischmannFrames frames;
  body_model.frames(v.data(), frames);
  LinkPoses links(sampleBody().links().size());
  for (int s = 0; s < kFleischmannSegments; ++s) {
    Eigen::Isometry3d& link = links[size_t(body_model.link(FleischmannSegment(s)))];
    link.linear() = frames.R[s];
    link.translation() = frames.p[s];
  }
  EXPECT_LT((body_model.parametersOf(links, v) - v).norm(), kTight);
}

// An arm forward by a quarter turn about y comes to lie along x; both sides mirror.
TEST(FleischmannBodyModel, signsMeanTheSameOnBothSides) {
  const FleischmannBodyModel body_model(sampleBody());
  FleischmannFrames frames;
  for (const int shoulder : {kLeftShoulder, kRightShoulder}) {
    FleischmannVector v = FleischmannVector::Zero();
    v[shoulder + 1] = M_PI / 2;
    body_model.frames(v.data(), frames);
    const int side = shoulder == kLeftShoulder ? 0 : 1;
    const Eigen::Vector3d forward = frames.p[kLeftLowerArm + side] - frames.p[kLeftUpperArm + side];
    EXPECT_GT(forward.normalized().x(), 0.999);
    v = FleischmannVector::Zero();
    v[shoulder] = M_PI / 2;
    body_model.frames(v.data(), frames);
    const Eigen::Vector3d outward = frames.p[kLeftLowerArm + side] - frames.p[kLeftUpperArm + side];
    EXPECT_GT(outward.normalized().y() * (side == 0 ? 1 : -1), 0.999);
  }
  FleischmannVector v = FleischmannVector::Zero();
  v[kLeftKnee] = v[kRightKnee] = 1.0;
  v[kSpine] = 0.5;
  body_model.frames(v.data(), frames);
  const auto markers = body_model.markers(frames);
  EXPECT_LT(markers[11].x(), -0.1);  // ankles go back
  EXPECT_LT(markers[14].x(), -0.1);
  EXPECT_GT(markers[2].x(), 0.1);  // the head goes forward
}

TEST(FleischmannBodyModel, limitsHoldTheZeroPoseAndAStride) {
  for (const FleischmannLimits& limits :
       {FleischmannLimits::walking(), FleischmannLimits::full()}) {
    const FleischmannVector zero = FleischmannVector::Zero(), v = stride();
    EXPECT_TRUE((limits.lower.array() <= zero.array()).all());
    EXPECT_TRUE((limits.upper.array() >= zero.array()).all());
    EXPECT_TRUE((limits.lower.array() <= v.array()).all());
    EXPECT_TRUE((limits.upper.array() >= v.array()).all());
    EXPECT_EQ(limits.upper[kPelvisPosition], HUGE_VAL);
    EXPECT_LT(limits.upper[kHeadTwist], HUGE_VAL);
  }
}

TEST(FleischmannBodyModel, walkingIsWithinWhatAdultsCanDo) {
  const FleischmannLimits walking = FleischmannLimits::walking(), full = FleischmannLimits::full();
  EXPECT_TRUE((full.lower.array() <= walking.lower.array()).all());
  EXPECT_TRUE((full.upper.array() >= walking.upper.array()).all());
  EXPECT_LT(full.lower[kRightHip], walking.lower[kRightHip]);
}

}  // namespace
}  // namespace markerless_mocap
