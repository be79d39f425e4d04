#include "studies/label_samples/limb_cut.h"

#include <algorithm>
#include <array>

#include "numerics/face_parts.h"
#include "numerics/segment.h"

namespace markerless_mocap {
namespace {

struct Limb {
  double fraction;  ///< cumulative probability
  std::array<const char*, 3> path;
  double radius;  ///< metres
};

constexpr Limb kLimbs[] = {{0.35, {"l_elbow", "l_wrist", "l_hand_tip"}, 0.07},
                           {0.70, {"r_elbow", "r_wrist", "r_hand_tip"}, 0.07},
                           {0.80, {"l_knee", "l_ankle", "l_foot_tip"}, 0.10},
                           {0.90, {"r_knee", "r_ankle", "r_foot_tip"}, 0.10},
                           {1.00, {"thorax", "head", "head_top"}, 0.15}};

double distanceTo(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& p) {
  const Eigen::Vector3d step = b - a;
  return (a + nearestFraction(p, a, step) * step - p).norm();
}

}  // namespace

VisualHull withLimbCut(const VisualHull& hull, const std::vector<std::string>& names,
                       const std::vector<Eigen::Vector3d>& points, std::mt19937* random) {
  const auto draw = [&] { return double((*random)()) / 4294967296.0; };
  const auto at = [&](const char* name) {
    return points[size_t(std::find(names.begin(), names.end(), name) - names.begin())];
  };
  const double which = draw(), place = 2.0 * draw();
  const Limb& limb = *std::find_if(std::begin(kLimbs), std::end(kLimbs),
                                   [&](const Limb& l) { return which < l.fraction; });
  const Eigen::Vector3d a = at(limb.path[0]), b = at(limb.path[1]), tip = at(limb.path[2]);
  const bool upper = place < 1.0;
  const Eigen::Vector3d from = upper ? a + place * (b - a) : b + (place - 1.0) * (tip - b);
  std::vector<HullVoxel> left;
  std::vector<Eigen::Vector3i> cells;
  for (const HullVoxel& voxel : hull.voxels) {
    const Eigen::Vector3d p = hull.lattice.center(voxel.index);
    const double distance = std::min(upper ? distanceTo(from, b, p) : limb.radius,
                                     distanceTo(upper ? b : from, tip, p));
    if (distance < limb.radius) continue;
    left.push_back(voxel);
    cells.push_back(hull.lattice.coordinates(voxel.index));
  }
  VisualHull out = hull;
  out.voxels.clear();
  for (const size_t kept : largestFacePart(cells)) out.voxels.push_back(left[kept]);
  return out;
}

}  // namespace markerless_mocap
