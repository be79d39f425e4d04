#include "motion/retarget.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "motion/bone_names.h"
#include "motion/rig_stance.h"
#include "motion/skeleton/two_bone_ik.h"
#include "numerics/shortest_rotation.h"

namespace markerless_mocap {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

std::vector<NamedJoint> namedJoints(const BvhMotion& motion) {
  std::vector<NamedJoint> joints;
  for (const BvhJoint& joint : motion.joints) joints.push_back({joint.name, joint.parent});
  return joints;
}

/// \param place 0: the first rotation, 1: the second, ...
Quaterniond along(const std::vector<Quaterniond>& chain, double place) {
  const size_t before = std::min(size_t(place), chain.size() - 1);
  const size_t after = std::min(before + 1, chain.size() - 1);
  return chain[before].slerp(place - double(before), chain[after]);
}

/// Most files round frame times: 0.0083333 s is 120 frames per second.
double framesPerSecond(double frame_time) {
  const double fps = 1.0 / frame_time;
  return std::abs(fps - std::round(fps)) < 0.01 ? std::round(fps) : fps;
}

class Retargeter {
 public:
  Retargeter(const BvhMotion& motion, const HumanSkeleton& skeleton, const std::string& file)
      : motion_(motion), skeleton_(skeleton) {
    const std::vector<NamedJoint> joints = namedJoints(motion);
    bones_ = mapBones(joints, file);
    reference_ = motion.rest();
    if (!measureStance(joints, bones_, reference_.positions, stance_)) {
      reference_ = motion.pose(0);
      if (!measureStance(joints, bones_, reference_.positions, stance_))
        throw std::invalid_argument(file +
                                    ": neither the rest pose nor the first frame is a person "
                                    "standing upright, so up and forward cannot be determined");
    }
    turns_ = stance_.turnsFrom(skeleton);
    scale_ = skeleton.legLength() / stance_.leg_length;
    R_world_file_ = Quaterniond(stance_.R_world_rig);
  }

  HumanPose pose(size_t frame) const {
    const BvhPose source = motion_.pose(frame);
    HumanPose pose;
    pose.hips = scale_ * 0.5 * (place(source, Bone::kLeftThigh) + place(source, Bone::kRightThigh));
    poseTrunk(source, pose);
    for (int b = int(Bone::kLeftClavicle); b < kBoneCount; ++b) poseLimb(source, Bone(b), pose);
    for (Bone thigh : {Bone::kLeftThigh, Bone::kRightThigh}) placeAnkle(source, thigh, pose);
    return pose;
  }

 private:
  Vector3d place(const BvhPose& source, Bone bone) const {
    return R_world_file_ * source.positions[size_t(bones_[bone])];
  }

  /// Rotation of the joint relative to the reference pose, in world axes.
  Quaterniond turn(const BvhPose& source, int joint) const {
    const Quaterniond turned =
        source.R_world_joint[size_t(joint)] * reference_.R_world_joint[size_t(joint)].conjugate();
    return R_world_file_ * turned * R_world_file_.conjugate();
  }

  void poseTrunk(const BvhPose& source, HumanPose& pose) const {
    std::vector<Quaterniond> spine{turn(source, bones_[Bone::kHips])};
    for (int joint : bones_.spine) spine.push_back(turn(source, joint));
    pose[Bone::kHips] = spine.front();
    pose[Bone::kSpine] = along(spine, 0.5 * double(spine.size() - 1));
    pose[Bone::kChest] = spine.back();

    std::vector<Quaterniond> neck{spine.back()};
    for (int joint : bones_.neck) neck.push_back(turn(source, joint));
    neck.push_back(bones_.has(Bone::kHead) ? turn(source, bones_[Bone::kHead]) : neck.back());
    pose[Bone::kNeck] = along(neck, 0.5 * double(neck.size() - 1));
    pose[Bone::kHead] = neck.back();
  }

