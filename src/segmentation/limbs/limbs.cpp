#include "segmentation/limbs/limbs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "segmentation/eigenmap.h"
#include "segmentation/spline_walk.h"
#include "segmentation/limbs/tip_measures.h"
#include "segmentation/limbs/tip_naming.h"
#include "segmentation/limbs/limb_borders.h"
#include "segmentation/limbs/loops.h"
#include "segmentation/limbs/tip_search.h"
#include "segmentation/limbs/upper_arms.h"

namespace markerless_mocap {
namespace {

constexpr int kMergeTreeModes = 10;
constexpr int kSplineWalkModes = 6;
constexpr double kResidual = 0.05;  // of the spline walk's modes
constexpr int kLimbs = 5;
constexpr int kCandidates = 7;       // tips to name; fused hands and elbows leave small ones
constexpr double kCoreShare = 0.85;  // of the greatest depth under the surface
const Eigen::Vector3d kSlant(0.618, 0.354, 1.0);  // no two near voxels lie equally far along it

std::vector<uint32_t> tipsOf(const std::vector<Branch>& branches) {
  std::vector<uint32_t> tips;
  for (const Branch& branch : branches) tips.push_back(branch.tip);
  return tips;
}

/// Names the arm (leg) with the higher tip first. Persistences would tell the two apart by a hair.
TipNames namesInOrder(const VoxelGraph& voxels, const TipMeasures& measures,
                      const std::vector<uint32_t>& tips) {
  TipNames names = nameTips(measures);
  const auto height = [&](int tip) { return voxels.centers[tips[tip]].dot(kSlant); };
  const auto order = [&](PartLabel first, PartLabel second) {
    int& one = names.tip[size_t(first)];
    int& other = names.tip[size_t(second)];
    if (other >= 0 && height(other) > height(one)) std::swap(one, other);
  };
  order(PartLabel::kArm1, PartLabel::kArm2);
  order(PartLabel::kLeg1, PartLabel::kLeg2);
  return names;
}

/// Takes each named branch to its part.
Limbs sortByPart(const TipNames& names, const TipMeasures& measures,
                 const std::vector<Branch>& branches) {
  Limbs limbs;
  limbs.cost = names.cost;
  for (int part = 1; part < kPartCount; ++part) {
    const int tip = names.tip[part];
    if (tip < 0) continue;
    limbs.branch[part] = branches[tip];
    limbs.way[part] = measures.way[tip];
    limbs.whole[part] = true;
  }
  return limbs;
}

Limbs walkLimbs(const VoxelGraph& voxels, const std::vector<uint32_t>& core, int modes,
                WalkStop stop) {
  const Eigenmap map = laplacianEigenmap(voxels.graph, modes, kResidual);
  const std::vector<Branch> branches = splineWalkBranches(map, stop, kLimbs);
  const std::vector<uint32_t> tips = tipsOf(branches);
  const TipMeasures measures = measureTips(voxels, tips, core);
  return sortByPart(namesInOrder(voxels, measures, tips), measures, branches);
}

/// An arm that closes a loop has no end; one part of it, or the other arm, may have its name.
void findLoops(const VoxelGraph& voxels, const TipMeasures& measures, const TipNames& names,
               Limbs* limbs) {
  NodeGrid::Region region(voxels.grid);
  for (int tip = 0; tip < int(measures.way.size()); ++tip) {
    const auto named = std::find(names.tip.begin(), names.tip.end(), tip);
    const auto part = size_t(named - names.tip.begin());
    const bool arm = part == size_t(PartLabel::kArm1) || part == size_t(PartLabel::kArm2);
    if ((named != names.tip.end() && !arm) || !closesLoop(measures.way[tip], &region)) continue;
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
    if (!limbs.way[part].empty()) border[part] = limbBorder(PartLabel(part), limbs.way[part]);
  }
  if (limbs.way[size_t(PartLabel::kHead)].empty()) return border;
  const uint32_t head = limbs.branch[size_t(PartLabel::kHead)].tip;
  for (const PartLabel leg : {PartLabel::kLeg1, PartLabel::kLeg2}) {
    const std::vector<double>& way = limbs.way[size_t(leg)];
    double& end = border[size_t(leg)];
    if (!way.empty()) end = legBorder(end, way[head]);
  }
  return border;
}

Limbs mergeTreeLimbs(const VoxelGraph& voxels, const std::vector<uint32_t>& core, int modes) {
  const std::vector<uint32_t> tips = findTips(voxels, core, modes, kCandidates);
  const TipMeasures measures = measureTips(voxels, tips, core);
  std::vector<Branch> branches;
  for (const uint32_t tip : tips) branches.push_back({tip, {}});
  const TipNames names = namesInOrder(voxels, measures, tips);
  Limbs limbs = sortByPart(names, measures, branches);
  const std::array<double, kPartCount> border = bordersOf(limbs);
  auto nodes = nodesOfLimbs(limbs.way, border);
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
  const std::vector<uint32_t> core = coreNodes(voxels.depth, kCoreShare);
  const auto modes = [&](int best) { return options.modes > 0 ? options.modes : best; };
  const bool merge_tree = options.branch_method == "merge_tree";
  Limbs limbs = merge_tree ? mergeTreeLimbs(voxels, core, modes(kMergeTreeModes))
                           : walkLimbs(voxels, core, modes(kSplineWalkModes),
                                       options.walk_stop == "outliers" ? WalkStop::kOutliers
                                                                       : WalkStop::kOrigin);
  dropImplausible(voxels, &limbs);
  if (merge_tree) addUpperArms(voxels, &limbs);
  return limbs;
}

}  // namespace markerless_mocap
