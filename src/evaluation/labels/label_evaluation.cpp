#include "evaluation/labels/label_evaluation.h"

#include <algorithm>
#include <cmath>

#include "numerics/segment.h"

namespace markerless_mocap {
namespace {

constexpr double kMillimetres = 1e3;  // per metre
constexpr double kHeadLimit_mm = 250.0;

/// The true points of an extremity, and the maximum distance from one of them.
struct TrueExtremity {
  const char *point, *tip;
  double limit_mm;
};

constexpr TrueExtremity kTrueExtremities[kLabelledExtremityCount] = {
    {"head", "head_top", kHeadLimit_mm},
    {"l_hand", "l_hand_tip", kExtremityLimit_mm},
    {"r_hand", "r_hand_tip", kExtremityLimit_mm},
    {"l_foot", "l_foot_tip", kExtremityLimit_mm},
    {"r_foot", "r_foot_tip", kExtremityLimit_mm}};

/// Two extremities that mirror each other, and the columns of their limbs' joints.
struct Pair {
  size_t left, right;
  std::array<const char*, 2> left_joints, right_joints;
};

constexpr Pair kPairs[] = {{kLeftHand, kRightHand, {"l_wrist", "l_elbow"}, {"r_wrist", "r_elbow"}},
                           {kLeftFoot, kRightFoot, {"l_ankle", "l_knee"}, {"r_ankle", "r_knee"}}};

/// Column in labelTruthNames() of wrist or ankle (joint 0), or elbow or knee (joint 1), of a side.
Eigen::Index jointColumn(size_t pair, size_t side, size_t joint) {
  return Eigen::Index(size_t(2) * kLabelledExtremityCount + 4 * pair + 2 * side + joint);
}

/// Distances from a labelled extremity to the true ones, mm: to their points, and to the nearer of
/// point and tip.
struct Distances {
  std::array<double, kLabelledExtremityCount> to_point, to_either;
};

Distances distancesFrom(const Eigen::Vector3d& position, const Eigen::Matrix3Xd& truth) {
  Distances out;
  for (Eigen::Index end = 0; end < kLabelledExtremityCount; ++end) {
    out.to_point[size_t(end)] = kMillimetres * (position - truth.col(2 * end)).norm();
    const double to_tip = kMillimetres * (position - truth.col(2 * end + 1)).norm();
    out.to_either[size_t(end)] = std::min(out.to_point[size_t(end)], to_tip);
  }
  return out;
}

/// Distance from a point to a polyline, in the units of the points.
double distanceTo(const Eigen::Matrix3Xd& line, const Eigen::Vector3d& point) {
  double nearest = (line.col(0) - point).norm();
  for (Eigen::Index i = 1; i < line.cols(); ++i) {
    const Eigen::Vector3d step = line.col(i) - line.col(i - 1);
    const double fraction = nearestFraction(point, line.col(i - 1), step);
    nearest = std::min(nearest, (line.col(i - 1) + fraction * step - point).norm());
  }
  return kMillimetres * nearest;
}

/// Compares the labels of one frame with the truth.
class FrameEvaluation {
 public:
  FrameEvaluation(const LabelledExtremities& labels, const Eigen::Matrix3Xd& truth)
      : labels_(labels), truth_(truth) {
    for (size_t end = 0; end < kLabelledExtremityCount; ++end)
      distances_[end] = distancesFrom(labels.positions.col(Eigen::Index(end)), truth);
  }

  double error(size_t end) const { return distances_[end].to_point[end]; }
  bool within(size_t end, size_t true_end) const {
    return distances_[end].to_either[true_end] <= kTrueExtremities[end].limit_mm;
  }
  /// Whether the nearest true extremity is one of these two.
  bool nearestIs(size_t end, size_t one, size_t other) const {
    const auto& all = distances_[end].to_either;
    const size_t nearest = size_t(std::min_element(all.begin(), all.end()) - all.begin());
    return found(end) && (nearest == one || nearest == other);
  }
  bool kindsCorrect(const Pair& p) const {
    return nearestIs(p.left, p.left, p.right) && nearestIs(p.right, p.left, p.right) &&
           ((within(p.left, p.left) && within(p.right, p.right)) ||
            (within(p.left, p.right) && within(p.right, p.left)));
  }
  /// Whether an exchange of its sides does not improve the fit of a pair.
  bool sidesFit(size_t pair) const {
    double gain = 0.0;
    if (found(kPairs[pair].left)) gain += misfit(0, pair, 0) - misfit(0, pair, 1);
    if (found(kPairs[pair].right)) gain += misfit(1, pair, 1) - misfit(1, pair, 0);
    return gain <= 0.0;
  }
  bool found(size_t end) const { return labels_.positions.col(Eigen::Index(end)).allFinite(); }

 private:
  /// Sum of distances between the labelled extremity and limb of one side and the true ones of a
  /// side, mm.
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
  LabelEvaluation evaluation;
  evaluation.evaluated = truth.leftCols<2 * kLabelledExtremityCount>().allFinite();
  evaluation.error_mm.fill(NAN);
  if (!evaluation.evaluated) return evaluation;
  const FrameEvaluation frame(labels, truth);
  evaluation.valid = labels.valid;
  evaluation.complete = labels.positions.allFinite();
  for (size_t end = 0; end < kLabelledExtremityCount; ++end)
    evaluation.error_mm[end] = frame.error(end);
  evaluation.extremity_correct[kHead] =
      frame.nearestIs(kHead, kHead, kHead) && frame.within(kHead, kHead);
  evaluation.kinds_correct = evaluation.extremity_correct[kHead];
  evaluation.sides_correct = true;
  for (size_t i = 0; i < 2; ++i) {
    const Pair& pair = kPairs[i];
    const bool sides = frame.sidesFit(i);
    evaluation.kinds_correct = evaluation.kinds_correct && frame.kindsCorrect(pair);
    evaluation.sides_correct =
        evaluation.sides_correct && sides && frame.found(pair.left) && frame.found(pair.right);
    for (const size_t end : {pair.left, pair.right})
      evaluation.extremity_correct[end] =
          frame.nearestIs(end, pair.left, pair.right) && frame.within(end, end) && sides;
  }
  evaluation.right =
      std::all_of(evaluation.extremity_correct.begin(), evaluation.extremity_correct.end(),
                  [](bool right) { return right; });
  return evaluation;
}

const std::array<const char*, kLabelledExtremityCount>& extremityNames() {
  static const std::array<const char*, kLabelledExtremityCount> names{
      "head", "left_hand", "right_hand", "left_foot", "right_foot"};
  return names;
}

std::vector<std::string> labelTruthNames() {
  std::vector<std::string> names;
  for (const TrueExtremity& end : kTrueExtremities) {
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
