#include "character/character.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::Vector4f;

constexpr int kTwistSteps = 16;

/// A rigid motion, as in Kavan et al., Skinning with dual quaternions (2007); x y z w.
struct DualQuaternion {
  Vector4f real, dual;
};

DualQuaternion dualQuaternion(const Quaterniond& q, const Vector3d& shift) {
  const Quaterniond t(0.0, shift.x(), shift.y(), shift.z());
  return {q.coeffs().cast<float>(), (0.5 * (t * q).coeffs()).cast<float>()};
}

/// Rotation about a bone's head, with a twist about the bone that varies along it.
struct BoneMotion {
  Eigen::Vector3f head, along;  ///< along: the bone's direction divided by its length
  std::array<DualQuaternion, kTwistSteps + 1> steps;
  bool twists = false;

  DualQuaternion at(const Eigen::Vector3f& rest) const {
    if (!twists) return steps[0];
    const float place = std::clamp((rest - head).dot(along), 0.0f, 1.0f) * kTwistSteps;
    const size_t i = std::min(size_t(place), size_t(kTwistSteps - 1));
    const float f = place - float(i);
    return {steps[i].real + f * (steps[i + 1].real - steps[i].real),
            steps[i].dual + f * (steps[i + 1].dual - steps[i].dual)};
  }
};

/// Twist angle of a rotation about an axis (swing-twist decomposition), -pi to pi.
double twistAngle(const Quaterniond& q, const Vector3d& axis) {
  const double angle = 2.0 * std::atan2(q.vec().dot(axis), q.w());
  return std::remainder(angle, 2.0 * M_PI);
}

/// Correction of the twist of the skin along a bone. At the root of upper arm and thigh the skin
/// stays with the trunk; along the forearm it changes from the elbow's twist to the hand's.
struct TwistSpread {
  double begin = 0.0, end = 0.0;  ///< twist added at the bone's head and tail, radians
};

TwistSpread twistSpread(const HumanPose& pose, Bone bone, const Vector3d& axis) {
  const auto twistFrom = [&](Bone from, Bone to) {
    return twistAngle(pose[from].conjugate() * pose[to], axis);
  };
  const Bone left = bone < Bone::kRightClavicle ? bone : mirrorOf(bone);
  if (left == Bone::kLeftUpperArm || left == Bone::kLeftThigh)
    return {-twistFrom(parentOf(bone), bone), 0.0};
  if (left == Bone::kLeftForearm)
    return {-twistFrom(parentOf(bone), bone), twistFrom(bone, Bone(int(bone) + 1))};
  return {};
}

PerBone<BoneMotion> boneMotions(const HumanSkeleton& skeleton, const HumanPose& pose) {
  const PerBone<Vector3d> heads = jointPositions(skeleton, pose);
  PerBone<BoneMotion> motions;
  PerBone<Quaterniond> turns = pose.R_world_bone;
  for (size_t b = 0; b < size_t(kBoneCount); ++b) {
    // q and -q are the same rotation but blend differently: the sign nearer to the parent is used.
    if (turns[b].dot(turns[size_t(parentOf(Bone(b)))]) < 0.0) turns[b].coeffs() *= -1.0;
    const Vector3d bone = skeleton.tail[b] - skeleton.head[b], axis = bone.normalized();
    const TwistSpread spread = twistSpread(pose, Bone(b), axis);
    BoneMotion& motion = motions[b];
    motion.head = skeleton.head[b].cast<float>();
    motion.along = (bone / bone.squaredNorm()).cast<float>();
    motion.twists = spread.begin != 0.0 || spread.end != 0.0;
    for (int i = 0; i <= (motion.twists ? kTwistSteps : 0); ++i) {
      const double angle = spread.begin + (spread.end - spread.begin) * i / kTwistSteps;
      const Quaterniond q = turns[b] * Quaterniond(Eigen::AngleAxisd(angle, axis));
      motion.steps[size_t(i)] = dualQuaternion(q, heads[b] - q * skeleton.head[b]);
    }
  }
  return motions;
}

Eigen::Vector3f moved(const DualQuaternion& blend, const Eigen::Vector3f& p) {
  const Eigen::Vector3f r = blend.real.head<3>(), d = blend.dual.head<3>();
  const float w = blend.real.w(), per_norm = 1.0f / blend.real.squaredNorm();
  const Eigen::Vector3f shift = w * d - blend.dual.w() * r + r.cross(d);
  return p + 2.0f * per_norm * (r.cross(r.cross(p) + w * p) + shift);
}

}  // namespace

void Character::pose(const HumanPose& pose, std::vector<Eigen::Vector3f>& vertices) const {
  const PerBone<BoneMotion> motions = boneMotions(skeleton, pose);
  vertices.resize(mesh.vertices.size());
  for (size_t v = 0; v < vertices.size(); ++v) {
    DualQuaternion blend{Vector4f::Zero(), Vector4f::Zero()};
    for (size_t k = 0; k < 4; ++k) {
      const float weight = weights[v].weights[k];
      if (weight == 0.0f) continue;
      const DualQuaternion bone = motions[size_t(weights[v].bones[k])].at(mesh.vertices[v]);
      blend.real += weight * bone.real;
      blend.dual += weight * bone.dual;
    }
    vertices[v] = moved(blend, mesh.vertices[v]);
  }
}

}  // namespace markerless_mocap
