#include "skeleton/labelling.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "skeleton/label_template.h"
#include "skeleton/labelling/extremity_position.h"
#include "skeleton/labelling/pose_joints.h"
#include "skeleton/labelling/validity_model.h"
#include "skeleton/plausibility_checks.h"

namespace markerless_mocap {
namespace {

constexpr double kMaxGap = 0.15;   // between components of one body, metres
constexpr double kMinLoop = 0.12;  // metres

/// From the head, which is the tree's root and has no limb of its own, down to a foot.
NodePath pathFromHead(const RerootedTree& tree) {
  NodePath path;
  for (int32_t node = tree.extremities[size_t(UnsidedExtremity::kFoot1)]; node >= 0;
       node = tree.nodes[size_t(node)].parent)
    path.push_back(tree.nodes[size_t(node)].position);
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace

Labelling::Labelling(const PoseTreeOptions& options, const PoseTreeModel& model,
                     const VisualHull& hull, const CurveSkeleton& skeleton)
    : options_(options), model_(model), hull_(hull), volume_(hull) {
  tree_.skeleton = skeleton;
}

void Labelling::choose(const PreviousExtremities& last) {
  if (options_.labelling == "ranking") {
    choice_ = labelByRank(graph_, options_, last);
    tree_.rank = choice_.rank;
    tree_.validity = choice_.rank;
  } else {
    choice_ = labelByTemplate(graph_, volume_, model_.extremities(), &labels_probability_);
  }
}

void Labelling::reroot() {
  rerooted_ = rerootTree(graph_, choice_);
  if (choice_.status == TreeStatus::kOk) torso_ = nameParts(&rerooted_);
  if (torso_ && choice_.rank == 0.0)
    tree_.rank = rerootedRank(rerooted_, choice_.longest, options_);
  tree_.nodes = rerooted_.nodes;
  tree_.origin = rerooted_.origin;
}

void Labelling::placeExtremities() {
  const bool at_leaf = options_.extremities == "leaf";
  const NodePath head = pathFromHead(rerooted_);
  const NodePath* paths[] = {&head, &body_.arms[0], &body_.arms[1], &body_.legs[0], &body_.legs[1]};
  for (size_t i = 0; i < rerooted_.extremities.size(); ++i) {
    const int32_t node = rerooted_.extremities[i];
    const Eigen::Vector3d at = rerooted_.nodes[size_t(node)].position;
    const NodePath path = paths[i]->empty() ? NodePath{at} : *paths[i];
    tree_.extremities[i] = {node, at,
                            at_leaf
                                ? at
                                : extremityPosition(path, UnsidedExtremity(i), choice_.closed[i],
                                                    choice_.longest, volume_)};
  }
  if (at_leaf || !feetTogether() || !axes_.known) return;
  const auto balls = footPositionsOfSharedExtremity(body_.legs[0], axes_, choice_.longest, volume_);
  for (size_t i = 0; i < 2; ++i) tree_.extremities[3 + i].position = balls[i];
}

void Labelling::estimateBodyAxes() {
  axes_ = findAxes(body_, options_);
  if (!axes_.known) return;
  tree_.forward = axes_.forward;
  tree_.left = axes_.left;
}

void Labelling::swapSides(size_t first_extremity, TreePart left, TreePart right) {
  for (TreeNode& node : tree_.nodes) {
    if (node.part == left)
      node.part = right;
    else if (node.part == right)
      node.part = left;
  }
  std::swap(tree_.extremities[first_extremity], tree_.extremities[first_extremity + 1]);
}

/// Replaces limbs 1 and 2 by left and right.
void Labelling::assignSides() {
  if (!axes_.known) return;
  const bool by_angles = options_.side_rule == "angles";
  const double arms = leftOffset(body_.arms[0], body_.arms[1], axes_);
  const double legs = leftOffset(body_.own_legs[0], body_.own_legs[1], axes_);
  if (by_angles ? !firstIsLeftByAngles(body_.arms, options_.limb_ratios.shoulder, body_, axes_)
                : arms < 0.0)
    swapSides(1, TreePart::kLeftArm, TreePart::kRightArm);
  if (by_angles ? !firstIsLeftByAngles(body_.own_legs, options_.limb_ratios.hip, body_, axes_)
                : legs < 0.0)
    swapSides(3, TreePart::kLeftLeg, TreePart::kRightLeg);
}

void Labelling::assessValidity() {
  const auto empty = [](const NodePath& path) { return path.empty(); };
  if (!axes_.known || !torso_ || empty(body_.torso) ||
      std::any_of(std::begin(body_.arms), std::end(body_.arms), empty) ||
      std::any_of(std::begin(body_.legs), std::end(body_.legs), empty))
    return;
  validity_features_ =
      validityFeatures({graph_, volume_, choice_, rerooted_, body_, axes_, labels_probability_});
  if (options_.labelling == "template")
    tree_.validity = model_.validity().probability(*validity_features_);
}

PoseTree Labelling::run(const PreviousExtremities& last, PreviousExtremities* now) {
  if (const auto rejection = rejectSkeleton(tree_.skeleton))
    return reject(rejection->status, rejection->reason);
  graph_ = makeTreeGraph(tree_.skeleton, kMaxGap, kMinLoop,
                         {options_.tree_paths == "breadth_first", options_.smoothing});
  if (const auto rejection = rejectSkeleton(hull_, graph_))
    return reject(rejection->status, rejection->reason);
  choose(last);
  reroot();
  if (choice_.status != TreeStatus::kOk) return reject(choice_.status, choice_.reason);
  body_ = bodyPaths(rerooted_, choice_.longest, options_);
  estimateBodyAxes();
  placeExtremities();
  assignSides();
  assessValidity();
  if (axes_.known) placeJoints(axes_, choice_.longest, &tree_);
  if (!torso_)
    return reject(TreeStatus::kNoTorso, "legs and arms meet in one point, so there is no torso");
  if (!axes_.known)
    return reject(TreeStatus::kSidesUnknown, "the legs do not show which direction is forward");
  if (options_.labelling == "ranking" && choice_.rank < options_.min_rank)
    return reject(TreeStatus::kLowRank,
                  "no branching node ranks high enough as the origin of a body");
  if (options_.labelling != "ranking" && tree_.validity < options_.min_validity)
    return reject(TreeStatus::kUncertain, "other labels of the extremities are nearly as likely");
  now->emplace();
  for (size_t i = 0; i < rerooted_.extremities.size(); ++i)
    (**now)[i] = rerooted_.nodes[size_t(rerooted_.extremities[i])].position;
  tree_.status = TreeStatus::kOk;
  return tree_;
}

}  // namespace markerless_mocap
