#include "markerless_mocap/segmentation/body_segmenter.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "markerless_mocap/segmentation/branch_naming.h"
#include "markerless_mocap/segmentation/merge_tree.h"
#include "markerless_mocap/segmentation/part_curve.h"
#include "markerless_mocap/segmentation/spline_walk.h"

namespace markerless_mocap {
namespace {

constexpr int kBranches = 5;
constexpr double kCoreShare = 0.85;    // of the greatest depth under the surface
constexpr double kBranchShare = 0.12;  // of a tip's height: where a branch ends at the latest
constexpr double kLegShare = 0.15;     // legs that touch are parted down to here
constexpr int kTorsoModes = 3;         // a torso's lowest mode may run from side to side

struct Segments {
  std::vector<Branch> branches;
  BranchMeasures measures;
  BranchNames names;
};

int branchOf(const Segments& segments, PartLabel label) {
  return segments.names.branch[size_t(label)];
}

Segments findSegments(const VoxelGraph& voxels, const SegmentationOptions& options) {
  const Eigenmap map = laplacianEigenmap(voxels.graph, options.modes);
  const std::vector<uint32_t> core = coreNodes(voxels.depth, kCoreShare);
  Segments segments;
  std::vector<double> height;
  const bool merge_tree = options.branch_method == "merge_tree";
  if (merge_tree) {
    height = distanceFromCore(map, core);
    segments.branches = mergeTreeBranches(voxels.graph, height, kBranches, kBranchShare);
  } else {
    segments.branches = splineWalkBranches(map, kBranches);
  }
  segments.measures = measureBranches(voxels, segments.branches, core);
  segments.names = nameBranches(segments.measures);
  if (!merge_tree) return segments;
  std::vector<int> legs;
  for (const PartLabel leg : {PartLabel::kLeg1, PartLabel::kLeg2}) {
    if (branchOf(segments, leg) >= 0) legs.push_back(branchOf(segments, leg));
  }
  growBranches(voxels.graph, height, legs, kLegShare, &segments.branches);
  return segments;
}

std::vector<PartLabel> nodeLabels(const VoxelGraph& voxels, const Segments& segments) {
  std::vector<PartLabel> labels(voxels.graph.nodeCount(), PartLabel::kTorso);
  for (int part = 1; part < kPartCount; ++part) {
    const int branch = segments.names.branch[part];
    if (branch < 0) continue;
    for (const uint32_t node : segments.branches[branch].nodes) labels[node] = PartLabel(part);
  }
  return labels;
}

/// Voxels outside the graph get the label of the node nearest to them.
std::vector<uint8_t> voxelLabels(const VisualHull& hull, const VoxelGraph& voxels,
                                 const std::vector<PartLabel>& node_labels) {
  std::vector<uint8_t> labels(hull.voxels.size());
  for (size_t node = 0; node < node_labels.size(); ++node) {
    labels[voxels.hull_voxel[node]] = uint8_t(node_labels[node]);
  }
  for (const uint32_t v : voxels.left_out) {
    const Eigen::Vector3d at = hull.lattice.center(hull.voxels[v].index);
    double nearest = std::numeric_limits<double>::infinity();
    for (size_t node = 0; node < node_labels.size(); ++node) {
      const double distance = (voxels.centers[node] - at).squaredNorm();
      if (distance >= nearest) continue;
      nearest = distance;
      labels[v] = uint8_t(node_labels[node]);
    }
  }
  return labels;
}

Eigen::Vector3d meanCenter(const VoxelGraph& voxels, const std::vector<uint32_t>& nodes) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const uint32_t node : nodes) mean += voxels.centers[node];
  return mean / double(nodes.size());
}

/// Heights of all nodes along the direction from the legs to the head, as far as both are seen.
std::vector<double> upTheTorso(const VoxelGraph& voxels, const Segments& segments,
                               const std::vector<uint32_t>& torso) {
  Eigen::Vector3d low = meanCenter(voxels, torso);
  Eigen::Vector3d high = low;
  if (const int head = branchOf(segments, PartLabel::kHead); head >= 0) {
    high = meanCenter(voxels, segments.branches[head].nodes);
  }
  std::vector<uint32_t> legs;
  for (const PartLabel leg : {PartLabel::kLeg1, PartLabel::kLeg2}) {
    if (branchOf(segments, leg) < 0) continue;
    const std::vector<uint32_t>& nodes = segments.branches[branchOf(segments, leg)].nodes;
    legs.insert(legs.end(), nodes.begin(), nodes.end());
  }
  if (!legs.empty()) low = meanCenter(voxels, legs);
  std::vector<double> along;
  for (const Eigen::Vector3d& center : voxels.centers) along.push_back(center.dot(high - low));
  return along;
}

