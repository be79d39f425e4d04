#include "skeleton/labelling/validity_features.h"

#include <algorithm>
#include <cmath>

#include "skeleton/labelling/label_proportions.h"

namespace markerless_mocap {
namespace {

constexpr double kMinOdds = 1e-6;  // limit on the probability of the extremities' labels
constexpr double kShankLow = 0.10,
                 kShankHigh = 0.25;  // fractions of the longest path, from the extremity
constexpr double kTip = 0.05;        // fraction of the longest path

double lengthOf(const NodePath& path) {
  double length = 0.0;
  for (size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).norm();
  return length;
}

double cosine(const Eigen::Vector3d& unit, const Eigen::Vector3d& path_length) {
  return unit.dot(path_length.stableNormalized());
}

Eigen::Vector3d upperMiddle(const NodePath& path) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const size_t first = path.size() / 2;
  for (size_t i = first; i < path.size(); ++i) sum += path[i];
  return sum / double(path.size() - first);
}

double distanceTo(const NodePath& path, const Eigen::Vector3d& point) {
  double nearest = (path.front() - point).squaredNorm();
  for (const Eigen::Vector3d& p : path) nearest = std::min(nearest, (p - point).squaredNorm());
  return std::sqrt(nearest);
}

double meanThickness(const NodePath& path, const TreeVolume& volume) {
  double sum = 0.0;
  size_t count = 0;
  for (size_t i = 0; i < path.size(); i += 2, ++count) sum += volume.thickness(path[i]);
  return count > 0 ? sum / double(count) : 0.0;
}

double longestSpur(const std::vector<TreeNode>& nodes) {
  std::vector<double> path_lengths(nodes.size(), 0.0);  // from the end of a part
  for (size_t i = 1; i < nodes.size(); ++i) {
    if (nodes[i].part != TreePart::kNone) continue;
    const size_t up = size_t(nodes[i].parent);
    path_lengths[i] = path_lengths[up] + (nodes[i].position - nodes[up].position).norm();
  }
  return *std::max_element(path_lengths.begin(), path_lengths.end());
}

void fillSides(const LabelledBody& body, bool together, ValidityFeatures* features) {
  const BodyPaths& paths = body.paths;
  const BodyAxes& axes = body.axes;
  const double longest = body.choice.longest;
  ValidityFeatures& out = *features;
  out[kArmsOffset] = std::abs(leftOffset(paths.arms[0], paths.arms[1], axes)) / longest;
  out[kLegsOffset] =
      together ? 0.0 : std::abs(leftOffset(paths.own_legs[0], paths.own_legs[1], axes)) / longest;
  out[kArmsAcross] =
      std::abs(cosine(axes.left, upperMiddle(paths.arms[0]) - upperMiddle(paths.arms[1])));
  out[kLegsAgree] = axes.agreement;
  Eigen::Vector3d forward = axes.forward;
  forward.z() = 0.0;
  forward = forward.stableNormalized();
  out[kFeetForward] = 1.0;
  for (const NodePath& leg : paths.legs) {
    const NodePath foot = pathSection(leg, 0.0, label_ratio::kWholeFoot * longest);
    out[kFeetForward] =
        std::min(out[kFeetForward], forward.dot(foot.front() - foot.back()) / longest);
  }
}

/// Path length from a node to the root, the head's extremity.
double pathLengthToHead(const std::vector<TreeNode>& nodes, int32_t node) {
  double path_length = 0.0;
  for (int32_t up = nodes[size_t(node)].parent; up >= 0; node = up, up = nodes[size_t(up)].parent)
    path_length += (nodes[size_t(node)].position - nodes[size_t(up)].position).norm();
  return path_length;
}

/// Limbs that are cut off in the hull are short, differ in length and are thick at the end.
void fillLimbs(const LabelledBody& body, ValidityFeatures* features) {
  const double longest = body.choice.longest;
  const RerootedTree& tree = body.rerooted;
  double path_lengths[kUnsidedExtremityCount];
  for (size_t i = 0; i < kUnsidedExtremityCount; ++i)
    path_lengths[i] = pathLengthToHead(tree.nodes, tree.extremities[i]);
  const auto unlike = [](double a, double b) {
    return std::abs(std::log(std::max(a, 1e-3) / std::max(b, 1e-3)));
  };
  const auto radius = [&](const NodePath& path) {
    return meanThickness(pathSection(path, 0.0, kTip * longest), body.volume) / longest;
  };
  const BodyPaths& paths = body.paths;
  ValidityFeatures& out = *features;
  out[kShorterReach] = std::min(path_lengths[1], path_lengths[2]) / longest;
  out[kArmsUnlike] = unlike(path_lengths[1], path_lengths[2]);
  out[kLegsUnlike] = unlike(path_lengths[3], path_lengths[4]);
  out[kHandRadius] = std::max(radius(paths.arms[0]), radius(paths.arms[1]));
  out[kFootRadius] = std::max(radius(paths.legs[0]), radius(paths.legs[1]));
  out[kHeadRadius] = radius(paths.head);
}

void fillHead(const LabelledBody& body, ValidityFeatures* features) {
  const Eigen::Vector3d& head = body.rerooted.nodes.front().position;
  double highest = head.z(), lowest = head.z();
  for (const Eigen::Vector3d& p : body.graph.positions) {
    highest = std::max(highest, p.z());
    lowest = std::min(lowest, p.z());
  }
  const double longest = body.choice.longest;
  const double low_foot = std::min(body.paths.legs[0].front().z(), body.paths.legs[1].front().z());
  (*features)[kHeadBelow] = (highest - head.z()) / longest;
  (*features)[kHeadUpright] = cosine(body.axes.up, head - body.paths.torso.front());
  (*features)[kLowFootUp] = (low_foot - lowest) / longest;
}

}  // namespace

