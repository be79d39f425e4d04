#include "motion/perform/arm_pose.h"

#include <algorithm>
#include <cmath>

#include "motion/perform/trunk_pose.h"
#include "motion/skeleton/two_bone_ik.h"

namespace markerless_mocap {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kMaxBend = 2.6;  // radians, elbow
constexpr double kSwing = 34.0;   // degrees per leg length of stride

Eigen::Quaterniond about(const Eigen::Vector3d& axis, double degrees) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * kDegree, axis));
}

const Eigen::Vector3d kX = Eigen::Vector3d::UnitX(), kY = Eigen::Vector3d::UnitY(),
                      kZ = Eigen::Vector3d::UnitZ();

struct ArmBones {
  Bone clavicle, upper, fore, hand;
};

/// Poses one arm at one time.
class ArmPoser {
 public:
  ArmPoser(const MotionScript& script, const GaitState& now, const HumanSkeleton& skeleton,
           bool left, HumanPose& pose)
      : script_(script),
        now_(now),
        skeleton_(skeleton),
        left_(left),
        side_(left ? 1.0 : -1.0),
        bones_(left ? ArmBones{Bone::kLeftClavicle, Bone::kLeftUpperArm, Bone::kLeftForearm,
                               Bone::kLeftHand}
                    : ArmBones{Bone::kRightClavicle, Bone::kRightUpperArm, Bone::kRightForearm,
                               Bone::kRightHand}),
        pose_(pose),
        chest_(pose[Bone::kChest]) {}

  void run() {
    const CurveValues angles = swungAngles();
    const Eigen::Quaterniond upper = chest_ * upperArmIn(angles);
    const Eigen::Quaterniond fore = upper * about(kZ, -side_ * angles[3]);
    Eigen::Vector3d shoulder = poseClavicle(upper * outward(1.0));
    const Eigen::Vector3d elbow = shoulder + upper * outward(length(bones_.upper));
    const Eigen::Vector3d wrist = elbow + fore * outward(length(bones_.fore));
    pose_[bones_.upper] = upper;
    pose_[bones_.fore] = fore;
    const Eigen::Vector3d target = handTarget(shoulder, wrist);
    if (target_weight_ > 1e-6) {
      const Eigen::Vector3d bent = (elbow - 0.5 * (shoulder + wrist)).normalized();
      // The clavicle follows the final direction of the arm.
      shoulder = poseClavicle((1.0 - target_weight_) * (upper * outward(1.0)) +
                              target_weight_ * (target - shoulder).normalized());
      reach(shoulder, target, bent);
    }
    poseHand();
  }

 private:
  CurveValues keyed(Track left, Track right) const {
    return script_.track(left_ ? left : right).at(now_.seconds);
  }

  Eigen::Vector3d outward(double metres) const { return {0.0, side_ * metres, 0.0}; }
  double length(Bone bone) const { return skeleton_.lengthOf(bone); }

  /// Rotation of the hanging arm, first outward, then forward about the line through the shoulders.
  Eigen::Quaterniond upperArmIn(const CurveValues& angles) const {
    return about(kY, -angles[0]) * about(kX, side_ * angles[1]) * about(kZ, -side_ * angles[2]) *
           about(kX, -side_ * 90.0);
  }

  /// The script's angles plus the arm swing of walking on hanging arms; the elbow bends as the arm
  /// moves forward.
  CurveValues swungAngles() const {
    CurveValues angles = keyed(Track::kLeftArm, Track::kRightArm);
    const double hanging = std::max(0.0, -(upperArmIn(angles) * outward(1.0)).z());
    const double factor = script_.track(Track::kArmSwing).at(now_.seconds)[0];
    const double swing = -side_ * kSwing * now_.stride * now_.moving * factor * hanging * hanging;
    angles[0] += swing + 1.6 * idleNoise(now_.seconds, left_ ? 11 : 15);
    angles[1] += 1.2 * idleNoise(now_.seconds, left_ ? 12 : 16);
    angles[3] += 0.55 * std::max(-8.0, swing) + 2.0 * idleNoise(now_.seconds, left_ ? 13 : 17);
    angles[3] = std::clamp(angles[3], 4.0, 148.0);
    return angles;
  }