void fitCurves(const VoxelGraph& voxels, const Segments& segments,
               const std::vector<PartLabel>& labels, BodyParts* parts) {
  std::array<std::vector<uint32_t>, kPartCount> nodes;
  for (uint32_t node = 0; node < labels.size(); ++node) nodes[size_t(labels[node])].push_back(node);
  if (!nodes[0].empty()) {
    parts->parts[0] =
        fitPartCurve(voxels, nodes[0], upTheTorso(voxels, segments, nodes[0]), kTorsoModes);
  }
  for (int part = 1; part < kPartCount; ++part) {
    if (segments.names.branch[part] < 0) continue;
    std::vector<double> ahead = segments.measures.from_tip[segments.names.branch[part]];
    for (double& way : ahead) way = -way;
    parts->parts[part] = fitPartCurve(voxels, nodes[part], ahead, 1);
  }
}

/// Why the hull cannot be a person, or nothing.
std::string hullFault(const VisualHull& hull, const SegmentationOptions& options) {
  if (hull.voxels.empty()) {
    return hull.reason.empty() ? "the hull is empty" : "the hull is empty: " + hull.reason;
  }
  for (const HullVoxel& voxel : hull.voxels) {
    if (voxel.index >= hull.lattice.count()) return "a voxel lies outside the hull's lattice";
  }
  std::ostringstream reason;
  const double litres = hull.litres();
  if (litres >= options.least_litres && litres <= options.most_litres) return "";
  reason.precision(3);
  reason << "the hull has " << litres << " litres, a person " << options.least_litres << " to "
         << options.most_litres;
  return reason.str();
}

void judge(double cost, double highest_cost, BodyParts* result) {
  std::string missing;
  int limbs = 0;
  for (int part = 0; part < kPartCount; ++part) {
    if (result->parts[part].seen) {
      ++limbs;
      continue;
    }
    missing += (missing.empty() ? "" : ", ") + std::string(toString(PartLabel(part)));
  }
  const bool upright = result->part(PartLabel::kTorso).seen &&
                       result->part(PartLabel::kLeg1).seen && result->part(PartLabel::kLeg2).seen &&
                       result->part(PartLabel::kHead).seen;
  std::ostringstream odd;
  odd.precision(3);
  odd << "the hull's branches do not fit a body (cost " << cost << ", allowed " << highest_cost
      << ")";
  if (!upright || cost > highest_cost) {
    result->status = SegmentationStatus::kInvalid;
    result->reason = upright ? odd.str() : "no body is recognised: " + missing + " not seen";
  } else {
    result->status = missing.empty() ? SegmentationStatus::kOk : SegmentationStatus::kPartial;
    if (!missing.empty()) result->reason = missing + " not seen";
  }
}

}  // namespace

void SegmentationOptions::visit(OptionVisitor& v) {
  v.field("branch_method", branch_method, {"merge_tree", "spline_walk"},
          "how limbs are found in the eigenmap: by the maxima of the distance from the core, or by "
          "splines that walk inwards from the tips");
  v.field("modes", modes, 3, 20, "dimensions of the eigenmap; spline_walk works best with 6");
  v.field("use_color_votes", use_color_votes,
          "weight edges by the cameras' votes that neighbours have the same colour");
  v.field("shrink_weight", shrink_weight, 0.0, 1000.0,
          "weight added to the edges in the body's thick core; draws the torso together");
  v.field("highest_cost", highest_cost, 0.1, 9.0,
          "mean squared z-score of the limbs' measures above which a hull is no person");
  v.field("least_litres", least_litres, 0.0, 1000.0, "volume of the smallest person, litres");
  v.field("most_litres", most_litres, 0.0, 1000.0,
          "volume of the largest hull of a person, litres");
}

void SegmentationOptions::validate() const {
  checkFields(*this);
  if (least_litres >= most_litres) {
    throw std::invalid_argument(std::string(kStage) +
                                ": least_litres must be less than most_litres");
  }
}

BodySegmenter::BodySegmenter(const SegmentationOptions& options) : options_(options) {
  options_.validate();
}

BodyParts BodySegmenter::segment(const VisualHull& hull) const {
  BodyParts result;
  result.labels.assign(hull.voxels.size(), uint8_t(PartLabel::kTorso));
  result.reason = hullFault(hull, options_);
  if (!result.reason.empty()) return result;
  const VoxelGraph voxels = buildVoxelGraph(hull, options_.use_color_votes, options_.shrink_weight);
  try {
    const Segments segments = findSegments(voxels, options_);
    const std::vector<PartLabel> labels = nodeLabels(voxels, segments);
    result.labels = voxelLabels(hull, voxels, labels);
    fitCurves(voxels, segments, labels, &result);
    judge(segments.names.cost, options_.highest_cost, &result);
  } catch (const std::runtime_error& error) {
    result.reason = error.what();
  }
  return result;
}

}  // namespace markerless_mocap
