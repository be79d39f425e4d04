#include "segmentation/limbs/limbs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "segmentation/eigenmap.h"
#include "segmentation/limbs/extremity_measures.h"
#include "segmentation/limbs/extremity_search.h"
#include "segmentation/limbs/limb_borders.h"
#include "segmentation/limbs/loops.h"
#include "segmentation/limbs/part_naming.h"
#include "segmentation/limbs/upper_arms.h"
#include "segmentation/spline_propagation.h"

namespace markerless_mocap {
namespace {

constexpr int kMergeTreeModes = 10;
constexpr int kSplineWalkModes = 6;
constexpr double kResidual = 0.05;  // of the modes for spline propagation
constexpr int kLimbs = 5;
/// Extremities to assign; hands that touch, and elbows, give small ones.
constexpr int kCandidates = 7;
constexpr double kCoreFraction = 0.85;  // of the maximum depth under the surface
const Eigen::Vector3d kSlant(0.618, 0.354,
                             1.0);  // no two nearby voxels have the same coordinate along it

std::vector<uint32_t> extremitiesOf(const std::vector<Branch>& branches) {
  std::vector<uint32_t> extremities;
  for (const Branch& branch : branches) extremities.push_back(branch.extremity);
  return extremities;
}

/// Assigns the extremities in a fixed order of positions. The order by persistence would be
/// unstable.
PartNaming namesInOrder(const VoxelGraph& voxels, const ExtremityMeasures& measures,
                        const std::vector<uint32_t>& extremities) {
  PartNaming names = assignParts(measures);
  const auto height = [&](int extremity) {
    return voxels.centers[extremities[extremity]].dot(kSlant);
  };
  const auto order = [&](PartLabel first, PartLabel second) {
    int& one = names.extremity[size_t(first)];
    int& other = names.extremity[size_t(second)];
    if (other >= 0 && height(other) > height(one)) std::swap(one, other);
  };
  order(PartLabel::kArm1, PartLabel::kArm2);
  order(PartLabel::kLeg1, PartLabel::kLeg2);
  return names;
}

/// Sorts the assigned branches by part.
Limbs sortByPart(const PartNaming& names, const ExtremityMeasures& measures,
                 const std::vector<Branch>& branches) {
  Limbs limbs;
  limbs.cost = names.cost;
  for (int part = 1; part < kPartCount; ++part) {
    const int extremity = names.extremity[part];
    if (extremity < 0) continue;
    limbs.branch[part] = branches[extremity];
    limbs.geodesic[part] = measures.geodesic[extremity];
    limbs.whole[part] = true;
  }
  return limbs;
}

Limbs splineLimbs(const VoxelGraph& voxels, const std::vector<uint32_t>& core, int modes,
                  SplineTermination stop, const SplineWalkOptions& options) {
  const Eigenmap map = laplacianEigenmap(voxels.graph, modes, kResidual);
  const std::vector<Branch> branches = splinePropagationBranches(map, stop, kLimbs, options);
  const std::vector<uint32_t> extremities = extremitiesOf(branches);
  const ExtremityMeasures measures = measureExtremities(voxels, extremities, core);
  return sortByPart(namesInOrder(voxels, measures, extremities), measures, branches);
}

/// An arm that closes a loop has no extremity; a section of it, or the other arm, may have its
/// label.
void findLoops(const VoxelGraph& voxels, const ExtremityMeasures& measures, const PartNaming& names,
               Limbs* limbs) {
  NodeGrid::Region region(voxels.grid);
  for (int extremity = 0; extremity < int(measures.geodesic.size()); ++extremity) {
    const auto named = std::find(names.extremity.begin(), names.extremity.end(), extremity);
    const auto part = size_t(named - names.extremity.begin());
    const bool arm = part == size_t(PartLabel::kArm1) || part == size_t(PartLabel::kArm2);
    if ((named != names.extremity.end() && !arm) ||
        !closesLoop(measures.geodesic[extremity], &region))
      continue;
    if (!arm) {
      ++limbs->unnamed_loops;
      continue;
    }
    limbs->loop[part] = true;
    limbs->whole[part] = false;
  }
}

std::array<double, kPartCount> bordersOf(const Limbs& limbs) {
  std::array<double, kPartCount> border{};
  for (int part = 1; part < kPartCount; ++part) {
    if (!limbs.geodesic[part].empty())
      border[part] = limbBorder(PartLabel(part), limbs.geodesic[part]);
  }
  if (limbs.geodesic[size_t(PartLabel::kHead)].empty()) return border;
  const uint32_t head = limbs.branch[size_t(PartLabel::kHead)].extremity;
  for (const PartLabel leg : {PartLabel::kLeg1, PartLabel::kLeg2}) {
    const std::vector<double>& geodesic = limbs.geodesic[size_t(leg)];
    double& end = border[size_t(leg)];
    if (!geodesic.empty()) end = legBorder(end, geodesic[head]);
  }
  return border;
}

Limbs mergeTreeLimbs(const VoxelGraph& voxels, const std::vector<uint32_t>& core, int modes) {
  const std::vector<uint32_t> extremities = findExtremities(voxels, core, modes, kCandidates);
  const ExtremityMeasures measures = measureExtremities(voxels, extremities, core);
  std::vector<Branch> branches;
  for (const uint32_t extremity : extremities) branches.push_back({extremity, {}});
  const PartNaming names = namesInOrder(voxels, measures, extremities);
  Limbs limbs = sortByPart(names, measures, branches);
  const std::array<double, kPartCount> border = bordersOf(limbs);
  auto nodes = nodesOfLimbs(limbs.geodesic, border);
  const auto all = double(voxels.graph.nodeCount());
  for (int part = 1; part < kPartCount; ++part) {
    limbs.whole[part] =
        isWholeLimb(PartLabel(part), border[part], double(nodes[part].size()) / all);
    limbs.branch[part].nodes = std::move(nodes[part]);
  }
  findLoops(voxels, measures, names, &limbs);
  return limbs;
}

void dropImplausible(const VoxelGraph& voxels, Limbs* limbs) {
  const auto all = double(voxels.graph.nodeCount());
  for (int part = 1; part < kPartCount; ++part) {
    std::vector<uint32_t>& nodes = limbs->branch[part].nodes;
    if (nodes.empty()) continue;
    double depth = 0.0;
    for (const uint32_t node : nodes) depth += voxels.depth[node];
    const double thickness = depth / double(nodes.size()) / (voxels.pitch * std::cbrt(all));
    if (!isPlausible(PartLabel(part), double(nodes.size()) / all, thickness)) nodes.clear();
  }
}

}  // namespace

Limbs findLimbs(const VoxelGraph& voxels, const SegmentationOptions& options) {
  const std::vector<uint32_t> core = coreNodes(voxels.depth, kCoreFraction);
  const auto modes = [&](int best) { return options.modes > 0 ? options.modes : best; };
  const bool merge_tree = options.branch_method == "merge_tree";
  Limbs limbs = merge_tree
                    ? mergeTreeLimbs(voxels, core, modes(kMergeTreeModes))
                    : splineLimbs(voxels, core, modes(kSplineWalkModes),
                                  options.walk_stop == "outliers" ? SplineTermination::kOutliers
                                                                  : SplineTermination::kOrigin,
                                  options.spline_walk);
  dropImplausible(voxels, &limbs);
  if (merge_tree) addUpperArms(voxels, &limbs);
  return limbs;
}

}  // namespace markerless_mocap
