#include "exports/skin/measured_bones.h"

#include <stdexcept>
#include <string>

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

class Bones {
 public:
  Bones(const ExportSkeleton& skeleton, const HumanSkeleton& average)
      : skeleton_(skeleton), average_(average) {
    out_.skeleton = average;
  }

  MeasuredBones all() {
    addTrunk();
    for (const bool left : {true, false}) {
      addArm(left);
      addLeg(left);
    }
    return out_;
  }

 private:
  size_t jointAt(const std::string& point) const {
    for (size_t j = 0; j < skeleton_.size(); ++j)
      if (skeleton_[j].point == point) return j;
    throw std::invalid_argument("the skeleton has no joint at " + point);
  }
  Vector3d placeOf(const std::string& point) const { return skeleton_[jointAt(point)].rest; }

  void add(Bone bone, const std::string& point, const Vector3d& head, const Vector3d& tail) {
    out_.skeleton.head[size_t(bone)] = head;
    out_.skeleton.tail[size_t(bone)] = tail;
    out_.joint[size_t(bone)] = jointAt(point);
  }

  /// The place between two as far along as the average adult's joint is between its neighbours.
  Vector3d between(const Vector3d& a, const Vector3d& b, Bone first, Bone second) const {
    const double lower = average_.lengthOf(first), upper = average_.lengthOf(second);
    return a + lower / (lower + upper) * (b - a);
  }

  void addTrunk() {
    const Vector3d hips = placeOf("pelvis"), waist = placeOf("waist"), neck = placeOf("thorax");
    const Vector3d top = skeleton_[jointAt("head")].end;
    const Vector3d ribs = between(waist, neck, Bone::kSpine, Bone::kChest);
    const Vector3d head = between(neck, top, Bone::kNeck, Bone::kHead);
    add(Bone::kHips, "pelvis", hips, waist);
    add(Bone::kSpine, "waist", waist, ribs);
    add(Bone::kChest, "torso", ribs, neck);
    add(Bone::kNeck, "thorax", neck, head);
    add(Bone::kHead, "head", head, top);
  }

  void addArm(bool left) {
    const std::string side = left ? "l_" : "r_";
    const auto bone = [&](Bone of_left) { return left ? of_left : mirrorOf(of_left); };
    const Vector3d shoulder = placeOf(side + "shoulder"), elbow = placeOf(side + "elbow");
    const Vector3d wrist = placeOf(side + "wrist");
    add(bone(Bone::kLeftClavicle), side + "clavicle", placeOf(side + "clavicle"), shoulder);
    add(bone(Bone::kLeftUpperArm), side + "shoulder", shoulder, elbow);
    add(bone(Bone::kLeftForearm), side + "elbow", elbow, wrist);
    add(bone(Bone::kLeftHand), side + "wrist", wrist, skeleton_[jointAt(side + "wrist")].end);
  }

  void addLeg(bool left) {
    const std::string side = left ? "l_" : "r_";
    const auto bone = [&](Bone of_left) { return left ? of_left : mirrorOf(of_left); };
    const Vector3d hip = placeOf(side + "hip"), knee = placeOf(side + "knee");
    const Vector3d ankle = placeOf(side + "ankle"), tip = skeleton_[jointAt(side + "ankle")].end;
    const Vector3d ball = between(Vector3d(ankle.x(), ankle.y(), tip.z()), tip,
                                  bone(Bone::kLeftFoot), bone(Bone::kLeftToes));
    add(bone(Bone::kLeftThigh), side + "hip", hip, knee);
    add(bone(Bone::kLeftShank), side + "knee", knee, ankle);
    add(bone(Bone::kLeftFoot), side + "ankle", ankle, ball);
    add(bone(Bone::kLeftToes), side + "ankle", ball, tip);
  }

  const ExportSkeleton& skeleton_;
  const HumanSkeleton& average_;
  MeasuredBones out_;
};

}  // namespace

MeasuredBones measuredBones(const ExportSkeleton& skeleton, const HumanSkeleton& average) {
  return Bones(skeleton, average).all();
}

}  // namespace markerless_mocap
