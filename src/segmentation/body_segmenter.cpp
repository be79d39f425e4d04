#include "markerless_mocap/segmentation/body_segmenter.h"

#include <algorithm>
#include <array>
#include <exception>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "markerless_mocap/segmentation/part_tracker.h"
#include "segmentation/curves/part_curve.h"
#include "segmentation/limbs/limbs.h"
#include "segmentation/limbs/part_memory.h"

namespace markerless_mocap {
namespace {

constexpr int kTorsoModes = 10;  // the first modes may belong to stumps of arms and legs
constexpr int kLimbModes = 3;
// Number of spline pieces by PartLabel: trunk and head bend once, a leg has a corner at the ankle.
constexpr std::array<int, kPartCount> kPieces{1, 1, 3, 3, 5, 5};
constexpr const char* kClosesLoop = " closes a loop: its hand touches the body";
constexpr double kMinLegRatio = 0.6;  // fraction of the other leg's voxels

std::vector<PartLabel> nodeLabels(const VoxelGraph& voxels, const Limbs& limbs) {
  std::vector<PartLabel> labels(voxels.graph.nodeCount(), PartLabel::kTorso);
  for (int part = 1; part < kPartCount; ++part) {
    for (const uint32_t node : limbs.branch[part].nodes) labels[node] = PartLabel(part);
  }
  return labels;
}

void carryOver(int64_t stamp_ns, const VoxelGraph& voxels, const Limbs& limbs, PartMemory* memory,
               std::vector<PartLabel>* labels, BodyParts* parts) {
  const auto carried = memory->carryOver(stamp_ns, voxels, limbs, labels);
  for (int part = 0; part < kPartCount; ++part) parts->parts[part].carried = carried[part];
  memory->keep(stamp_ns, voxels, limbs, *labels);
}

/// Labels of all voxels; a voxel outside the graph gets the label of the nearest node.
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

/// Coordinates of all nodes along the direction from the legs to the head; if a part is not seen,
/// from or to the torso; along the vertical if none is seen.
std::vector<double> upTheTorso(const VoxelGraph& voxels, const Limbs& limbs,
                               const std::vector<uint32_t>& torso) {
  std::vector<uint32_t> legs = limbs.branch[size_t(PartLabel::kLeg1)].nodes;
  const std::vector<uint32_t>& other = limbs.branch[size_t(PartLabel::kLeg2)].nodes;
  legs.insert(legs.end(), other.begin(), other.end());
  const std::vector<uint32_t>& head = limbs.branch[size_t(PartLabel::kHead)].nodes;
  const Eigen::Vector3d up = head.empty() && legs.empty()
                                 ? Eigen::Vector3d::UnitZ()
                                 : Eigen::Vector3d(meanCenter(voxels, head.empty() ? torso : head) -
                                                   meanCenter(voxels, legs.empty() ? torso : legs));
  std::vector<double> along;
  for (const Eigen::Vector3d& center : voxels.centers) along.push_back(center.dot(up));
  return along;
}

void fitCurves(const VoxelGraph& voxels, const Limbs& limbs, const std::vector<PartLabel>& labels,
               int site_modes, BodyParts* parts) {
  std::vector<uint32_t> torso;
  for (uint32_t node = 0; node < labels.size(); ++node) {
    if (labels[node] == PartLabel::kTorso) torso.push_back(node);
  }
  if (!torso.empty()) {
    parts->parts[0] = fitPartCurve(voxels, torso, upTheTorso(voxels, limbs, torso),
                                   site_modes > 0 ? site_modes : kTorsoModes, kPieces[0]);
    parts->parts[0].whole = parts->parts[0].seen;
  }
  for (int part = 1; part < kPartCount; ++part) {
    if (!limbs.has(PartLabel(part))) continue;
    std::vector<double> ahead = limbs.geodesic[part];
    for (double& geodesic : ahead) geodesic = -geodesic;
    parts->parts[part] = fitPartCurve(voxels, limbs.branch[part].nodes, ahead,
                                      site_modes > 0 ? site_modes : kLimbModes, kPieces[part]);
    parts->parts[part].whole = parts->parts[part].seen && limbs.whole[part];
  }
}

/// The reason why the hull cannot be a person, or an empty string.
std::string hullError(const VisualHull& hull, const SegmentationOptions& options) {
  if (hull.voxels.empty()) {
    return hull.reason.empty() ? "the hull is empty" : "the hull is empty: " + hull.reason;
  }
  for (const HullVoxel& voxel : hull.voxels) {
    if (voxel.index >= hull.lattice.count()) return "a voxel lies outside the hull's lattice";
  }
  std::ostringstream reason;
  const double litres = hull.litres();
  if (litres >= options.min_litres && litres <= options.max_litres) return "";
  reason.precision(3);
  reason << "the hull has " << litres << " litres, a person " << options.min_litres << " to "
         << options.max_litres;
  return reason.str();
}

/// Names of the parts for which `answer` returns false.
template <class Answer>
std::string partsWithout(const BodyParts& parts, const Answer& answer) {
  std::string names;
  for (int part = 0; part < kPartCount; ++part) {
    if (answer(parts.parts[part])) continue;
    names += (names.empty() ? "" : ", ") + std::string(toString(PartLabel(part)));
  }
  return names;
}

/// Whether there are a torso, a head, a leg and one more limb. Fewer parts are not recognised as a
/// body.
bool isBody(const BodyParts& parts) {
  const auto seen = [&](PartLabel label) { return parts.part(label).seen; };
  const int legs = seen(PartLabel::kLeg1) + seen(PartLabel::kLeg2);
  const int arms = seen(PartLabel::kArm1) + seen(PartLabel::kArm2);
  return seen(PartLabel::kTorso) && seen(PartLabel::kHead) && legs >= 1 && legs + arms >= 2;
}

/// Whether legs that touch are divided equally. If not, one leg contains voxels of the other, of a
/// skirt or of the trunk.
bool areLegsAlike(const BodyParts& parts) {
  const auto [less, more] = std::minmax(parts.part(PartLabel::kLeg1).voxel_count,
                                        parts.part(PartLabel::kLeg2).voxel_count);
  return double(less) >= kMinLegRatio * double(more);
}

/// Text that names the arms that close a loop, after a semicolon; empty if there are none.
std::string loopsIn(const Limbs& limbs) {
  std::string sentence;
  for (int part = 1; part < kPartCount; ++part)
    if (limbs.loop[part]) sentence += "; " + std::string(toString(PartLabel(part))) + kClosesLoop;
  if (limbs.unnamed_loops > 0) sentence += std::string("; an arm") + kClosesLoop;
  return sentence;
}

void setStatus(const Limbs& limbs, double max_cost, BodyParts* result) {
  const std::string missing = partsWithout(*result, [](const PartCurve& p) { return p.seen; });
  const std::string merged =
      partsWithout(*result, [](const PartCurve& p) { return p.whole || !p.seen; });
  const bool arms_whole =
      result->part(PartLabel::kArm1).whole && result->part(PartLabel::kArm2).whole;
  const std::string carried = partsWithout(*result, [](const PartCurve& p) { return !p.carried; });
  std::ostringstream reason;
  reason.precision(3);
  if (!isBody(*result)) {
    reason << "no body is recognised: " << missing << " not seen";
  } else if (limbs.cost > max_cost) {
    reason << "the hull's branches do not fit a body (cost " << limbs.cost << ", allowed "
           << max_cost << ")";
  } else if (missing.empty() && arms_whole && areLegsAlike(*result)) {
    result->status = SegmentationStatus::kOk;
  } else {
    result->status = SegmentationStatus::kPartial;
    if (!missing.empty()) reason << missing << " not seen";
    if (!merged.empty()) reason << (missing.empty() ? "" : "; ") << merged << " merged with others";
    if (missing.empty() && merged.empty()) reason << "the legs differ in size";
    reason << loopsIn(limbs);
  }
  if (!carried.empty()) reason << "; " << carried << " carried over from the frames before";
  result->reason = reason.str();
}

}  // namespace

BodySegmenter::BodySegmenter(const SegmentationOptions& options) : options_(options) {
  options_.validate();
}

BodyParts BodySegmenter::segment(const VisualHull& hull) const {
  return segment(hull, 0, nullptr);
}

BodyParts BodySegmenter::segment(const VisualHull& hull, int64_t stamp_ns,
                                 PartTracker* tracker) const {
  PartMemory* memory = tracker ? tracker->memory_.get() : nullptr;
  BodyParts result;
  result.labels.assign(hull.voxels.size(), uint8_t(PartLabel::kTorso));
  result.reason = hullError(hull, options_);
  if (!result.reason.empty()) return result;
  const VoxelGraph voxels = buildVoxelGraph(hull, edgeWeightsOf(options_));
  try {
    Limbs limbs = findLimbs(voxels, options_);
    if (memory) memory->number(stamp_ns, voxels, &limbs);
    std::vector<PartLabel> labels = nodeLabels(voxels, limbs);
    if (memory) carryOver(stamp_ns, voxels, limbs, memory, &labels, &result);
    result.labels = voxelLabels(hull, voxels, labels);
    fitCurves(voxels, limbs, labels, options_.site_modes, &result);
    setStatus(limbs, options_.max_cost, &result);
  } catch (const std::runtime_error& error) {
    result.reason = error.what();
  }
  return result;
}

}  // namespace markerless_mocap
