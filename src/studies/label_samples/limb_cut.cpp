#include "studies/label_samples/limb_cut.h"

#include <algorithm>
#include <array>
#include <unordered_map>

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

/// The voxels of the largest 6-connected component.
std::vector<HullVoxel> largestComponent(const VisualHull& hull) {
  std::unordered_map<uint32_t, int> component;
  for (const HullVoxel& voxel : hull.voxels) component[voxel.index] = -1;
  const uint32_t row = uint32_t(hull.lattice.size.x()),
                 layer = row * uint32_t(hull.lattice.size.y());
  std::vector<size_t> sizes;
  for (const HullVoxel& seed : hull.voxels) {
    if (component[seed.index] >= 0) continue;
    const int number = int(sizes.size());
    sizes.push_back(0);
    std::vector<uint32_t> open{seed.index};
    component[seed.index] = number;
    while (!open.empty()) {
      const uint32_t at = open.back();
      open.pop_back();
      ++sizes.back();
      for (const uint32_t step : {1u, row, layer}) {
        for (const uint32_t next : {at + step, at - step}) {
          const auto found = component.find(next);
          if (found == component.end() || found->second >= 0) continue;
          found->second = number;
          open.push_back(next);
        }
      }
    }
  }
  const auto largest = std::max_element(sizes.begin(), sizes.end()) - sizes.begin();
  std::vector<HullVoxel> kept;
  for (const HullVoxel& voxel : hull.voxels)
    if (component[voxel.index] == largest) kept.push_back(voxel);
  return kept;
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
  VisualHull out = hull;
  out.voxels.clear();
  for (const HullVoxel& voxel : hull.voxels) {
    const Eigen::Vector3d p = hull.lattice.center(voxel.index);
    const double distance = std::min(upper ? distanceTo(from, b, p) : limb.radius,
                                     distanceTo(upper ? b : from, tip, p));
    if (distance >= limb.radius) out.voxels.push_back(voxel);
  }
  out.voxels = largestComponent(out);
  return out;
}

}  // namespace markerless_mocap
