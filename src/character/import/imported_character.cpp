#include "character/imported_character.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "character/import/rig_skeleton.h"
#include "character/import/rigged_scene.h"
#include "character/skin/skin_weights.h"

namespace markerless_mocap {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

using BoneWeights = PerBone<double>;

struct UprightRig {
  RiggedMesh rig;
  BoneMap bones;
  RigStance stance;
};

/// The rig in world axes, in the first of its poses that is upright.
UprightRig uprightRig(const std::string& path) {
  const RiggedScene scene(path);
  for (RestPose pose : {RestPose::kBind, RestPose::kNodes}) {
    UprightRig upright;
    upright.rig = scene.in(pose);
    RiggedMesh& rig = upright.rig;
    upright.bones = mapBones(rig.joints, path);
    if (!measureStance(rig.joints, upright.bones, rig.joint_positions, upright.stance)) continue;
    const Eigen::Matrix3d& R = upright.stance.R_world_rig;
    for (Vector3d& place : rig.joint_positions) place = R * place;
    for (Eigen::Vector3f& vertex : rig.mesh.vertices)
      vertex = (R * vertex.cast<double>()).cast<float>();
    upright.bones = withTrunkByHeight(upright.bones, rig.joint_positions);
    return upright;
  }
  throw std::invalid_argument(path +
                              ": neither the bind pose nor the nodes' pose is a person standing "
                              "upright, so up and forward cannot be determined");
}

/// For each joint its bone, or the nearest bone above it.
std::vector<Bone> carriers(const std::vector<NamedJoint>& joints, const BoneMap& bones) {
  std::vector<Bone> carriers(joints.size(), Bone::kHips);
  for (size_t j = 0; j < joints.size(); ++j) {
    const auto own = std::find(bones.joint.begin(), bones.joint.end(), int(j));
    if (own != bones.joint.end()) {
      carriers[j] = Bone(own - bones.joint.begin());
    } else if (joints[j].parent >= 0) {
      carriers[j] = carriers[size_t(joints[j].parent)];
    }
  }
  return carriers;
}

std::vector<BoneWeights> boneWeights(const UprightRig& upright) {
  const std::vector<Bone> carrier = carriers(upright.rig.joints, upright.bones);
  std::vector<BoneWeights> all(upright.rig.weights.size());
  for (size_t v = 0; v < all.size(); ++v) {
    all[v].fill(0.0);
    for (const JointWeight& entry : upright.rig.weights[v])
      all[v][size_t(carrier[entry.joint])] += entry.weight;
  }
  return all;
}

/// Index of the largest weight; -1 if all weights are zero.
int heaviest(const BoneWeights& weights) {
  const auto max = std::max_element(weights.begin(), weights.end());
  return *max > 0.0 ? int(max - weights.begin()) : -1;
}

Bone nearestBone(const HumanSkeleton& skeleton, const Vector3d& point) {
  Bone nearest = Bone::kHips;
  double min_distance = std::numeric_limits<double>::max();
  for (int b = 0; b < kBoneCount; ++b) {
    const Vector3d bone = skeleton.tailOf(Bone(b)) - skeleton.headOf(Bone(b));
    const Vector3d from = point - skeleton.headOf(Bone(b));
    const double length = std::max(bone.squaredNorm(), 1e-12);
    const double distance = (from - std::clamp(from.dot(bone) / length, 0.0, 1.0) * bone).norm();
    if (distance >= min_distance) continue;
    min_distance = distance;
    nearest = Bone(b);
  }
  return nearest;
}

/// Moves weights to bones that the rig does not have, from the bone above, with a gradual
/// transition at their joint. Collar bones get no weight: their skin stays with the chest.
void distributeToMissing(const BoneMap& bones, const HumanSkeleton& skeleton, const Vector3d& point,
                         BoneWeights& weights) {
  constexpr double kReach = 0.3;  // reach of the transition to either side of the joint, fraction
                                  // of the shorter bone's length
  for (int b = 1; b < kBoneCount; ++b) {
    const Bone bone = Bone(b), parent = parentOf(bone);
    if (bones.has(bone) || bone == Bone::kLeftClavicle || bone == Bone::kRightClavicle ||
        weights[size_t(parent)] == 0.0)
      continue;
    const Vector3d along = (skeleton.tailOf(bone) - skeleton.headOf(parent)).normalized();
    const double reach = kReach * std::min(skeleton.lengthOf(bone), skeleton.lengthOf(parent));
    const double beyond = (point - skeleton.headOf(bone)).dot(along);
    const double fraction = std::clamp(0.5 + 0.5 * beyond / std::max(reach, 1e-9), 0.0, 1.0);
    weights[size_t(b)] = fraction * weights[size_t(parent)];
    weights[size_t(parent)] *= 1.0 - fraction;
  }
}

/// The person in the pose of the file.
Character standing(UprightRig& upright) {
  std::vector<BoneWeights> weights = boneWeights(upright);
  RigMeasures measures{upright.rig.joint_positions, upright.rig.mesh.vertices, {}};
  for (const BoneWeights& vertex : weights) measures.bone_of_vertex.push_back(heaviest(vertex));

  Character person;
  person.skeleton = rigSkeleton(upright.bones, upright.stance, measures);
  for (size_t v = 0; v < weights.size(); ++v) {
    const Vector3d point = measures.vertices[v].cast<double>();
    if (measures.bone_of_vertex[v] < 0)
      weights[v][size_t(nearestBone(person.skeleton, point))] = 1.0;
    distributeToMissing(upright.bones, person.skeleton, point, weights[v]);
    person.weights.push_back(fourLargest(weights[v]));
  }
  person.mesh = std::move(upright.rig.mesh);
  return person;
}

/// T-pose: legs straight down, arms straight out; feet keep their pitch and roll and point to the
/// front.
HumanPose tPose(const HumanSkeleton& bind, const RigStance& stance) {
  HumanSkeleton straight = HumanSkeleton::adult(1.75, 0.5);
  for (Bone bone : {Bone::kLeftThigh, Bone::kLeftShank, Bone::kRightThigh, Bone::kRightShank})
    straight.tail[size_t(bone)] = straight.headOf(bone) - Vector3d::UnitZ();
  const PerBone<Quaterniond> turns = stance.turnsFrom(straight);
  HumanPose pose;
  pose.hips = bind.headOf(Bone::kHips);
  for (size_t b = 0; b < size_t(kBoneCount); ++b) pose.R_world_bone[b] = turns[b].conjugate();
  for (Bone foot : {Bone::kLeftFoot, Bone::kRightFoot}) {
    const Bone toes = Bone(int(foot) + 1);
    const Vector3d along = bind.tailOf(toes) - bind.headOf(foot);
    const Eigen::AngleAxisd to_front(-std::atan2(along.y(), along.x()), Vector3d::UnitZ());
    pose[foot] = pose[toes] = Quaterniond(to_front);
  }
  return pose;
}

/// Averages left and right joints so that they mirror each other; joints of the middle are moved to
/// y = 0.
void mirrorMeans(PerBone<Vector3d>& joint_positions) {
  const PerBone<Vector3d> given = joint_positions;
  for (size_t b = 0; b < size_t(kBoneCount); ++b) {
    const Vector3d& other = given[size_t(mirrorOf(Bone(b)))];
    joint_positions[b] = 0.5 * (given[b] + Vector3d(other.x(), -other.y(), other.z()));
  }
}

Character inTPose(const Character& standing, const HumanPose& pose) {
  Character person = standing;
  standing.pose(pose, person.mesh.vertices);
  HumanSkeleton& skeleton = person.skeleton;
  skeleton.head = jointPositions(standing.skeleton, pose);
  for (int b = 0; b < kBoneCount; ++b)
    skeleton.tail[size_t(b)] = boneEnd(standing.skeleton, pose, skeleton.head, Bone(b));
  return person;
}

/// Scales the person to the stature and puts it on z = 0 with the hips above the origin.
void scaleAndPlace(Character& person, double stature) {
  float bottom = std::numeric_limits<float>::max(), top = -bottom;
  for (const Eigen::Vector3f& vertex : person.mesh.vertices) {
    bottom = std::min(bottom, vertex.z());
    top = std::max(top, vertex.z());
  }
  const double scale = stature / double(top - bottom);
  const Vector3d hips = person.skeleton.headOf(Bone::kHips);
  const Vector3d origin(hips.x(), hips.y(), double(bottom));
  HumanSkeleton& skeleton = person.skeleton;
  skeleton.stature = stature;
  for (PerBone<Vector3d>* joint_positions : {&skeleton.head, &skeleton.tail}) {
    for (Vector3d& place : *joint_positions) place = scale * (place - origin);
    mirrorMeans(*joint_positions);
  }
  for (Eigen::Vector3f& vertex : person.mesh.vertices)
    vertex = (scale * (vertex.cast<double>() - origin)).cast<float>();
}

}  // namespace

Character importCharacter(const std::string& path, double stature) {
  if (!(stature >= 0.5 && stature <= 2.5))
    throw std::invalid_argument(path + ": stature is " + std::to_string(stature) +
                                " m, allowed is 0.5 to 2.5");
  UprightRig upright = uprightRig(path);
  const Character bind = standing(upright);
  Character person = inTPose(bind, tPose(bind.skeleton, upright.stance));
  scaleAndPlace(person, stature);
  return person;
}

}  // namespace markerless_mocap
