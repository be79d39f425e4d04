#include "skeleton/labelling/extremity_position.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

// Distances from the surface back to the point, as fractions of the longest path.
constexpr double kHeadBack = 0.0376, kHandBack = 0.0344, kFootBack = 0.0295;
// For feet that are merged below, fractions of the longest path.
constexpr double kShankLow = 0.10;   // path length from the end above which the shanks are separate
constexpr double kFootReach = 0.13;  // maximum distance of the feet's voxels from the end
constexpr double kMinForward = 0.01;  // minimum distance of their mean from the ankles
constexpr double kStraight = 0.06;    // length of the path that gives its direction, metres

double backOf(UnsidedExtremity end) {
  if (end == UnsidedExtremity::kHead) return kHeadBack;
  return end == UnsidedExtremity::kHand1 || end == UnsidedExtremity::kHand2 ? kHandBack : kFootBack;
}

}  // namespace

Eigen::Vector3d extremityPosition(const NodePath& path, UnsidedExtremity end, bool closed,
                                  double longest, const TreeVolume& volume) {
  const NodePath last = pathSection(path, 0.0, kStraight);
  const Eigen::Vector3d out = (last.front() - last.back()).stableNormalized();
  const double surface =
      closed ? 0.0 : volume.distanceToSurface(path.front(), out, 0.2) + 0.5 * volume.pitch();
  double back = backOf(end) * longest - surface;
  if (back <= 0.0) return path.front() - back * out;
  for (size_t i = 1; i < path.size(); ++i) {
    const double step = (path[i] - path[i - 1]).norm();
    if (step >= back) return path[i - 1] + back / step * (path[i] - path[i - 1]);
    back -= step;
  }
  return path.back();
}

std::array<Eigen::Vector3d, 2> footPositionsOfSharedExtremity(const NodePath& path,
                                                              const BodyAxes& axes, double longest,
                                                              const TreeVolume& volume) {
  const Eigen::Vector3d& end = path.front();
  const NodePath shank = pathSection(path, 0.5 * kShankLow * longest, kShankLow * longest);
  const Eigen::Vector3d ankle = shank.empty() ? path.back() : shank.front();
  const std::vector<Eigen::Vector3d> feet =
      volume.near(end, kFootReach * longest, 0.5 * (ankle.z() + end.z()));
  if (feet.empty()) return {end, end};
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : feet) middle += p;
  middle /= double(feet.size());
  Eigen::Vector3d forward = middle - ankle;
  forward.z() = 0.0;
  if (forward.norm() < kMinForward * longest) forward = axes.forward;
  forward.z() = 0.0;
  forward = forward.stableNormalized();
  const Eigen::Vector3d left(-forward.y(), forward.x(), 0.0);
  std::array<Eigen::Vector3d, 2> balls{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  std::array<double, 2> toes{-1e9, -1e9}, counts{0.0, 0.0};
  for (const Eigen::Vector3d& p : feet) {
    const size_t side = left.dot(p - middle) > 0.0 ? 0 : 1;
    balls[side] += p;
    counts[side] += 1.0;
    toes[side] = std::max(toes[side], forward.dot(p));
  }
  for (size_t side = 0; side < 2; ++side) {
    if (counts[side] == 0.0) return {end, end};
    balls[side] /= counts[side];
    balls[side] += (toes[side] - kFootBack * longest - forward.dot(balls[side])) * forward;
  }
  return balls;
}

}  // namespace markerless_mocap
