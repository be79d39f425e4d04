#include "character/import/rig_skeleton.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

constexpr double kAnyStature = 1.75;  // only proportions are used

/// A horizontal unit vector; to the front if the direction is unknown.
Vector3d levelled(const Vector3d& direction) {
  const Vector3d level(direction.x(), direction.y(), 0.0);
  return level.norm() > 1e-6 ? Vector3d(level.normalized()) : Vector3d(Vector3d::UnitX());
}

class Placer {
 public:
  Placer(const BoneMap& bones, const RigStance& stance, const RigMeasures& measures)
      : bones_(bones),
        stance_(stance),
        measures_(measures),
        adult_(HumanSkeleton::adult(kAnyStature, 0.5)),
        scale_(stance.leg_length / adult_.legLength()) {
    bottom_ = top_ = measures.vertices.front().z();
    for (const Eigen::Vector3f& vertex : measures.vertices) {
      bottom_ = std::min(bottom_, double(vertex.z()));
      top_ = std::max(top_, double(vertex.z()));
    }
  }

  HumanSkeleton placed() {
    for (int b = 0; b < kBoneCount; ++b)
      if (bones_.has(Bone(b))) head(Bone(b)) = measures_.joint_positions[size_t(bones_[Bone(b)])];
    head(Bone::kHips) = 0.5 * (head(Bone::kLeftThigh) + head(Bone::kRightThigh));
    placeTrunk();
    for (const auto& [clavicle, toes] : {std::pair(Bone::kLeftClavicle, Bone::kLeftToes),
                                         std::pair(Bone::kRightClavicle, Bone::kRightToes)}) {
      placeArm(clavicle);
      placeLeg(toes);
    }
    skeleton_.stature = top_ - bottom_;
    return skeleton_;
  }

 private:
  Vector3d& head(Bone bone) { return skeleton_.head[size_t(bone)]; }
  Vector3d& tail(Bone bone) { return skeleton_.tail[size_t(bone)]; }

  /// Places the joints from hips to crown; unknown ones are interpolated by height between known
  /// ones. A joint that is not above the one below it counts as unknown.
  void placeTrunk() {
    const Vector3d shoulders = 0.5 * (head(Bone::kLeftUpperArm) + head(Bone::kRightUpperArm));
    constexpr double kMinAbove = 0.01;  // fraction of the leg length
    for (Bone bone : {Bone::kSpine, Bone::kChest, Bone::kNeck, Bone::kHead}) {
      const Bone below = Bone(int(bone) - 1);
      if (bones_.has(bone) && head(bone).z() > head(below).z() + kMinAbove * stance_.leg_length)
        continue;
      double z_below = adult_.headOf(below).z(), z_above = adult_.headOf(Bone::kLeftUpperArm).z();
      Vector3d from = head(below), to = shoulders;
      const double z = adult_.headOf(bone).z();
      if (z > z_above) {
        if (from.z() < shoulders.z()) {
          from = shoulders;
          z_below = z_above;
        }
        const bool is_neck = bone == Bone::kNeck && bones_.has(Bone::kHead);
        to = is_neck ? head(Bone::kHead) : Vector3d(from.x(), from.y(), top_);
        z_above = is_neck ? adult_.headOf(Bone::kHead).z() : kAnyStature;
      } else if (bone == Bone::kSpine && bones_.has(Bone::kChest)) {
        to = head(Bone::kChest);
        z_above = adult_.headOf(Bone::kChest).z();
      }
      head(bone) = from + (z - z_below) / (z_above - z_below) * (to - from);
    }
    for (int b = int(Bone::kHips); b < int(Bone::kHead); ++b) tail(Bone(b)) = head(Bone(b + 1));
    tail(Bone::kHead) = {head(Bone::kHead).x(), head(Bone::kHead).y(), top_};
  }

