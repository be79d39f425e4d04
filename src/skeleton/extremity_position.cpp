#include "skeleton/extremity_position.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

// From the surface back to the point, shares of the longest path.
constexpr double kHeadBack = 0.0513, kHandBack = 0.0344, kFootBack = 0.0355;
constexpr double kStraight = 0.06;  // metres of the path that tell how it goes on

double backOf(LimbEnd end) {
  if (end == LimbEnd::kHead) return kHeadBack;
  return end == LimbEnd::kHand1 || end == LimbEnd::kHand2 ? kHandBack : kFootBack;
}

}  // namespace

Eigen::Vector3d extremityPosition(const NodePath& path, LimbEnd end, double longest,
                                  const TreeVolume& volume) {
  const NodePath last = stretch(path, 0.0, kStraight);
  const Eigen::Vector3d out = (last.front() - last.back()).stableNormalized();
  const double surface = volume.wayOut(path.front(), out, 0.2) + 0.5 * volume.pitch();
  double back = backOf(end) * longest - surface;
  if (back <= 0.0) return path.front() - back * out;
  for (size_t i = 1; i < path.size(); ++i) {
    const double step = (path[i] - path[i - 1]).norm();
    if (step >= back) return path[i - 1] + back / step * (path[i] - path[i - 1]);
    back -= step;
  }
  return path.back();
}

std::array<Eigen::Vector3d, 2> feetTogether(const NodePath& path, const BodyAxes& axes,
                                            double longest, const TreeVolume& volume) {
  const Eigen::Vector3d& end = path.front();
  const double reach = 0.1 * longest;
  const double width = volume.wayOut(end, axes.left, reach) - volume.wayOut(end, -axes.left, reach);
  const Eigen::Vector3d middle = end + 0.5 * width * axes.left;
  const double apart = volume.wayOut(middle, axes.left, reach);
  std::array<Eigen::Vector3d, 2> balls;
  for (const int side : {0, 1}) {
    const Eigen::Vector3d sole = middle + (side == 0 ? 0.5 : -0.5) * apart * axes.left;
    const double forward = volume.wayOut(sole, axes.forward, 0.2) - kFootBack * longest;
    balls[size_t(side)] = sole + forward * axes.forward;
  }
  return balls;
}

}  // namespace markerless_mocap
