#include "fitting/mirrored_pose.h"

#include <Eigen/Geometry>

namespace markerless_mocap {
namespace {

using A = ContourAngle;
using B = ContourBall;
using S = ContourSegment;

constexpr double kKneeKept = 0.3;  // of the bend

}  // namespace

ContourPose mirrored(const ContourBody& body, const ContourPose& pose) {
  ContourFrames frames;
  body.place(pose, frames);
  const Eigen::Matrix3d about = Eigen::Vector3d(-1, -1, 1).asDiagonal();
  ContourPose out = pose;
  out.balls[B::kRoot] = pose.balls[B::kRoot] * about;
  out.angles[A::kSpinePitch] = -pose.angles[A::kSpinePitch];
  out.angles[A::kSpineRoll] = -pose.angles[A::kSpineRoll];
  out.balls[B::kNeck] = about * pose.balls[B::kNeck] * about;
  const Eigen::Matrix3d pelvis = frames.R[S::kPelvis] * about, chest = frames.R[S::kChest] * about;
  for (const size_t side : {0, 1}) {
    const size_t other = 1 - side;
    out.angles[A::kLeftClavicleYaw + 2 * side] = 0.0;
    out.angles[A::kLeftClavicleRoll + 2 * side] = 0.0;
    out.balls[B::kLeftShoulder + side] = chest.transpose() * frames.R[S::kLeftUpperArm + other];
    out.angles[A::kLeftElbow + side] = pose.angles[A::kLeftElbow + other];
    out.balls[B::kLeftHip + side] = pelvis.transpose() * frames.R[S::kLeftThigh + other] * about;
    out.angles[A::kLeftKnee + side] = kKneeKept * pose.angles[A::kLeftKnee + other];
    out.angles[A::kLeftAnkle + side] = 0.0;
  }
  return out;
}

}  // namespace markerless_mocap
