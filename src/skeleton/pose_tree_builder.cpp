#include "markerless_mocap/skeleton/pose_tree_builder.h"

#include <utility>

#include "markerless_mocap/skeleton/thinner.h"
#include "skeleton/extremity_position.h"
#include "skeleton/label_proportions.h"
#include "skeleton/label_ranking.h"
#include "skeleton/label_template.h"
#include "skeleton/left_right.h"
#include "skeleton/pose_joints.h"
#include "skeleton/tree_graph.h"
#include "skeleton/tree_parts.h"
#include "skeleton/validity_checks.h"

namespace markerless_mocap {
namespace {

constexpr double kMostGap = 0.15;      // between components of one body, metres
constexpr double kLeastLoop = 0.12;    // metres
constexpr double kPersistence = 0.02;  // of a curve, metres: feet that touch stand out little

PoseTreeOptions validated(const PoseTreeOptions& options) {
  options.validate();
  return options;
}

/// Swaps the sides of the parts of a pair of limbs.
void swapParts(TreePart a, TreePart b, std::vector<TreeNode>* nodes) {
  for (TreeNode& node : *nodes) {
    if (node.part == a)
      node.part = b;
    else if (node.part == b)
      node.part = a;
  }
}

PoseTree refused(const Refusal& refusal) {
  PoseTree tree;
  tree.status = refusal.status;
  tree.reason = refusal.reason;
  return tree;
}

/// Right frames are more frequent than the model of the ends says, by this factor of the odds: so
/// it was on the people whom the model was fitted to, and so on others.
double calibrated(double probability) {
  constexpr double kOdds = 3.0;
  return kOdds * probability / (1.0 + (kOdds - 1.0) * probability);
}

/// One frame on its way to a pose tree.
class Labelling {
 public:
  Labelling(const PoseTreeOptions& options, const VisualHull& hull, const CurveSkeleton& skeleton)
      : options_(options), hull_(hull), volume_(hull) {
    tree_.skeleton = skeleton;
  }

  PoseTree run(const LastEnds& last, LastEnds* now);

 private:
  PoseTree& refuse(TreeStatus status, const std::string& reason) {
    tree_.status = status;
    tree_.reason = reason;
    return tree_;
  }
  bool feetTogether() const { return choice_.ends[3] == choice_.ends[4]; }
  void choose(const LastEnds& last);
  void plant();
  void placeTips();
  void tellSides();
  void nameSides();

  const PoseTreeOptions& options_;
  const VisualHull& hull_;
  TreeVolume volume_;
  TreeGraph graph_;
  LabelChoice choice_;
  PlantedTree planted_;
  BodyPaths body_;
  BodyAxes axes_;
  bool torso_ = false;
  PoseTree tree_;
};

void Labelling::choose(const LastEnds& last) {
  if (options_.labelling == "ranking") {
    choice_ = labelByRank(graph_, options_.prune_ratio, last);
    tree_.rank = choice_.rank;
    tree_.validity = choice_.rank;
  } else {
    choice_ = labelByTemplate(graph_, volume_, &tree_.validity);
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

/// Puts left and right where limbs 1 and 2 were.
void Labelling::nameSides() {
  if (!axes_.known) return;
  const bool by_angles = options_.side_rule == "angles";
  const double arms = leftOffset(body_.arms[0], body_.arms[1], axes_);
  const double legs = leftOffset(body_.own_legs[0], body_.own_legs[1], axes_);
  if (by_angles ? !firstIsLeftByAngles(body_.arms, label_ratio::kShoulder, body_, axes_)
                : arms < 0.0) {
    swapParts(TreePart::kLeftArm, TreePart::kRightArm, &tree_.nodes);
    std::swap(tree_.tips[1], tree_.tips[2]);
  }
  if (by_angles ? !firstIsLeftByAngles(body_.own_legs, label_ratio::kHip, body_, axes_)
                : legs < 0.0) {
    swapParts(TreePart::kLeftLeg, TreePart::kRightLeg, &tree_.nodes);
    std::swap(tree_.tips[3], tree_.tips[4]);
  }
  tree_.validity *= armCertainty(arms / choice_.longest);
  if (!feetTogether()) tree_.validity *= legCertainty(legs / choice_.longest);
  if (options_.labelling == "template") tree_.validity = calibrated(tree_.validity);
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

}  // namespace

class PoseTreeBuilder::State {
 public:
  explicit State(const PoseTreeOptions& options) : options_(validated(options)) {}

  PoseTree build(const VisualHull& hull, const CurveSkeleton* skeleton) {
    LastEnds now;
    if (const auto refusal = refuseHull(hull)) {
      last_.reset();
      return refused(*refusal);
    }
    PoseTree tree = Labelling(options_, hull, skeleton ? *skeleton : thinner_.thin(hull))
                        .run(options_.follow_labels ? last_ : LastEnds(), &now);
    last_ = now;
    return tree;
  }
  void reset() { last_.reset(); }

 private:
  PoseTreeOptions options_;
  Thinner thinner_{kPersistence};
  LastEnds last_;
};

PoseTreeBuilder::PoseTreeBuilder(const PoseTreeOptions& options)
    : state_(std::make_unique<State>(options)) {}
PoseTreeBuilder::~PoseTreeBuilder() = default;
PoseTreeBuilder::PoseTreeBuilder(PoseTreeBuilder&&) noexcept = default;
PoseTreeBuilder& PoseTreeBuilder::operator=(PoseTreeBuilder&&) noexcept = default;

PoseTree PoseTreeBuilder::build(const VisualHull& hull, const CurveSkeleton& skeleton) {
  return state_->build(hull, &skeleton);
}

PoseTree PoseTreeBuilder::build(const VisualHull& hull) {
  return state_->build(hull, nullptr);
}

void PoseTreeBuilder::reset() {
  state_->reset();
}

}  // namespace markerless_mocap