  /// \param arm unit direction of the upper arm in the world
  /// \return position of the shoulder
  Eigen::Vector3d poseClavicle(const Eigen::Vector3d& arm) {
    const Eigen::Vector3d in_chest = (chest_.conjugate() * arm).normalized();
    const double raised = std::acos(std::clamp(-in_chest.z(), -1.0, 1.0)) / M_PI;  // 0: hangs
    const double fraction = std::clamp((raised - 0.2) / 0.7, 0.0, 1.0);
    const double lift = 24.0 * fraction * fraction * (3.0 - 2.0 * fraction);
    const double breath = 0.8 * std::sin(2.0 * M_PI * 0.27 * now_.seconds);
    pose_[bones_.clavicle] =
        chest_ * about(kZ, -side_ * 11.0 * in_chest.x()) * about(kX, side_ * (lift + breath));
    const PerBone<Eigen::Vector3d> heads = jointPositions(skeleton_, pose_);
    return heads[size_t(bones_.upper)];
  }

  /// Blends the wrist position of the angles with the targets of reach and grasp.
  Eigen::Vector3d handTarget(const Eigen::Vector3d& shoulder, const Eigen::Vector3d& wrist) {
    const CurveValues from_chest = keyed(Track::kLeftReach, Track::kRightReach);
    const CurveValues from_floor = keyed(Track::kLeftGrasp, Track::kRightGrasp);
    const Eigen::Vector3d reached =
        shoulder + chest_ * (skeleton_.armLength() *
                             Eigen::Vector3d(from_chest[1], side_ * from_chest[2], from_chest[3]));
    const GroundPose place = now_.place.shifted(from_floor[1] * skeleton_.stature,
                                                side_ * from_floor[2] * skeleton_.stature);
    const Eigen::Vector3d grasped(place.position.x(), place.position.y(),
                                  from_floor[3] * skeleton_.stature);
    const Eigen::Vector3d near = wrist + from_chest[0] * (reached - wrist);
    target_weight_ = 1.0 - (1.0 - from_chest[0]) * (1.0 - from_floor[0]);
    return near + from_floor[0] * (grasped - near);
  }

  void reach(const Eigen::Vector3d& shoulder, const Eigen::Vector3d& target,
             const Eigen::Vector3d& bent) {
    const Eigen::Vector3d down_and_out = chest_ * Eigen::Vector3d(-0.35, side_ * 0.5, -0.8);
    const Eigen::Vector3d pole = (1.0 - target_weight_) * bent + target_weight_ * down_and_out;
    const double upper = length(bones_.upper), fore = length(bones_.fore);
    const TwoBoneIkResult bend = solveTwoBoneIk(
        shoulder, softIkTarget(shoulder, target, upper + fore), upper, fore, pole, kMaxBend);
    const Eigen::Vector3d hinge = pole.cross(bend.end - shoulder);
    const Eigen::Vector3d hinge_at_rest(0.0, 0.0, -side_);
    pose_[bones_.upper] = turnWithHinge(outward(1.0), hinge_at_rest, bend.middle - shoulder, hinge);
    pose_[bones_.fore] = turnWithHinge(outward(1.0), hinge_at_rest, bend.end - bend.middle, hinge);
  }

  /// Half of the forearm's twist is applied to the forearm, the rest to the hand.
  void poseHand() {
    const CurveValues wrist = keyed(Track::kLeftWrist, Track::kRightWrist);
    pose_[bones_.fore] = pose_[bones_.fore] * about(kY, 0.5 * wrist[0]);
    pose_[bones_.hand] =
        pose_[bones_.fore] * about(kY, 0.5 * wrist[0]) *
        about(kX, -side_ * (wrist[1] + 3.0 * idleNoise(now_.seconds, left_ ? 20 : 23)));
  }

  const MotionScript& script_;
  const GaitState& now_;
  const HumanSkeleton& skeleton_;
  bool left_;
  double side_;  ///< 1: left, -1: right
  ArmBones bones_;
  HumanPose& pose_;
  Eigen::Quaterniond chest_;
  double target_weight_ = 0.0;  ///< weight of the hand's target relative to the angles
};

}  // namespace

void poseArms(const MotionScript& script, const GaitState& now, const HumanSkeleton& skeleton,
              HumanPose& pose) {
  for (const bool left : {true, false}) ArmPoser(script, now, skeleton, left, pose).run();
}

}  // namespace markerless_mocap
