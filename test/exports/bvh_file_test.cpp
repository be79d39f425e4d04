#include "error_text_of.h"
#include "exports/export_fixture.h"
#include "motion/bvh.h"
#include "motion/human_skeleton.h"
#include "motion/retarget.h"

namespace markerless_mocap {
namespace {

class BvhFile : public MovingPerson {
 protected:
  BvhMotion read(const PersonMotion& motion, const std::string& names, double units) const {
    std::istringstream text(bvhOf(motion, exportSkeleton(*body_, names), units));
    return readBvh(text, "test.bvh");
  }
  static int jointNamed(const BvhMotion& bvh, const std::string& name) {
    for (size_t j = 0; j < bvh.joints.size(); ++j)
      if (bvh.joints[j].name == name) return int(j);
    throw std::invalid_argument("no joint " + name);
  }
  /// y up, z is the world's x.
  static Eigen::Vector3d world(const Eigen::Vector3d& v) { return {v.z(), v.x(), v.y()}; }
};

TEST_F(BvhFile, JointsAreWhereTheLinksAre) {
  const PersonMotion recorded = motion(200);
  const BvhMotion bvh = read(recorded, "motionbuilder", 100.0);
  ASSERT_EQ(bvh.frames.size(), 200u);
  EXPECT_DOUBLE_EQ(bvh.frame_time, 0.04);
  const std::pair<const char*, const char*> pairs[] = {{"Hips", "body"},
                                                       {"Spine", "waist"},
                                                       {"Spine1", "torso"},
                                                       {"Neck", "r_head"},
                                                       {"Head", "head"},
                                                       {"LeftShoulder", "l_y_clavicle"},
                                                       {"LeftArm", "l_shoulder"},
                                                       {"LeftForeArm", "l_elbow"},
                                                       {"LeftHand", "l_wrist"},
                                                       {"RightArm", "r_shoulder"},
                                                       {"RightForeArm", "r_elbow"},
                                                       {"RightHand", "r_wrist"},
                                                       {"LeftUpLeg", "l_hip"},
                                                       {"LeftLeg", "l_knee"},
                                                       {"LeftFoot", "l_ankle"},
                                                       {"RightUpLeg", "r_hip"},
                                                       {"RightLeg", "r_knee"},
                                                       {"RightFoot", "r_ankle"}};
  for (size_t f = 0; f < 200; ++f) {
    const BvhPose pose = bvh.pose(f);
    for (const auto& [joint, name] : pairs) {
      const Eigen::Vector3d place = 0.01 * world(pose.positions[size_t(jointNamed(bvh, joint))]);
      EXPECT_LT((place - link(recorded.frames[f], name).translation()).norm(), 1e-5)
          << joint << " in frame " << f;
    }
  }
}

TEST_F(BvhFile, TipsFollowTheRotationOfTheLastJoint) {
  const PersonMotion recorded = motion(60);
  const BvhMotion bvh = read(recorded, "motionbuilder", 1.0);
  const int tip = jointNamed(bvh, "LeftFoot end");
  for (size_t f = 0; f < 60; ++f) {
    const Eigen::Matrix3Xd place =
        placesOf(choosePoints("package", {"l_foot_tip"}), *body_, recorded.frames[f]);
    EXPECT_LT((world(bvh.pose(f).positions[size_t(tip)]) - place.col(0)).norm(), 1e-5);
  }
}

TEST_F(BvhFile, RestIsATPoseThatFacesZ) {
  const BvhMotion bvh = read(motion(1), "motionbuilder", 100.0);
  const BvhPose rest = bvh.rest();
  const auto at = [&](const char* name) {
    return Eigen::Vector3d(rest.positions[size_t(jointNamed(bvh, name))]);
  };
  const Eigen::Vector3d left_arm = at("LeftHand") - at("LeftArm");
  EXPECT_GT(left_arm.x(), 40.0);  // to the person's left, cm
  EXPECT_NEAR(left_arm.y(), 0.0, 1e-4);
  EXPECT_LT((at("RightHand") - at("RightArm")).x(), -40.0);
  EXPECT_GT(at("Head").y(), 50.0);
  EXPECT_LT(at("LeftFoot").y(), -60.0);
  EXPECT_GT((at("LeftFoot end") - at("LeftFoot")).z(), 10.0);
}

TEST_F(BvhFile, AnglesOfFollowingFramesHaveNoTurnsBetweenThem) {
  const BvhMotion bvh = read(motion(400), "motionbuilder", 1.0);  // twice around
  for (size_t f = 1; f < bvh.frames.size(); ++f)
    for (size_t c = 3; c < bvh.frames[f].size(); ++c)
      ASSERT_LT(std::abs(bvh.frames[f][c] - bvh.frames[f - 1][c]), 120.0) << f << ' ' << c;
}

TEST_F(BvhFile, WhatIsNotSeenKeepsItsLastRotation) {
  std::vector<PersonFrame> all = frames(10);
  hideLeftArm(&all[4]);
  hideLeftArm(&all[5]);
  hideLeftArm(&all[0]);
  const BvhMotion bvh = read(personMotion(body_, all), "motionbuilder", 1.0);
  const BvhMotion whole = read(motion(10), "motionbuilder", 1.0);
  size_t column = 3;
  for (const BvhJoint& joint : bvh.joints) {
    if (joint.is_end) continue;
    if (joint.name == "LeftForeArm") break;
    column += 3;
  }
  for (const size_t c : {column, column + 1, column + 2}) {
    EXPECT_NEAR(bvh.frames[0][c], whole.frames[1][c], 1e-4);
    EXPECT_NEAR(bvh.frames[4][c], whole.frames[3][c], 1e-4);
    EXPECT_NEAR(bvh.frames[5][c], whole.frames[3][c], 1e-4);
    EXPECT_NEAR(bvh.frames[6][c], whole.frames[6][c], 1e-4);
  }
}

TEST_F(BvhFile, OtherNamesReplaceThoseThatTheyHave) {
  const BvhMotion bvh = read(motion(1), "smpl", 1.0);
  EXPECT_GE(jointNamed(bvh, "left_elbow"), 0);
  EXPECT_GE(jointNamed(bvh, "pelvis"), 0);
  EXPECT_GE(jointNamed(read(motion(1), "h36m", 1.0), "LeftShoulder"), 0);
}

TEST_F(BvhFile, OurOwnReaderPutsItOnAnotherPerson) {
  const HumanSkeleton adult = HumanSkeleton::adult(1.8, 1.0);
  const MotionClip clip = retarget(read(motion(50), "motionbuilder", 100.0), adult, "test.bvh");
  ASSERT_EQ(clip.poses.size(), 50u);
  const PersonFrame last = frameAt(49);
  const Eigen::Vector3d thigh =
      link(last, "l_knee").translation() - link(last, "l_hip").translation();
  const auto heads = jointPositions(adult, clip.poses[49]);
  const Eigen::Vector3d found = heads[size_t(Bone::kLeftShank)] - heads[size_t(Bone::kLeftThigh)];
  EXPECT_LT(std::acos(thigh.normalized().dot(found.normalized())), 0.15);
}

}  // namespace
}  // namespace markerless_mocap
