#include "skeleton/labelling.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "skeleton/labelling/extremity_position.h"
#include "skeleton/labelling/label_proportions.h"
#include "skeleton/label_template.h"
#include "skeleton/labelling/pose_joints.h"
#include "skeleton/validity_checks.h"

namespace markerless_mocap {
namespace {

constexpr double kMostGap = 0.15;    // between components of one body, metres
constexpr double kLeastLoop = 0.12;  // metres

}  // namespace

Labelling::Labelling(const PoseTreeOptions& options, const VisualHull& hull,
                     const CurveSkeleton& skeleton)
    : options_(options), hull_(hull), volume_(hull) {
  tree_.skeleton = skeleton;
}

void Labelling::choose(const LastEnds& last) {
  if (options_.labelling == "ranking") {
    choice_ = labelByRank(graph_, options_.prune_ratio, last);
    tree_.rank = choice_.rank;
    tree_.validity = choice_.rank;
  } else {
    choice_ = labelByTemplate(graph_, volume_, &names_probability_);
  }
}

void Labelling::plant() {
  planted_ = plantTree(graph_, choice_);
  if (choice_.status == TreeStatus::kOk) torso_ = nameParts(&planted_);
  if (torso_ && choice_.rank == 0.0) tree_.rank = plantedRank(planted_, choice_.longest);
  tree_.nodes = planted_.nodes;
  tree_.origin = planted_.origin;
}

void Labelling::placeTips() {
  const NodePath* paths[] = {&body_.head, &body_.arms[0], &body_.arms[1], &body_.legs[0],
                             &body_.legs[1]};
  for (size_t i = 0; i < planted_.ends.size(); ++i) {
    const int32_t node = planted_.ends[i];
    const Eigen::Vector3d at = planted_.nodes[size_t(node)].position;
    const NodePath path = paths[i]->empty() ? NodePath{at} : *paths[i];
    tree_.tips[i] = {
        node, at, extremityPosition(path, LimbEnd(i), choice_.closed[i], choice_.longest, volume_)};
  }
  if (!feetTogether() || !axes_.known) return;
  const auto balls = ballsTogether(body_.legs[0], axes_, choice_.longest, volume_);
  for (size_t i = 0; i < 2; ++i) tree_.tips[3 + i].position = balls[i];
}

void Labelling::tellSides() {
  axes_ = findAxes(body_);
  if (!axes_.known) return;
  tree_.forward = axes_.forward;
  tree_.left = axes_.left;
}

void Labelling::swapSides(size_t first_tip, TreePart left, TreePart right) {
  for (TreeNode& node : tree_.nodes) {
    if (node.part == left)
      node.part = right;
    else if (node.part == right)
      node.part = left;
  }
  std::swap(tree_.tips[first_tip], tree_.tips[first_tip + 1]);
}

/// Puts left and right where limbs 1 and 2 were.
void Labelling::nameSides() {
  if (!axes_.known) return;
  const bool by_angles = options_.side_rule == "angles";
  const double arms = leftOffset(body_.arms[0], body_.arms[1], axes_);
  const double legs = leftOffset(body_.own_legs[0], body_.own_legs[1], axes_);
  if (by_angles ? !firstIsLeftByAngles(body_.arms, label_ratio::kShoulder, body_, axes_)
                : arms < 0.0)
    swapSides(1, TreePart::kLeftArm, TreePart::kRightArm);
  if (by_angles ? !firstIsLeftByAngles(body_.own_legs, label_ratio::kHip, body_, axes_)
                : legs < 0.0)
    swapSides(3, TreePart::kLeftLeg, TreePart::kRightLeg);
}

void Labelling::judge() {
  const auto empty = [](const NodePath& path) { return path.empty(); };
  if (!axes_.known || !torso_ || empty(body_.torso) ||
      std::any_of(std::begin(body_.arms), std::end(body_.arms), empty) ||
      std::any_of(std::begin(body_.legs), std::end(body_.legs), empty))
    return;
  doubts_ = labelDoubts({graph_, volume_, choice_, planted_, body_, axes_, names_probability_});
  if (options_.labelling == "template") tree_.validity = validityOf(*doubts_);
}

PoseTree Labelling::run(const LastEnds& last, LastEnds* now) {
  if (const auto refusal = refuseSkeleton(tree_.skeleton))
    return refuse(refusal->status, refusal->reason);
  graph_ = makeTreeGraph(tree_.skeleton, kMostGap, kLeastLoop);
  if (const auto refusal = refuseSkeleton(hull_, graph_))
    return refuse(refusal->status, refusal->reason);
  choose(last);
  plant();
  if (choice_.status != TreeStatus::kOk) return refuse(choice_.status, choice_.reason);
  body_ = bodyPaths(planted_, choice_.longest);
  tellSides();
  placeTips();
  nameSides();
  judge();
  if (axes_.known) placeJoints(axes_, choice_.longest, &tree_);
  if (!torso_) return refuse(TreeStatus::kNoTorso, "legs and arms meet in one point");
  if (!axes_.known)
    return refuse(TreeStatus::kSidesUnknown, "the legs do not tell where forward is");
  if (options_.labelling == "ranking" && choice_.rank < options_.least_rank)
    return refuse(TreeStatus::kLowRank, "no branching is like the origin of a body");
  if (options_.labelling != "ranking" && tree_.validity < options_.least_validity)
    return refuse(TreeStatus::kUncertain, "the ends could be named otherwise as well");
  now->emplace();
  for (size_t i = 0; i < planted_.ends.size(); ++i)
    (**now)[i] = planted_.nodes[size_t(planted_.ends[i])].position;
  tree_.status = TreeStatus::kOk;
  return tree_;
}

}  // namespace markerless_mocap
