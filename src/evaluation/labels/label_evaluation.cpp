#include "evaluation/labels/label_evaluation.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

constexpr double kMillimetres = 1e3;  // in a metre
constexpr double kHeadLimit_mm = 250.0;

/// An end's true points and how far from one of them it may be named.
struct TrueEnd {
  const char *point, *tip;
  double limit_mm;
};

constexpr TrueEnd kTrueEnds[kLabelledExtremityCount] = {
    {"head", "head_top", kHeadLimit_mm},
    {"l_hand", "l_hand_tip", kExtremityLimit_mm},
    {"r_hand", "r_hand_tip", kExtremityLimit_mm},
    {"l_foot", "l_foot_tip", kExtremityLimit_mm},
    {"r_foot", "r_foot_tip", kExtremityLimit_mm}};

/// Two ends that are each other's mirror image, and where their limbs' joints are among the names.
struct Pair {
  size_t left, right;
  std::array<const char*, 2> left_joints, right_joints;
};

constexpr Pair kPairs[] = {{kLeftHand, kRightHand, {"l_wrist", "l_elbow"}, {"r_wrist", "r_elbow"}},
                           {kLeftFoot, kRightFoot, {"l_ankle", "l_knee"}, {"r_ankle", "r_knee"}}};

/// Of wrist or ankle (joint 0), elbow or knee (1) of a side among labelTruthNames().
Eigen::Index jointColumn(size_t pair, size_t side, size_t joint) {
  return Eigen::Index(2 * kLabelledExtremityCount + 4 * pair + 2 * side + joint);
}

/// Distances in mm from a labelled end to the true ones, at their points and at the nearer of point
/// and tip.
struct Distances {
  std::array<double, kLabelledExtremityCount> to_point, to_either;
};

Distances distancesFrom(const Eigen::Vector3d& position, const Eigen::Matrix3Xd& truth) {
  Distances out;
  for (int end = 0; end < kLabelledExtremityCount; ++end) {
    out.to_point[size_t(end)] = kMillimetres * (position - truth.col(2 * end)).norm();
    const double to_tip = kMillimetres * (position - truth.col(2 * end + 1)).norm();
    out.to_either[size_t(end)] = std::min(out.to_point[size_t(end)], to_tip);
  }
  return out;
}

/// Distance in mm from a point to a line through points.
double distanceTo(const Eigen::Matrix3Xd& line, const Eigen::Vector3d& point) {
  double nearest = (line.col(0) - point).norm();
  for (Eigen::Index i = 1; i < line.cols(); ++i) {
    const Eigen::Vector3d step = line.col(i) - line.col(i - 1);
    const double along = step.dot(point - line.col(i - 1)) / std::max(step.squaredNorm(), 1e-12);
    const double share = std::min(std::max(along, 0.0), 1.0);
    nearest = std::min(nearest, (line.col(i - 1) + share * step - point).norm());
  }
  return kMillimetres * nearest;
}

/// One frame's labels beside its truth.
class FrameJudge {
 public:
  FrameJudge(const LabelledExtremities& labels, const Eigen::Matrix3Xd& truth)
      : labels_(labels), truth_(truth) {
    for (size_t end = 0; end < kLabelledExtremityCount; ++end)
      distances_[end] = distancesFrom(labels.positions.col(Eigen::Index(end)), truth);
  }

