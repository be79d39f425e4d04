#pragma once

#include <cmath>
#include <functional>
#include <string>

#include "motion/bvh.h"
#include "motion/human_skeleton.h"

namespace markerless_mocap {

/// A BVH motion of a person that is known exactly: HumanSkeleton and HumanPose written in a file's
/// axes and unit, at rest with the arms hanging by an angle below the T-pose.
struct BvhRig {
  HumanSkeleton skeleton = HumanSkeleton::adult(1.75, 0.5);
  /// From the world (x forward, y left, z up) to the file's axes; here y up, z forward.
  Eigen::Matrix3d R_file_world = yUp();
  double units_per_metre = 100.0;
  double arms_down = 0.0;  ///< radians
  double fps = 60.0;
  std::function<bool(Bone)> has = [](Bone) { return true; };

  static Eigen::Matrix3d yUp() {
    Eigen::Matrix3d R;
    R << 0, 1, 0, 0, 0, 1, 1, 0, 0;
    return R;
  }
  /// As Blender's figures stand: facing -y.
  static Eigen::Matrix3d zUp() {
    Eigen::Matrix3d R;
    R << 0, 1, 0, -1, 0, 0, 0, 0, 1;
    return R;
  }

  BvhMotion motion(const std::vector<HumanPose>& poses) const {
    BvhMotion motion;
    motion.frame_time = 1.0 / fps;
    std::vector<int> joint_of(size_t(kBoneCount), -1);
    for (int b = 0; b < kBoneCount; ++b)
      if (has(Bone(b))) addBone(motion, Bone(b), joint_of);
    for (const HumanPose& pose : poses) motion.frames.push_back(frame(pose));
    return motion;
  }

 private:
  static const char* nameOf(Bone bone) {
    static const char* const kNames[] = {
        "Hips",         "Spine",       "Chest",         "Neck",         "Head",      "LeftCollar",
        "LeftUpperArm", "LeftForeArm", "LeftHand",      "LeftThigh",    "LeftShin",  "LeftFoot",
        "LeftToe",      "RightCollar", "RightUpperArm", "RightForeArm", "RightHand", "RightThigh",
        "RightShin",    "RightFoot",   "RightToe"};
    return kNames[size_t(bone)];
  }

  /// Turns a bone of the T-pose into the rig's rest, world axes.
  Eigen::Quaterniond restTurn(Bone bone) const {
    const bool left = bone >= Bone::kLeftUpperArm && bone <= Bone::kLeftHand;
    const bool right = bone >= Bone::kRightUpperArm && bone <= Bone::kRightHand;
    const double angle = left ? -arms_down : right ? arms_down : 0.0;
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()));
  }

  Bone carrierOf(Bone bone) const {
    Bone carrier = parentOf(bone);
    while (!has(carrier)) carrier = parentOf(carrier);
    return carrier;
  }

  Eigen::Vector3d toFile(const Eigen::Vector3d& world) const {
    return units_per_metre * (R_file_world * world);
  }

  HumanPose restPose() const {
    HumanPose rest;
    for (int b = 0; b < kBoneCount; ++b) rest[Bone(b)] = restTurn(Bone(b));
    return rest;
  }

  void addBone(BvhMotion& motion, Bone bone, std::vector<int>& joint_of) const {
    const HumanPose rest = restPose();
    const PerBone<Eigen::Vector3d> heads = jointPositions(skeleton, rest);
    BvhJoint joint;
    joint.name = nameOf(bone);
    if (bone == Bone::kHips) {
      for (int axis : {0, 1, 2}) joint.channels.push_back({axis, false});
    } else {
      joint.parent = joint_of[size_t(carrierOf(bone))];
      joint.offset = toFile(heads[size_t(bone)] - heads[size_t(carrierOf(bone))]);
    }
    for (int axis : {2, 0, 1}) joint.channels.push_back({axis, true});
    joint_of[size_t(bone)] = int(motion.joints.size());
    motion.joints.push_back(joint);
    if (endsChain(bone)) {
      BvhJoint end;
      end.name = joint.name + " end";
      end.parent = joint_of[size_t(bone)];
      end.is_end = true;
      end.offset = toFile(boneEnd(skeleton, rest, heads, bone) - heads[size_t(bone)]);
      motion.joints.push_back(end);
    }
  }

  bool endsChain(Bone bone) const {
    for (int b = int(bone) + 1; b < kBoneCount; ++b)
      if (has(Bone(b)) && carrierOf(Bone(b)) == bone) return false;
    return true;
  }

  std::vector<double> frame(const HumanPose& pose) const {
    const Eigen::Vector3d hips = toFile(pose.hips);
    std::vector<double> values{hips.x(), hips.y(), hips.z()};
    const auto turned = [&](Bone bone) { return pose[bone] * restTurn(bone).conjugate(); };
    for (int b = 0; b < kBoneCount; ++b) {
      if (!has(Bone(b))) continue;
      Eigen::Quaterniond local = turned(Bone(b));
      if (b > 0) local = turned(carrierOf(Bone(b))).conjugate() * local;
      const Eigen::Matrix3d R = R_file_world * local.toRotationMatrix() * R_file_world.transpose();
      const Eigen::Vector3d angles = R.eulerAngles(2, 0, 1) * 180.0 / M_PI;
      values.insert(values.end(), {angles[0], angles[1], angles[2]});
    }
    return values;
  }
};

}  // namespace markerless_mocap
