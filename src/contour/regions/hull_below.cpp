#include "contour/regions/hull_below.h"

#include <algorithm>
#include <limits>

namespace markerless_mocap {
namespace {

constexpr double kNear = 0.35;  // metres from the pelvis, horizontally

double lowestOf(const ContourBody& body, const ContourPose& pose) {
  ContourFrames frames;
  ContourWorldCones cones;
  body.place(pose, frames);
  body.place(frames, cones);
  double lowest = std::numeric_limits<double>::infinity();
  for (const ContourWorldCone& cone : cones)
    lowest = std::min({lowest, cone.a.z() - cone.radius_a, cone.b.z() - cone.radius_b});
  return lowest;
}

}  // namespace

double hullBelow(const VisualHull& hull, const ContourBody& body, const ContourPose& pose) {
  const double body_lowest = lowestOf(body, pose);
  double lowest = body_lowest;
  for (const HullVoxel& voxel : hull.voxels) {
    const Eigen::Vector3d at = hull.lattice.center(voxel.index);
    if ((at - pose.position).head<2>().norm() < kNear) lowest = std::min(lowest, at.z());
  }
  return body_lowest - lowest;
}

}  // namespace markerless_mocap
