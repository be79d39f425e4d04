#include "contour/track/default_postures.h"

namespace markerless_mocap {
namespace {

using A = RevoluteJoint;
using B = SphericalJoint;

/// Radians: forward lean of the trunk, angle between thighs and trunk, and bend of the knees.
struct Posture {
  double lean, thighs, knees;
};
constexpr Posture kPostures[] = {{0.0, 0.0, 0.0}, {1.2, 1.2, 0.0}, {0.5, 1.9, 2.0}};
constexpr int kDirections = 4;

Eigen::Vector3d middleOf(const VisualHull& hull) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const HullVoxel& voxel : hull.voxels) sum += hull.lattice.center(voxel.index);
  return sum / double(hull.voxels.size());
}

/// The pose with the pelvis at `middle` and hanging arms.
ContourPose poseOf(const Posture& posture, double direction, const Eigen::Vector3d& middle) {
  ContourPose pose;
  pose.position = middle;
  pose.rotations[B::kRoot] = expSO3({0, 0, direction}) * expSO3({0, posture.lean, 0});
  for (const size_t side : {0, 1}) {
    pose.rotations[B::kLeftShoulder + side] = expSO3({0, -posture.lean, 0});
    pose.rotations[B::kLeftHip + side] = expSO3({0, -posture.thighs, 0});
    pose.angles[A::kLeftKnee + side] = -posture.knees;
  }
  return pose;
}

}  // namespace

std::vector<ContourPose> defaultPostures(const VisualHull& hull) {
  std::vector<ContourPose> poses;
  if (hull.voxels.empty()) return poses;
  const Eigen::Vector3d middle = middleOf(hull);
  for (int i = 0; i < kDirections; ++i)
    for (const Posture& posture : kPostures)
      poses.push_back(poseOf(posture, 2.0 * M_PI * i / kDirections, middle));
  return poses;
}

}  // namespace markerless_mocap
