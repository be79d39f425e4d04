#include "contour/track/default_postures.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

namespace markerless_mocap {
namespace {

using A = RevoluteJoint;
using B = SphericalJoint;

/// Radians and metres. `lean` tilts the trunk forward, `roll` turns it about its own axis; `thighs`
/// is the angle between thighs and trunk, `knees` their bend; `arms` lifts the upper arms forward
/// from hanging, `elbows` bends them. The middle of the body is `ahead` of the pelvis. The pelvis
/// is `height` above the lowest point of the hull; 0: at its middle.
struct Posture {
  double lean, thighs, knees;
  double roll = 0.0, arms = 0.0, elbows = 0.0;
  double ahead = 0.0, height = 0.0;
};
constexpr double kQuarter = M_PI / 2.0;

constexpr double kPoorQuality = 0.86;

const Posture kStanding[] = {{0.0, 0.0, 0.0}, {1.2, 1.2, 0.0}, {0.5, 1.9, 2.0}};
const Posture kCrouching[] = {kStanding[2]};
// Hands on the thighs.
const Posture kSeated[] = {{0.0, 1.5, 1.5, 0.0, 0.2, 1.0, 0.15, 0.52},
                           {0.5, 1.9, 1.5, 0.0, 0.6, 0.6, 0.2, 0.52}};
const Posture kKneeling[] = {{0.0, 0.0, 1.6, 0.0, 0.0, 0.2, 0.0, 0.5}};
const Posture kCrawling[] = {{1.45, 1.5, 1.5, 0.0, 0.0, 0.0, 0.25, 0.5}};
const Posture kLying[] = {{-kQuarter, 0.0, 0.0},
                          {kQuarter, 0.0, 0.0},
                          {-kQuarter, 0.3, 0.5, kQuarter},
                          {-kQuarter, 0.3, 0.5, -kQuarter}};

/// The hull's place: its middle, lowest height and extent upward, metres, and the direction of its
/// longest level axis, radians.
struct HullPlace {
  Eigen::Vector3d middle;
  double low, height, axis;
};

HullPlace placeOf(const VisualHull& hull) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const HullVoxel& voxel : hull.voxels) {
    const Eigen::Vector3d at = hull.lattice.center(voxel.index);
    sum += at;
    low = std::min(low, at.z());
    high = std::max(high, at.z());
  }
  HullPlace place{sum / double(hull.voxels.size()), low, high - low, 0.0};
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const HullVoxel& voxel : hull.voxels) {
    const Eigen::Vector2d off = (hull.lattice.center(voxel.index) - place.middle).head<2>();
    spread += off * off.transpose();
  }
  const Eigen::Vector2d longest =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors().col(1);
  place.axis = std::atan2(longest.y(), longest.x());
  return place;
}

ContourPose poseOf(const Posture& posture, double direction, const HullPlace& place) {
  ContourPose pose;
  const Eigen::Matrix3d heading = expSO3({0, 0, direction});
  pose.position = place.middle - posture.ahead * heading.col(0);
  if (posture.height > 0.0) pose.position.z() = place.low + posture.height;
  pose.rotations[B::kRoot] = heading * expSO3({0, posture.lean, 0}) * expSO3({0, 0, posture.roll});
  const double shoulders = std::abs(posture.lean) < kQuarter ? posture.lean : 0.0;
  for (const size_t side : {0, 1}) {
    pose.rotations[B::kLeftShoulder + side] = expSO3({0, -shoulders - posture.arms, 0});
    pose.angles[A::kLeftElbow + side] = posture.elbows;
    pose.rotations[B::kLeftHip + side] = expSO3({0, -posture.thighs, 0});
    pose.angles[A::kLeftKnee + side] = -posture.knees;
  }
  return pose;
}

}  // namespace

std::vector<ContourPose> defaultPostures(const VisualHull& hull) {
  std::vector<ContourPose> poses;
  if (hull.voxels.empty()) return poses;
  const HullPlace place = placeOf(hull);
  const auto add = [&](const auto& postures, double first, int directions) {
    for (int i = 0; i < directions; ++i)
      for (const Posture& posture : postures)
        poses.push_back(poseOf(posture, first + 2.0 * M_PI * i / directions, place));
  };
  add(kStanding, 0.0, 4);
  if (place.height > 0.8) add(kSeated, 0.0, 8);
  if (place.height > 0.7) add(kKneeling, 0.0, 8);
  if (place.height < 1.4) add(kCrouching, M_PI / 4.0, 4);
  if (place.height < 1.2) add(kCrawling, place.axis, 4);
  if (place.height < 1.0) add(kLying, place.axis, 2);
  return poses;
}

void completeProposals(const ContourMultiHypothesisTracker& tracker, const ContourObservation& seen,
                       const ContourBody& body, const VisualHull& hull,
                       std::vector<ContourPose>& poses) {
  if (qualityOf(tracker.bestFit(seen, body, poses)) >= kPoorQuality) return;
  for (const ContourPose& posture : defaultPostures(hull)) poses.push_back(posture);
}

}  // namespace markerless_mocap
