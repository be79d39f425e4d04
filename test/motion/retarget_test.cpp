#include "motion/retarget.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "bvh_rig.h"
#include "error_text_of.h"

namespace markerless_mocap {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

HumanPose standing(const HumanSkeleton& skeleton) {
  HumanPose pose;
  pose.hips = skeleton.headOf(Bone::kHips);
  return pose;
}

Quaterniond turnAbout(const Vector3d& axis, double degrees) {
  return Quaterniond(AngleAxisd(degrees * M_PI / 180.0, axis));
}

/// A person going ahead, swinging arms and legs, turning the trunk; the feet stay level.
std::vector<HumanPose> walking(const HumanSkeleton& skeleton, int frames) {
  std::vector<HumanPose> poses;
  for (int f = 0; f < frames; ++f) {
    const double swing = 30.0 * std::sin(0.15 * f);
    HumanPose pose = standing(skeleton);
    pose.hips += Vector3d(0.02 * f, 0.01 * std::sin(0.3 * f), 0.005 * std::cos(0.3 * f));
    const Vector3d y = Vector3d::UnitY(), x = Vector3d::UnitX(), z = Vector3d::UnitZ();
    pose[Bone::kHips] = turnAbout(z, 0.3 * swing);
    pose[Bone::kSpine] = pose[Bone::kHips] * turnAbout(y, 5);
    pose[Bone::kChest] = pose[Bone::kSpine] * turnAbout(y, 5);
    pose[Bone::kNeck] = pose[Bone::kHead] = pose[Bone::kChest] * turnAbout(x, 10);
    for (const double side : {1.0, -1.0}) {
      const bool left = side > 0.0;
      const auto bone = [&](Bone of) -> Quaterniond& { return pose[left ? of : mirrorOf(of)]; };
      bone(Bone::kLeftClavicle) = pose[Bone::kChest];
      bone(Bone::kLeftUpperArm) =
          pose[Bone::kChest] * turnAbout(y, side * swing) * turnAbout(x, -side * 70);
      bone(Bone::kLeftForearm) = bone(Bone::kLeftUpperArm) * turnAbout(z, -side * 40);
      bone(Bone::kLeftHand) = bone(Bone::kLeftForearm) * turnAbout(x, side * 10);
      bone(Bone::kLeftThigh) = pose[Bone::kHips] * turnAbout(y, -side * swing);
      bone(Bone::kLeftShank) = bone(Bone::kLeftThigh) * turnAbout(y, 20);
    }
    poses.push_back(pose);
  }
  return poses;
}

void expectSame(const MotionClip& clip, const std::vector<HumanPose>& wanted, double tolerance) {
  ASSERT_EQ(clip.poses.size(), wanted.size());
  for (size_t f = 0; f < wanted.size(); ++f) {
    EXPECT_NEAR((clip.poses[f].hips - wanted[f].hips).norm(), 0.0, tolerance) << f;
    for (int b = 0; b < kBoneCount; ++b)
      EXPECT_NEAR(clip.poses[f][Bone(b)].angularDistance(wanted[f][Bone(b)]), 0.0, tolerance)
          << boneName(Bone(b)) << " in frame " << f;
  }
}

Vector3d along(const HumanSkeleton& skeleton, const HumanPose& pose, Bone bone) {
  return pose[bone] * (skeleton.tailOf(bone) - skeleton.headOf(bone)).normalized();
}

TEST(Retarget, aTPoseIsTheRest) {
  const BvhRig rig;
  const std::vector<HumanPose> poses{standing(rig.skeleton)};
  expectSame(retarget(rig.motion(poses), rig.skeleton, "t.bvh"), poses, 1e-7);
}

TEST(Retarget, armsThatHangAtRestAndAreRaisedAreTheRest) {
  for (const double degrees : {20.0, 45.0, 85.0}) {
    BvhRig rig;
    rig.arms_down = degrees * M_PI / 180.0;
    const std::vector<HumanPose> poses{standing(rig.skeleton)};
    expectSame(retarget(rig.motion(poses), rig.skeleton, "a.bvh"), poses, 1e-7);
  }
}

TEST(Retarget, thePersonOfTheFileComesBack) {
  for (const double arms_down : {0.0, 0.8}) {
    BvhRig rig;
    rig.arms_down = arms_down;
    const std::vector<HumanPose> poses = walking(rig.skeleton, 40);
    expectSame(retarget(rig.motion(poses), rig.skeleton, "walk.bvh"), poses, 1e-6);
  }
}

TEST(Retarget, theFilesAxesAndUnitDoNotMatter) {
  BvhRig rig;
  const std::vector<HumanPose> poses = walking(rig.skeleton, 20);
  for (const Eigen::Matrix3d& axes : {BvhRig::yUp(), BvhRig::zUp()})
    for (const double turn : {0.0, 90.0, 180.0})
      for (const double unit : {1.0, 39.37, 100.0}) {
        rig.R_file_world = axes * turnAbout(Vector3d::UnitZ(), turn).toRotationMatrix();
        rig.units_per_metre = unit;
        expectSame(retarget(rig.motion(poses), rig.skeleton, "walk.bvh"), poses, 1e-6);
      }
}

TEST(Retarget, anotherPersonsLimbsPointAsInTheFile) {
  BvhRig rig;
  rig.skeleton = HumanSkeleton::adult(1.95, 0.5);
  const HumanSkeleton small = HumanSkeleton::adult(1.5, 0.5);
  const std::vector<HumanPose> poses = walking(rig.skeleton, 40);
  const MotionClip clip = retarget(rig.motion(poses), small, "walk.bvh");
  ASSERT_EQ(clip.poses.size(), poses.size());
  for (size_t f = 0; f < poses.size(); ++f) {
    for (Bone left : {Bone::kLeftUpperArm, Bone::kLeftForearm, Bone::kLeftHand, Bone::kLeftThigh,
                      Bone::kLeftShank})
      for (Bone bone : {left, mirrorOf(left)})
        EXPECT_NEAR(
            (along(small, clip.poses[f], bone) - along(rig.skeleton, poses[f], bone)).norm(), 0.0,
            1e-6)
            << boneName(bone) << " in frame " << f;
    for (Bone bone : {Bone::kHips, Bone::kSpine, Bone::kChest, Bone::kHead})
      EXPECT_NEAR(clip.poses[f][bone].angularDistance(poses[f][bone]), 0.0, 1e-6);
  }
}

/// Knees higher, the hip joints and ankles where they were.
HumanSkeleton withShortThighs() {
  HumanSkeleton skeleton = HumanSkeleton::adult(1.75, 0.5);
  for (Bone thigh : {Bone::kLeftThigh, Bone::kRightThigh}) {
    const Bone shank = Bone(int(thigh) + 1);
    skeleton.tail[size_t(thigh)].z() += 0.08;
    skeleton.head[size_t(shank)].z() += 0.08;
  }
  return skeleton;
}

TEST(Retarget, anklesKeepTheirPlacesWhereverTheKneesAre) {
  BvhRig rig;
  rig.skeleton = withShortThighs();
  const HumanSkeleton other = HumanSkeleton::adult(1.75, 0.5);
  const double ratio = other.legLength() / rig.skeleton.legLength();
  const std::vector<HumanPose> poses = walking(rig.skeleton, 40);
  const MotionClip clip = retarget(rig.motion(poses), other, "walk.bvh");
  for (size_t f = 0; f < poses.size(); ++f) {
    const PerBone<Vector3d> was = jointPositions(rig.skeleton, poses[f]),
                            is = jointPositions(other, clip.poses[f]);
    for (const auto& [hip, foot] : {std::make_pair(Bone::kLeftThigh, Bone::kLeftFoot),
                                    std::make_pair(Bone::kRightThigh, Bone::kRightFoot)})
      EXPECT_NEAR(
          (is[size_t(foot)] - is[size_t(hip)] - ratio * (was[size_t(foot)] - was[size_t(hip)]))
              .norm(),
          0.0, 1e-6);
    // The knees bend to the front.
    const Vector3d bend =
        clip.poses[f][Bone::kLeftThigh].conjugate() * along(other, clip.poses[f], Bone::kLeftShank);
    EXPECT_LT(bend.x(), 0.0);
  }
}

TEST(Retarget, thePathIsScaledByTheLegs) {
  BvhRig rig;
  rig.skeleton = HumanSkeleton::adult(1.95, 1.0);
  const HumanSkeleton small = HumanSkeleton::adult(1.5, 0.0);
  const std::vector<HumanPose> poses = walking(rig.skeleton, 40);
  const MotionClip clip = retarget(rig.motion(poses), small, "walk.bvh");
  const double ratio = small.legLength() / rig.skeleton.legLength();
  for (size_t f = 0; f < poses.size(); ++f)
    EXPECT_NEAR((clip.poses[f].hips - ratio * poses[f].hips).norm(), 0.0, 1e-9);
  EXPECT_NEAR(clip.duration(), 39.0 / 60.0, 1e-12);
}

TEST(Retarget, roundedFrameTimesAreWholeRates) {
  const BvhRig rig;
  BvhMotion motion = rig.motion({standing(rig.skeleton)});
  for (const auto& [frame_time, fps] : {std::make_pair(0.0083333, 120.0), {0.033333, 30.0}}) {
    motion.frame_time = frame_time;
    EXPECT_DOUBLE_EQ(retarget(motion, rig.skeleton, "walk.bvh").fps, fps);
  }
  motion.frame_time = 1.0 / 29.97;
  EXPECT_NEAR(retarget(motion, rig.skeleton, "walk.bvh").fps, 29.97, 1e-9);
}

TEST(Retarget, aTPoseInFrontIsLeftOut) {
  const BvhRig rig;
  std::vector<HumanPose> poses = walking(rig.skeleton, 10);
  poses.insert(poses.begin(), standing(rig.skeleton));
  EXPECT_EQ(retarget(rig.motion(poses), rig.skeleton, "walk.bvh").poses.size(), 10u);
  std::vector<HumanPose> slowly;
  for (int f = 0; f <= 30; ++f)
    slowly.push_back(interpolate(standing(rig.skeleton), poses[1], f / 30.0));
  EXPECT_EQ(retarget(rig.motion(slowly), rig.skeleton, "walk.bvh").poses.size(), 31u);
}

TEST(Retarget, missingBonesGoWithTheirCarriers) {
  BvhRig rig;
  rig.has = [](Bone bone) {
    for (Bone none : {Bone::kNeck, Bone::kHead, Bone::kLeftHand, Bone::kLeftToes})
      if (bone == none || bone == mirrorOf(none)) return false;
    return true;
  };
  std::vector<HumanPose> poses = walking(rig.skeleton, 20);
  for (HumanPose& pose : poses) {
    pose[Bone::kNeck] = pose[Bone::kHead] = pose[Bone::kChest];
    pose[Bone::kLeftHand] = pose[Bone::kLeftForearm];
    pose[Bone::kRightHand] = pose[Bone::kRightForearm];
  }
  expectSame(retarget(rig.motion(poses), rig.skeleton, "walk.bvh"), poses, 1e-6);
}

TEST(Retarget, oneSpineJointIsSharedBySpineAndChest) {
  BvhRig rig;
  rig.has = [](Bone bone) { return bone != Bone::kSpine; };
  HumanPose bow = standing(rig.skeleton);
  for (Bone bone : {Bone::kChest, Bone::kNeck, Bone::kHead, Bone::kLeftClavicle,
                    Bone::kLeftUpperArm, Bone::kLeftForearm, Bone::kLeftHand})
    bow[bone] = bow[mirrorOf(bone)] = turnAbout(Vector3d::UnitY(), 40);
  const HumanPose pose = retarget(rig.motion({bow}), rig.skeleton, "bow.bvh").poses[0];
  EXPECT_NEAR(pose[Bone::kHips].angularDistance(Quaterniond::Identity()), 0.0, 1e-7);
  EXPECT_NEAR(pose[Bone::kSpine].angularDistance(turnAbout(Vector3d::UnitY(), 20)), 0.0, 1e-7);
  EXPECT_NEAR(pose[Bone::kChest].angularDistance(turnAbout(Vector3d::UnitY(), 40)), 0.0, 1e-7);
}

// A rest with one leg straight up, the first frame stands.
TEST(Retarget, theFirstFrameStandsInForARestThatDoesNot) {
  const BvhRig rig;
  const std::vector<HumanPose> poses(3, standing(rig.skeleton));
  BvhMotion motion = rig.motion(poses);
  size_t column = 3;
  for (BvhJoint& joint : motion.joints) {
    if (joint.name == "LeftShin" || joint.name == "RightShin") {
      // The thigh's frame gets half a turn about the file's x axis, which the rest has not.
      joint.offset = turnAbout(Vector3d::UnitX(), 180) * joint.offset;
      for (std::vector<double>& frame : motion.frames) {
        frame[column - 3 + 1] += 180.0;
        frame[column + 1] -= 180.0;
      }
    }
    if (!joint.is_end) column += 3;
  }
  expectSame(retarget(motion, rig.skeleton, "folded.bvh"), poses, 1e-6);
}

TEST(Retarget, nobodyUprightIsRefused) {
  BvhRig rig;
  BvhMotion motion = rig.motion({standing(rig.skeleton)});
  for (BvhJoint& joint : motion.joints)
    if (joint.name == "LeftThigh" || joint.name == "RightThigh") joint.offset.y() += 200.0;
  EXPECT_EQ(errorTextOf([&] { retarget(motion, rig.skeleton, "upside.bvh"); }),
            "upside.bvh: neither the rest pose nor the first frame is a person standing upright, "
            "so up and forward cannot be determined");
}

TEST(Retarget, missingBonesAreNamed) {
  BvhRig rig;
  rig.has = [](Bone bone) { return bone < Bone::kLeftShank || bone > Bone::kLeftToes; };
  const std::string sentence = errorTextOf(
      [&] { retarget(rig.motion({standing(rig.skeleton)}), rig.skeleton, "half.bvh"); });
  EXPECT_EQ(sentence.find("half.bvh: no joint is named like l_shank, l_foot;"), 0u) << sentence;
}

TEST(LevelFeet, standingFeetComeFlat) {
  const HumanSkeleton skeleton = HumanSkeleton::adult(1.75, 0.5);
  MotionClip clip;
  clip.fps = 60.0;
  clip.poses.assign(30, standing(skeleton));
  for (HumanPose& pose : clip.poses) {
    pose[Bone::kLeftFoot] = turnAbout(Vector3d::UnitY(), 15);
    pose[Bone::kRightToes] = turnAbout(Vector3d::UnitX(), -10);
  }
  levelFeet(clip, skeleton);
  for (Bone bone : {Bone::kLeftFoot, Bone::kLeftToes, Bone::kRightFoot, Bone::kRightToes})
    EXPECT_NEAR(clip.poses[7][bone].angularDistance(Quaterniond::Identity()), 0.0, 1e-9);
}

}  // namespace
}  // namespace markerless_mocap