  void placeArm(Bone clavicle) {
    const Bone upper = Bone(int(clavicle) + 1), fore = Bone(int(clavicle) + 2),
               hand = Bone(int(clavicle) + 3);
    if (!bones_.has(clavicle)) {
      const Vector3d shoulders = 0.5 * (head(upper) + head(mirrorOf(upper)));
      const double inner = adult_.headOf(clavicle).y() / adult_.headOf(upper).y();
      head(clavicle) = shoulders + inner * (head(upper) - shoulders);
    }
    Vector3d along = stance_.direction[size_t(hand)];
    if (along.isZero()) along = stance_.direction[size_t(fore)];
    if (along.isZero()) along = stance_.direction[size_t(upper)];
    const double hand_length = adult_.lengthOf(hand), fore_length = adult_.lengthOf(fore);
    if (bones_.has(hand)) {
      tail(hand) = head(hand) + reach({hand}, head(hand), along, scale_ * hand_length) * along;
    } else {
      const double whole = fore_length + hand_length;
      tail(hand) = head(fore) + reach({fore}, head(fore), along, scale_ * whole) * along;
      head(hand) = head(fore) + fore_length / whole * (tail(hand) - head(fore));
    }
    for (Bone bone : {clavicle, upper, fore}) tail(bone) = head(Bone(int(bone) + 1));
  }

  void placeLeg(Bone toes) {
    const Bone foot = Bone(int(toes) - 1), shank = Bone(int(toes) - 2), thigh = Bone(int(toes) - 3);
    Vector3d along = levelled(stance_.direction[size_t(foot)]);
    const double foot_length = adult_.tailOf(toes).x() - adult_.headOf(foot).x();
    const double whole = reach({foot, toes}, head(foot), along, scale_ * foot_length);
    if (!bones_.has(toes)) {
      const double ball = (adult_.headOf(toes).x() - adult_.headOf(foot).x()) / foot_length;
      const double low = adult_.headOf(toes).z() / adult_.headOf(foot).z();
      head(toes) = head(foot) + ball * whole * along;
      head(toes).z() = bottom_ + low * (head(foot).z() - bottom_);
    }
    const double to_ball = (head(toes) - head(foot)).dot(along);
    const double min_length = 0.1 * scale_ * adult_.lengthOf(toes);
    tail(toes) = head(toes) + std::max(whole - to_ball, min_length) * along;
    for (Bone bone : {thigh, shank, foot}) tail(bone) = head(Bone(int(bone) + 1));
  }

  /// Maximum extent of the bones' vertices from a point along a direction; `otherwise` if there are
  /// none.
  double reach(std::initializer_list<Bone> bones, const Vector3d& from, const Vector3d& along,
               double otherwise) const {
    double farthest = 0.0;
    for (size_t v = 0; v < measures_.vertices.size(); ++v) {
      const Bone bone = Bone(measures_.bone_of_vertex[v]);
      if (std::find(bones.begin(), bones.end(), bone) == bones.end()) continue;
      farthest = std::max(farthest, (measures_.vertices[v].cast<double>() - from).dot(along));
    }
    return farthest > 0.2 * otherwise ? farthest : otherwise;
  }

  const BoneMap& bones_;
  const RigStance& stance_;
  const RigMeasures& measures_;
  const HumanSkeleton adult_;
  const double scale_;
  double bottom_ = 0.0, top_ = 0.0;
  HumanSkeleton skeleton_;
};

}  // namespace

HumanSkeleton rigSkeleton(const BoneMap& bones, const RigStance& stance,
                          const RigMeasures& measures) {
  return Placer(bones, stance, measures).placed();
}

BoneMap withTrunkByHeight(BoneMap bones, const std::vector<Vector3d>& joint_positions) {
  // Fractions of the height from hips to shoulders, see HumanSkeleton::adult().
  constexpr double kSpineHeight = 0.2, kChestHeight = 0.56;
  const auto middle = [&](Bone left) {
    return 0.5 * (joint_positions[size_t(bones[left])].z() +
                  joint_positions[size_t(bones[mirrorOf(left)])].z());
  };
  const double hips = middle(Bone::kLeftThigh), trunk = middle(Bone::kLeftUpperArm) - hips;
  const auto missing = [&](int joint, double height) {
    return std::abs((joint_positions[size_t(joint)].z() - hips) / trunk - height);
  };
  int& spine = bones.joint[size_t(Bone::kSpine)];
  int& chest = bones.joint[size_t(Bone::kChest)];
  spine = chest = -1;
  for (int joint : bones.spine) {
    if (spine < 0 || missing(joint, kSpineHeight) < missing(spine, kSpineHeight)) spine = joint;
    if (chest < 0 || missing(joint, kChestHeight) < missing(chest, kChestHeight)) chest = joint;
  }
  if (spine >= 0 && spine == chest)
    (missing(spine, kSpineHeight) < missing(chest, kChestHeight) ? chest : spine) = -1;
  return bones;
}

}  // namespace markerless_mocap
