#include "motion/human_skeleton.h"

#include <stdexcept>

namespace markerless_mocap {
namespace {

struct Ratios {
  // Heights above the floor and half widths as fractions of the stature.
  double hip, lumbar, ribs, neck, head, shoulder, knee, ankle, ball;
  double hip_half, shoulder_half;
  // Lengths as fractions of the stature.
  double upper_arm, forearm, hand, ankle_to_ball, toes;
};

// Segment lengths after Winter, Biomechanics and Motor Control of Human Movement, figure 4.1
// (from Drillis and Contini 1966), widths, feet and sexes after Gordon et al., ANSUR 1988. The
// shoulder is the joint's centre, 4 cm below the acromion.
// Hips: 0.36 of the breadth between the iliac spines to each side and 6 cm behind them in standing
// (Bell et al. 1990; Hara et al. 2016, CT of 157 people). Knees: the axis through the epicondyles
// is that of bending (Churchill et al. 1998), 2.4 cm before the condyles' back, so 0.55 to 0.6 of
// the knee's depth behind the kneecap. Head: it turns about the atlanto-occipital joint, 11 mm
// behind and 22 mm below the tragion (Reed et al. 1999), which is 13 cm below the crown and midway
// between forehead and back of the head.
constexpr Ratios kWoman{0.520, 0.575, 0.675, 0.843, 0.910, 0.803, 0.277, 0.041,
                        0.012, 0.052, 0.093, 0.168, 0.140, 0.105, 0.075, 0.041};
constexpr Ratios kMan{0.523, 0.578, 0.680, 0.845, 0.912, 0.806, 0.281, 0.043,
                      0.012, 0.049, 0.099, 0.172, 0.145, 0.108, 0.077, 0.042};

Eigen::Vector3d mirrored(const Eigen::Vector3d& left) {
  return {left.x(), -left.y(), left.z()};
}

}  // namespace

double HumanSkeleton::legLength() const {
  return lengthOf(Bone::kLeftThigh) + lengthOf(Bone::kLeftShank);
}

double HumanSkeleton::armLength() const {
  return lengthOf(Bone::kLeftUpperArm) + lengthOf(Bone::kLeftForearm);
}

HumanSkeleton HumanSkeleton::adult(double stature, double male) {
  if (!(stature >= 0.5 && stature <= 2.5))
    throw std::invalid_argument("stature is " + std::to_string(stature) +
                                " m, allowed is 0.5 to 2.5");
  if (!(male >= 0.0 && male <= 1.0))
    throw std::invalid_argument("male is " + std::to_string(male) + ", allowed is 0 to 1");
  const auto of = [&](double Ratios::*ratio) {
    return stature * ((1.0 - male) * kWoman.*ratio + male * kMan.*ratio);
  };
  HumanSkeleton s;
  s.stature = stature;
  const auto bone = [&](Bone which, const Eigen::Vector3d& head, const Eigen::Vector3d& tail) {
    s.head[size_t(which)] = head;
    s.tail[size_t(which)] = tail;
    const Bone other = mirrorOf(which);
    if (other == which) return;
    s.head[size_t(other)] = mirrored(head);
    s.tail[size_t(other)] = mirrored(tail);
  };
  const Eigen::Vector3d hips(0, 0, of(&Ratios::hip)),
      lumbar(-0.008 * stature, 0, of(&Ratios::lumbar)),
      ribs(-0.006 * stature, 0, of(&Ratios::ribs)), neck(-0.010 * stature, 0, of(&Ratios::neck)),
      head(-0.006 * stature, 0, of(&Ratios::head));
  bone(Bone::kHips, hips, lumbar);
  bone(Bone::kSpine, lumbar, ribs);
  bone(Bone::kChest, ribs, neck);
  bone(Bone::kNeck, neck, head);
  bone(Bone::kHead, head, {head.x(), 0, stature});

  const double shoulder_z = of(&Ratios::shoulder);
  const Eigen::Vector3d collar(0.005 * stature, 0.018 * stature, shoulder_z),
      shoulder(-0.010 * stature, of(&Ratios::shoulder_half), shoulder_z),
      elbow = shoulder + Eigen::Vector3d(0, of(&Ratios::upper_arm), 0),
      wrist = elbow + Eigen::Vector3d(0, of(&Ratios::forearm), 0);
  bone(Bone::kLeftClavicle, collar, shoulder);
  bone(Bone::kLeftUpperArm, shoulder, elbow);
  bone(Bone::kLeftForearm, elbow, wrist);
  bone(Bone::kLeftHand, wrist, wrist + Eigen::Vector3d(0, of(&Ratios::hand), 0));

  const double side = of(&Ratios::hip_half);
  const Eigen::Vector3d hip(0, side, of(&Ratios::hip)), knee(0, side, of(&Ratios::knee)),
      ankle(-0.006 * stature, side, of(&Ratios::ankle)),
      ball(ankle.x() + of(&Ratios::ankle_to_ball), side, of(&Ratios::ball));
  bone(Bone::kLeftThigh, hip, knee);
  bone(Bone::kLeftShank, knee, ankle);
  bone(Bone::kLeftFoot, ankle, ball);
  bone(Bone::kLeftToes, ball, ball + Eigen::Vector3d(of(&Ratios::toes), 0, 0));
  return s;
}

PerBone<Eigen::Vector3d> jointPositions(const HumanSkeleton& skeleton, const HumanPose& pose) {
  PerBone<Eigen::Vector3d> heads;
  heads[0] = pose.hips;
  for (int i = 1; i < kBoneCount; ++i) {
    const size_t parent = size_t(parentOf(Bone(i)));
    heads[size_t(i)] = heads[parent] + pose.R_world_bone[parent] *
                                           (skeleton.head[size_t(i)] - skeleton.head[parent]);
  }
  return heads;
}

Eigen::Vector3d boneEnd(const HumanSkeleton& skeleton, const HumanPose& pose,
                        const PerBone<Eigen::Vector3d>& heads, Bone bone) {
  return heads[size_t(bone)] + pose[bone] * (skeleton.tailOf(bone) - skeleton.headOf(bone));
}

}  // namespace markerless_mocap
