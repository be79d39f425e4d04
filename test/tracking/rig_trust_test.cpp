#include "tracking/rig_trust.h"

#include <gtest/gtest.h>

#include "tracking/standing_person.h"

namespace markerless_mocap {
namespace {

using RigPointer = RigTrust::RigPointer;

/// Three cameras that see somebody.
class TrustInRigs : public ::testing::Test {
 protected:
  TrustInRigs() {
    for (const Camera& camera : *right_) masks_.push_back(silhouetteOf(camera, joints_));
    EXPECT_EQ(used(right_), right_);
  }
  RigPointer used(const RigPointer& told) {
    return trust_.rigFor(told, {[this](size_t i) { return masks_[i]; }, joints_});
  }
  static RigPointer rig(double second_x, double third_x = 0.5) {
    return std::make_shared<const CameraRig>(CameraRig{cameraAt({-0.5, -4.0, 1.0}, 300.0),
                                                       cameraAt({second_x, -4.0, 1.0}, 300.0),
                                                       cameraAt({third_x, -4.0, 1.0}, 300.0)});
  }
  RigPointer repeated(const RigPointer& told, int times) {
    RigPointer last;
    for (int i = 0; i < times; ++i) last = used(told);
    return last;
  }

  std::vector<Eigen::Vector3d> joints_ = standingJoints();
  const RigPointer right_ = rig(0.0);
  std::vector<cv::Mat> masks_;
  RigTrust trust_;
};

TEST_F(TrustInRigs, ACalibrationThatContradictsTheImagesCostsItsCamera) {
  const RigPointer wrong = rig(0.8);
  EXPECT_EQ(repeated(wrong, 20), right_);
  EXPECT_TRUE(trust_.isRefused(1));
  EXPECT_FALSE(trust_.isRefused(0) || trust_.isRefused(2));
  // Set right again: nothing has to be made anew.
  EXPECT_EQ(used(rig(0.0)), right_);
  EXPECT_FALSE(trust_.isRefused(1));
}

TEST_F(TrustInRigs, ACameraThatHasMovedIsUsedAtItsNewPlace) {
  const RigPointer moved = rig(0.8);
  masks_[1] = silhouetteOf((*moved)[1], joints_);
  EXPECT_EQ(used(moved), moved);
  EXPECT_FALSE(trust_.isRefused(1));
}

TEST_F(TrustInRigs, SmallChangesAreTakenOver) {
  const RigPointer other = rig(0.002);
  EXPECT_EQ(used(other), other);
}

TEST_F(TrustInRigs, ACameraIsTakenBackWhenItsImagesAgree) {
  const RigPointer moved = rig(0.8);
  EXPECT_EQ(repeated(moved, 3), right_);
  masks_[1] = silhouetteOf((*moved)[1], joints_);
  EXPECT_EQ(used(moved), right_) << "once may be chance";
  EXPECT_EQ(repeated(moved, 10), moved);
  EXPECT_FALSE(trust_.isRefused(1));
}

TEST_F(TrustInRigs, OthersAreTakenOverMeanwhile) {
  const RigPointer moved = rig(0.8, 1.5);
  masks_[2] = silhouetteOf((*moved)[2], joints_);
  const RigPointer found = used(moved);
  EXPECT_TRUE(trust_.isRefused(1));
  EXPECT_FALSE(trust_.isRefused(2));
  EXPECT_EQ((*found)[1].position(), (*right_)[1].position());
  EXPECT_EQ((*found)[2].position(), (*moved)[2].position());
  EXPECT_EQ(used(moved), found) << "it is made once";
}

TEST_F(TrustInRigs, ARefusedCameraStaysOutWhileNobodyIsFollowed) {
  const RigPointer wrong = rig(0.8);
  used(wrong);
  joints_.clear();
  EXPECT_EQ(repeated(wrong, 20), right_);
  EXPECT_TRUE(trust_.isRefused(1));
}

TEST_F(TrustInRigs, WithoutAPersonEveryCalibrationIsBelieved) {
  joints_.clear();
  const RigPointer other = rig(0.8);
  EXPECT_EQ(used(other), other);
}

TEST_F(TrustInRigs, WithoutAMaskACameraWaits) {
  const cv::Mat seen = masks_[1];
  masks_[1] = cv::Mat();
  const RigPointer other = rig(0.05);
  EXPECT_EQ(repeated(other, 20), right_);
  masks_[1] = seen;
  EXPECT_EQ(used(other), other);
}

}  // namespace
}  // namespace markerless_mocap