  double error(size_t end) const { return distances_[end].to_point[end]; }
  bool within(size_t end, size_t true_end) const {
    return distances_[end].to_either[true_end] <= kTrueEnds[end].limit_mm;
  }
  /// Whether the nearest true end is one of these two.
  bool nearestIs(size_t end, size_t one, size_t other) const {
    const auto& all = distances_[end].to_either;
    const size_t nearest = size_t(std::min_element(all.begin(), all.end()) - all.begin());
    return found(end) && (nearest == one || nearest == other);
  }
  bool kindsRight(const Pair& p) const {
    return nearestIs(p.left, p.left, p.right) && nearestIs(p.right, p.left, p.right) &&
           ((within(p.left, p.left) && within(p.right, p.right)) ||
            (within(p.left, p.right) && within(p.right, p.left)));
  }
  /// Whether what is found of a pair fits the truth no better with its sides changed.
  bool sidesFit(size_t pair) const {
    double gain = 0.0;
    if (found(kPairs[pair].left)) gain += misfit(0, pair, 0) - misfit(0, pair, 1);
    if (found(kPairs[pair].right)) gain += misfit(1, pair, 1) - misfit(1, pair, 0);
    return gain <= 0.0;
  }
  bool found(size_t end) const { return labels_.positions.col(Eigen::Index(end)).allFinite(); }

 private:
  /// How badly the end and limb labelled as one side fit those of one side of the truth, mm.
  double misfit(size_t labelled, size_t pair, size_t side) const {
    const size_t ends[] = {kPairs[pair].left, kPairs[pair].right}, end = ends[labelled];
    double sum = distances_[end].to_point[ends[side]];
    const Eigen::Matrix3Xd& limb = labels_.limbs[end];
    if (limb.cols() == 0) return sum;
    for (size_t joint = 0; joint < 2; ++joint) {
      const Eigen::Vector3d at = truth_.col(jointColumn(pair, side, joint));
      if (at.allFinite()) sum += distanceTo(limb, at);
    }
    return sum;
  }

  const LabelledExtremities& labels_;
  const Eigen::Matrix3Xd& truth_;
  std::array<Distances, kLabelledExtremityCount> distances_;
};

}  // namespace

LabelEvaluation evaluateLabels(const LabelledExtremities& labels, const Eigen::Matrix3Xd& truth) {
  LabelEvaluation verdict;
  verdict.judged = truth.leftCols<2 * kLabelledExtremityCount>().allFinite();
  verdict.error_mm.fill(NAN);
  if (!verdict.judged) return verdict;
  const FrameJudge judge(labels, truth);
  verdict.valid = labels.valid;
  verdict.complete = labels.positions.allFinite();
  for (size_t end = 0; end < kLabelledExtremityCount; ++end)
    verdict.error_mm[end] = judge.error(end);
  verdict.extremity_correct[kHead] =
      judge.nearestIs(kHead, kHead, kHead) && judge.within(kHead, kHead);
  verdict.kinds_correct = verdict.extremity_correct[kHead];
  verdict.sides_correct = true;
  for (size_t i = 0; i < 2; ++i) {
    const Pair& pair = kPairs[i];
    const bool sides = judge.sidesFit(i);
    verdict.kinds_correct = verdict.kinds_correct && judge.kindsRight(pair);
    verdict.sides_correct =
        verdict.sides_correct && sides && judge.found(pair.left) && judge.found(pair.right);
    for (const size_t end : {pair.left, pair.right})
      verdict.extremity_correct[end] =
          judge.nearestIs(end, pair.left, pair.right) && judge.within(end, end) && sides;
  }
  verdict.right = std::all_of(verdict.extremity_correct.begin(), verdict.extremity_correct.end(),
                              [](bool right) { return right; });
  return verdict;
}

const std::array<const char*, kLabelledExtremityCount>& extremityNames() {
  static const std::array<const char*, kLabelledExtremityCount> names{
      "head", "left_hand", "right_hand", "left_foot", "right_foot"};
  return names;
}

std::vector<std::string> labelTruthNames() {
  std::vector<std::string> names;
  for (const TrueEnd& end : kTrueEnds) {
    names.emplace_back(end.point);
    names.emplace_back(end.tip);
  }
  for (const Pair& pair : kPairs) {
    names.insert(names.end(), pair.left_joints.begin(), pair.left_joints.end());
    names.insert(names.end(), pair.right_joints.begin(), pair.right_joints.end());
  }
  return names;
}

}  // namespace markerless_mocap
