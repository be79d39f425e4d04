#include "markerless_mocap/segmentation/limbs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "markerless_mocap/segmentation/eigenmap.h"
#include "markerless_mocap/segmentation/merge_tree.h"
#include "markerless_mocap/segmentation/spline_walk.h"
#include "markerless_mocap/segmentation/tip_measures.h"
#include "markerless_mocap/segmentation/tip_naming.h"

namespace markerless_mocap {
namespace {

constexpr int kMergeTreeModes = 10;
constexpr int kSplineWalkModes = 6;
constexpr double kResidual = 0.05;  // of the modes: moves one voxel in ten thousand
constexpr int kLimbs = 5;
constexpr int kCandidates = 7;         // tips to name; fused hands and elbows leave small ones
constexpr double kCoreShare = 0.85;    // of the greatest depth under the surface
constexpr double kBranchShare = 0.12;  // of a tip's height: where a branch ends at the latest
constexpr double kLegShare = 0.15;     // legs that touch are parted down to here
constexpr double kSameLimb = 0.6;    // way between two tips of one limb, at most, in the same unit
constexpr double kHeadReach = 0.80;  // head and neck, in cube roots of the hull's volume
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
  }
  return limbs;
}

Limbs walkLimbs(const VoxelGraph& voxels, const Eigenmap& map, const std::vector<uint32_t>& core) {
  const std::vector<Branch> branches = splineWalkBranches(map, kLimbs);
  const std::vector<uint32_t> tips = tipsOf(branches);
  const TipMeasures measures = measureTips(voxels, tips, core);
  return sortByPart(namesInOrder(voxels, measures, tips), measures, branches);
}

/// The tips that bound branches: the named ones, and of the five most persistent those that
/// are not part of a named tip's own limb. An arm that touches the body may go without a name, but
/// no leg shall take it in.
std::vector<int> boundingTips(const TipNames& names, const TipMeasures& measures) {
  std::vector<int> bounding;
  for (int part = 1; part < kPartCount; ++part) {
    if (names.tip[part] >= 0) bounding.push_back(names.tip[part]);
  }
  const size_t named = bounding.size();
  for (int tip = 0; tip < std::min(kLimbs, int(measures.to_core.size())); ++tip) {
    const bool apart = std::all_of(bounding.begin(), bounding.begin() + named, [&](int other) {
      return other != tip && measures.distance(tip, other) > std::log(kSameLimb);
    });
    if (apart) bounding.push_back(tip);
  }
  return bounding;
}

Limbs mergeTreeLimbs(const VoxelGraph& voxels, const Eigenmap& map,
                     const std::vector<uint32_t>& core) {
  const Elevation height = distanceFromCore(map, core);
  const std::vector<uint32_t> tips = persistentMaxima(voxels.graph, height, kCandidates);
  const TipMeasures measures = measureTips(voxels, tips, core);
  const TipNames names = namesInOrder(voxels, measures, tips);
  const std::vector<int> bounding = boundingTips(names, measures);
  std::vector<uint32_t> bounding_nodes;
  std::vector<int> legs;
  for (const int tip : bounding) {
    const bool leg =
        tip == names.tip[size_t(PartLabel::kLeg1)] || tip == names.tip[size_t(PartLabel::kLeg2)];
    if (leg) legs.push_back(int(bounding_nodes.size()));
    bounding_nodes.push_back(tips[tip]);
  }
  std::vector<Branch> found = branchesAtTips(voxels.graph, height, bounding_nodes, kBranchShare);
  growBranches(voxels.graph, height, legs, kLegShare, &found);
  std::vector<Branch> branches(tips.size());
  for (size_t i = 0; i < found.size(); ++i) branches[bounding[i]] = std::move(found[i]);
  return sortByPart(names, measures, branches);
}

/// Where a fused arm draws the core down, the head's branch would take in the chest.
void cutHead(Limbs* limbs) {
  std::vector<uint32_t>& nodes = limbs->branch[size_t(PartLabel::kHead)].nodes;
  const std::vector<double>& way = limbs->way[size_t(PartLabel::kHead)];
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(),
                             [&](uint32_t node) { return way[node] > kHeadReach; }),
              nodes.end());
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
  const bool merge_tree = options.branch_method == "merge_tree";
  const int best_modes = merge_tree ? kMergeTreeModes : kSplineWalkModes;
  const Eigenmap map =
      laplacianEigenmap(voxels.graph, options.modes > 0 ? options.modes : best_modes, kResidual);
  const std::vector<uint32_t> core = coreNodes(voxels.depth, kCoreShare);
  Limbs limbs = merge_tree ? mergeTreeLimbs(voxels, map, core) : walkLimbs(voxels, map, core);
  cutHead(&limbs);
  dropImplausible(voxels, &limbs);
  return limbs;
}

}  // namespace markerless_mocap
