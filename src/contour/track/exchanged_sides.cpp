#include "contour/track/exchanged_sides.h"

#include <Eigen/Geometry>

namespace markerless_mocap {
namespace {

using A = RevoluteJoint;
using B = SphericalJoint;
using S = ContourSegment;

constexpr double kKneeFraction = 0.3;  // fraction of the bend that is kept when front becomes back

}  // namespace

ContourPose mirrored(const ContourBody& body, const ContourPose& pose) {
  ContourFrames frames;
  body.place(pose, frames);
  const Eigen::Matrix3d about = Eigen::Vector3d(-1, -1, 1).asDiagonal();
  ContourPose out = pose;
  out.rotations[B::kRoot] = pose.rotations[B::kRoot] * about;
  out.angles[A::kSpinePitch] = -pose.angles[A::kSpinePitch];
  out.angles[A::kSpineRoll] = -pose.angles[A::kSpineRoll];
  out.rotations[B::kNeck] = about * pose.rotations[B::kNeck] * about;
  const Eigen::Matrix3d pelvis = frames.R[S::kPelvis] * about, chest = frames.R[S::kChest] * about;
  for (const size_t side : {0, 1}) {
    const size_t other = 1 - side;
    out.angles[A::kLeftClavicleYaw + 2 * side] = 0.0;
    out.angles[A::kLeftClavicleRoll + 2 * side] = 0.0;
    out.rotations[B::kLeftShoulder + side] = chest.transpose() * frames.R[S::kLeftUpperArm + other];
    out.angles[A::kLeftElbow + side] = pose.angles[A::kLeftElbow + other];
    out.rotations[B::kLeftHip + side] =
        pelvis.transpose() * frames.R[S::kLeftThigh + other] * about;
    out.angles[A::kLeftKnee + side] = kKneeFraction * pose.angles[A::kLeftKnee + other];
    out.angles[A::kLeftAnkle + side] = 0.0;
  }
  return out;
}

ContourPose withLegsSwapped(const ContourBody& body, const ContourPose& pose) {
  ContourFrames frames;
  body.place(pose, frames);
  ContourPose out = pose;
  for (const size_t side : {0, 1}) {
    const size_t other = 1 - side;
    out.rotations[B::kLeftHip + side] =
        frames.R[S::kPelvis].transpose() * frames.R[S::kLeftThigh + other];
    out.angles[A::kLeftKnee + side] = pose.angles[A::kLeftKnee + other];
    out.angles[A::kLeftAnkle + side] = pose.angles[A::kLeftAnkle + other];
  }
  return out;
}

}  // namespace markerless_mocap