  void poseLimb(const BvhPose& source, Bone bone, HumanPose& pose) const {
    if (!bones_.has(bone)) {
      pose[bone] = pose[parentOf(bone)];
      return;
    }
    pose[bone] = turn(source, bones_[bone]) * turns_[size_t(bone)];
    // Joints between this bone and the next (twist links) may bend as well: the bone follows the
    // line between both.
    const Bone next = Bone(std::min(int(bone) + 1, kBoneCount - 1));
    const bool carries_next = parentOf(next) == bone && bones_.has(next);
    if (!carries_next || stance_.direction[size_t(bone)].isZero()) return;
    const Vector3d now = pose[bone] * (skeleton_.tailOf(bone) - skeleton_.headOf(bone));
    pose[bone] = shortestRotation(now, place(source, next) - place(source, bone)) * pose[bone];
  }

  /// The ankle keeps its scaled position relative to the hip joint, and the knee its direction.
  /// Copied angles would make standing feet slide if thigh and shank have other proportions.
  void placeAnkle(const BvhPose& source, Bone thigh, HumanPose& pose) const {
    constexpr double kForwardIfStraight =
        0.005;  // fraction of the thigh: straight knees bend to the front
    const Bone shank = Bone(int(thigh) + 1), foot = Bone(int(thigh) + 2);
    const Vector3d upper = pose[thigh] * (skeleton_.tailOf(thigh) - skeleton_.headOf(thigh));
    const Vector3d lower = pose[shank] * (skeleton_.tailOf(shank) - skeleton_.headOf(shank));
    const Vector3d ankle = scale_ * (place(source, foot) - place(source, thigh));
    const Vector3d pole =
        upper + kForwardIfStraight * upper.norm() * (pose[thigh] * Vector3d::UnitX());
    const TwoBoneIkResult leg =
        solveTwoBoneIk(Vector3d::Zero(), ankle, upper.norm(), lower.norm(), pole, M_PI);
    pose[thigh] = shortestRotation(upper, leg.middle) * pose[thigh];
    pose[shank] = shortestRotation(lower, leg.end - leg.middle) * pose[shank];
  }

  const BvhMotion& motion_;
  const HumanSkeleton& skeleton_;
  BoneMap bones_;
  BvhPose reference_;
  RigStance stance_;
  PerBone<Quaterniond> turns_;
  Quaterniond R_world_file_;
  double scale_ = 1.0;
};

/// Mean angle between the bones of two poses, radians.
double difference(const HumanPose& a, const HumanPose& b) {
  double sum = 0.0;
  for (size_t i = 0; i < size_t(kBoneCount); ++i)
    sum += a.R_world_bone[i].angularDistance(b.R_world_bone[i]);
  return sum / kBoneCount;
}

/// Whether both arms are straight out to the sides.
bool isTPose(const HumanPose& pose) {
  constexpr double kOut = 0.85;  // cosine
  for (Bone bone :
       {Bone::kLeftUpperArm, Bone::kLeftForearm, Bone::kRightUpperArm, Bone::kRightForearm})
    if ((pose[Bone::kChest].conjugate() * pose[bone] * Vector3d::UnitY()).y() < kOut) return false;
  return true;
}

void dropLeadingTPose(MotionClip& clip) {
  // The T-pose ends with a jump: the mean angle of all bones, radians, and its ratio to that of the
  // next frames.
  constexpr double kJump = 0.12, kMinJumpRatio = 4.0;
  std::vector<HumanPose>& poses = clip.poses;
  if (poses.size() < 3 || !isTPose(poses[0])) return;
  const double jump = difference(poses[0], poses[1]);
  if (jump > kJump && jump > kMinJumpRatio * difference(poses[1], poses[2]))
    poses.erase(poses.begin());
}

}  // namespace

MotionClip retarget(const BvhMotion& motion, const HumanSkeleton& skeleton,
                    const std::string& file) {
  const Retargeter retargeter(motion, skeleton, file);
  MotionClip clip;
  clip.fps = framesPerSecond(motion.frame_time);
  for (size_t f = 0; f < motion.frames.size(); ++f) clip.poses.push_back(retargeter.pose(f));
  dropLeadingTPose(clip);
  levelFeet(clip, skeleton);
  return clip;
}

}  // namespace markerless_mocap