const char* toString(ValidityFeature feature) {
  constexpr const char* kNames[] = {
      "names_odds",  "arms_offset",  "legs_offset", "arms_across",   "legs_agree",   "feet_forward",
      "head_below",  "head_upright", "hand_near",   "spur_length",   "shank_radius", "shorter_arm",
      "longer_arm",  "feet_gap",     "low_foot_up", "shorter_reach", "arms_unlike",  "legs_unlike",
      "hand_radius", "foot_radius",  "head_radius", "feet_are_one"};
  static_assert(std::size(kNames) == kValidityFeatureCount);
  return kNames[feature];
}

ValidityFeatures validityFeatures(const LabelledBody& body) {
  ValidityFeatures out{};
  const BodyPaths& paths = body.paths;
  const double longest = body.choice.longest;
  const double p = std::clamp(body.labels_probability, kMinOdds, 1.0 - kMinOdds);
  const bool together = body.rerooted.extremities[3] == body.rerooted.extremities[4];
  out[kNamesOdds] = std::log(p / (1.0 - p));
  fillSides(body, together, &out);
  fillHead(body, &out);
  fillLimbs(body, &out);
  NodePath trunk = paths.head;
  trunk.insert(trunk.end(), paths.torso.rbegin(), paths.torso.rend());
  const double hands[] = {distanceTo(trunk, paths.arms[0].front()),
                          distanceTo(trunk, paths.arms[1].front())};
  const double arms[] = {lengthOf(paths.arms[0]), lengthOf(paths.arms[1])};
  out[kHandNear] = std::min(hands[0], hands[1]) / longest;
  out[kShorterArm] = std::min(arms[0], arms[1]) / longest;
  out[kLongerArm] = std::max(arms[0], arms[1]) / longest;
  out[kSpurLength] = longestSpur(body.rerooted.nodes) / longest;
  for (const NodePath& leg : paths.legs) {
    const NodePath shank = pathSection(leg, kShankLow * longest, kShankHigh * longest);
    out[kShankRadius] = std::max(out[kShankRadius], meanThickness(shank, body.volume) / longest);
  }
  out[kFeetGap] = (paths.legs[0].front() - paths.legs[1].front()).norm() / longest;
  out[kFeetAreOne] = together ? 1.0 : 0.0;
  return out;
}

}  // namespace markerless_mocap
