#include "motion/rig_stance.h"

#include <cmath>

#include "motion/retarget/joint_name.h"
#include "numerics/shortest_rotation.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

// Cosine: maximum deviation of an upright person's legs from the direction below the trunk, and of
// a rig's forward direction from one of its axes.
constexpr double kUpright = 0.8;
constexpr double kAlongAxis = 0.96;

class Measurer {
 public:
  Measurer(const std::vector<NamedJoint>& joints, const BoneMap& bones,
           const std::vector<Vector3d>& positions)
      : joints_(joints), bones_(bones), positions_(positions), children_(joints.size()) {
    for (size_t j = 0; j < joints.size(); ++j)
      if (joints[j].parent >= 0) children_[size_t(joints[j].parent)].push_back(j);
  }

  bool measure(RigStance& stance) const {
    const Vector3d hips = middle(Bone::kLeftThigh);
    const Vector3d trunk = middle(Bone::kLeftUpperArm) - hips;
    const Vector3d legs = middle(Bone::kLeftFoot) - hips;
    const double legs_length = legLength();
    if (!(legs_length > 0.0) || !(trunk.norm() > 0.0) ||
        -trunk.dot(legs) < kUpright * trunk.norm() * legs.norm() ||
        legs.norm() < kUpright * legs_length)
      return false;
    const Vector3d up = nearestAxis(trunk.normalized() - legs.normalized());
    Vector3d left = across(Bone::kLeftThigh) + across(Bone::kLeftUpperArm);
    left -= up * up.dot(left);
    if (!(left.norm() > 1e-6 * legs_length)) return false;
    Vector3d forward = left.cross(up).normalized();
    const Vector3d axis = nearestAxis(forward);
    if (axis.dot(forward) > kAlongAxis) forward = axis;
    stance.R_world_rig.row(0) = forward;
    stance.R_world_rig.row(1) = up.cross(forward);
    stance.R_world_rig.row(2) = up;
    stance.leg_length = legs_length;
    stance.direction.fill(Vector3d::Zero());
    for (int b = 0; b < kBoneCount; ++b)
      stance.direction[size_t(b)] = stance.R_world_rig * directionOf(Bone(b));
    return true;
  }

 private:
  const Vector3d& at(Bone bone) const { return positions_[size_t(bones_[bone])]; }
  Vector3d middle(Bone left) const { return 0.5 * (at(left) + at(mirrorOf(left))); }
  Vector3d across(Bone left) const { return at(left) - at(mirrorOf(left)); }

  double legLength() const {
    double sum = 0.0;
    for (Bone thigh : {Bone::kLeftThigh, Bone::kRightThigh}) {
      const bool left = thigh == Bone::kLeftThigh;
      const Bone shank = left ? Bone::kLeftShank : Bone::kRightShank;
      const Bone foot = left ? Bone::kLeftFoot : Bone::kRightFoot;
      sum += (at(shank) - at(thigh)).norm() + (at(foot) - at(shank)).norm();
    }
    return 0.5 * sum;
  }

  static Vector3d nearestAxis(const Vector3d& direction) {
    int axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    return std::copysign(1.0, direction[axis]) * Vector3d::Unit(axis);
  }

  /// Direction of a limb's bone, see RigStance.
  Vector3d directionOf(Bone bone) const {
    if (bone < Bone::kLeftClavicle || bone == Bone::kLeftClavicle || bone == Bone::kRightClavicle ||
        !bones_.has(bone))
      return Vector3d::Zero();
    const size_t joint = size_t(bones_[bone]);
    const bool ends_limb = bone == Bone::kLeftHand || bone == Bone::kRightHand ||
                           bone == Bone::kLeftToes || bone == Bone::kRightToes;
    const Bone next = Bone(int(bone) + 1);
    const Vector3d to = !ends_limb && bones_.has(next) ? at(next) : middleOfChildren(joint);
    const Vector3d along = to - positions_[joint];
    return along.norm() > 0.0 ? Vector3d(along.normalized()) : Vector3d::Zero();
  }

  /// Mean position of the children, without the thumb; a child at the joint's own position is
  /// replaced by its children.
  Vector3d middleOfChildren(size_t joint) const {
    Vector3d sum = Vector3d::Zero();
    int count = 0;
    addChildren(joint, positions_[joint], sum, count);
    return count > 0 ? Vector3d(sum / count) : positions_[joint];
  }

  void addChildren(size_t joint, const Vector3d& from, Vector3d& sum, int& count) const {
    const double nearby = 1e-3 * legLength();
    for (size_t child : children_[joint]) {
      const JointName name = parseJointName(joints_[child].name);
      if (name.word.find("thumb") != std::string::npos ||
          joints_[child].name.compare(0, 2, "__") == 0)
        continue;
      if ((positions_[child] - from).norm() > nearby) {
        sum += positions_[child];
        ++count;
      } else {
        addChildren(child, from, sum, count);
      }
    }
  }

  const std::vector<NamedJoint>& joints_;
  const BoneMap& bones_;
  const std::vector<Vector3d>& positions_;
  std::vector<std::vector<size_t>> children_;
};

}  // namespace

PerBone<Eigen::Quaterniond> RigStance::turnsFrom(const HumanSkeleton& skeleton) const {
  PerBone<Eigen::Quaterniond> turns;
  turns.fill(Eigen::Quaterniond::Identity());
  for (size_t b = 0; b < size_t(kBoneCount); ++b) {
    const bool begins_limb = parentOf(Bone(b)) < Bone::kLeftClavicle ||
                             parentOf(Bone(b)) == Bone::kLeftClavicle ||
                             parentOf(Bone(b)) == Bone::kRightClavicle;
    if (!begins_limb) turns[b] = turns[size_t(parentOf(Bone(b)))];
    if (direction[b].isZero()) continue;
    const Vector3d canonical = turns[b] * (skeleton.tail[b] - skeleton.head[b]);
    turns[b] = shortestRotation(canonical, direction[b]) * turns[b];
  }
  return turns;
}

bool measureStance(const std::vector<NamedJoint>& joints, const BoneMap& bones,
                   const std::vector<Eigen::Vector3d>& positions, RigStance& stance) {
  return Measurer(joints, bones, positions).measure(stance);
}

}  // namespace markerless_mocap
