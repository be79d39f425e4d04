#include "markerless_mocap/skeleton/pose_tree_builder.h"

#include <utility>

#include "markerless_mocap/skeleton/thinner.h"
#include "skeleton/label_ranking.h"
#include "skeleton/left_right.h"
#include "skeleton/tree_graph.h"
#include "skeleton/tree_parts.h"

namespace markerless_mocap {
namespace {

constexpr double kMostGap = 0.15;      // between components of one body, metres
constexpr double kLeastLoop = 0.12;    // metres
constexpr double kPersistence = 0.02;  // of a curve, metres: feet that touch stand out little

PoseTreeOptions validated(const PoseTreeOptions& options) {
  options.validate();
  return options;
}

PoseTree& refuse(PoseTree& tree, TreeStatus status, const std::string& reason) {
  tree.status = status;
  tree.reason = reason;
  return tree;
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

}  // namespace

class PoseTreeBuilder::State {
 public:
  explicit State(const PoseTreeOptions& options) : options_(validated(options)) {}

  PoseTree build(const VisualHull& hull, const CurveSkeleton& skeleton);
  CurveSkeleton thin(const VisualHull& hull) { return thinner_.thin(hull); }
  void reset() { last_.reset(); }

 private:
  void tellSides(const PlantedTree& planted, double longest, PoseTree* tree) const;

  PoseTreeOptions options_;
  Thinner thinner_{kPersistence};
  LastEnds last_;
};

PoseTree PoseTreeBuilder::State::build(const VisualHull&, const CurveSkeleton& skeleton) {
  PoseTree tree;
  tree.skeleton = skeleton;
  if (skeleton.voxels.size() < 2)
    return refuse(tree, TreeStatus::kNoSkeleton, "the hull is too small for a skeleton");
  const TreeGraph graph = makeTreeGraph(skeleton, kMostGap, kLeastLoop);
  const LabelChoice choice =
      labelByRank(graph, options_.prune_ratio, options_.follow_labels ? last_ : LastEnds());
  tree.rank = choice.rank;
  PlantedTree planted = plantTree(graph, choice);
  tree.nodes = planted.nodes;
  if (choice.status != TreeStatus::kOk) return refuse(tree, choice.status, choice.reason);
  const bool torso = nameParts(&planted);
  tree.nodes = planted.nodes;
  tree.origin = planted.origin;
  for (size_t i = 0; i < planted.ends.size(); ++i) {
    const int32_t node = planted.ends[i];
    const Eigen::Vector3d at = planted.nodes[size_t(node)].position;
    tree.tips[i] = {node, at, at};
  }
  if (!torso) return refuse(tree, TreeStatus::kNoTorso, "legs and arms meet in one point");
  tellSides(planted, choice.longest, &tree);
  if (tree.left.isZero())
    return refuse(tree, TreeStatus::kSidesUnknown, "the legs do not tell where forward is");
  if (choice.rank < options_.least_rank)
    return refuse(tree, TreeStatus::kLowRank, "no branching is like the origin of a body");
  tree.status = TreeStatus::kOk;
  return tree;
}

void PoseTreeBuilder::State::tellSides(const PlantedTree& planted, double longest,
                                       PoseTree* tree) const {
  const BodyPaths body = bodyPaths(planted, longest);
  const BodyAxes axes = findAxes(body);
  if (!axes.known) return;
  tree->forward = axes.forward;
  tree->left = axes.left;
  const bool by_angles = options_.side_rule == "angles";
  const auto firstIsLeft = [&](const NodePath(&limbs)[2], double share) {
    return by_angles ? firstIsLeftByAngles(limbs, share, body, axes)
                     : leftOffset(limbs[0], limbs[1], axes) > 0.0;
  };
  if (!firstIsLeft(body.arms, 0.085)) {
    swapParts(TreePart::kLeftArm, TreePart::kRightArm, &tree->nodes);
    std::swap(tree->tips[1], tree->tips[2]);
  }
  if (!firstIsLeft(body.legs, 0.061)) {
    swapParts(TreePart::kLeftLeg, TreePart::kRightLeg, &tree->nodes);
    std::swap(tree->tips[3], tree->tips[4]);
  }
}

PoseTreeBuilder::PoseTreeBuilder(const PoseTreeOptions& options)
    : state_(std::make_unique<State>(options)) {}
PoseTreeBuilder::~PoseTreeBuilder() = default;
PoseTreeBuilder::PoseTreeBuilder(PoseTreeBuilder&&) noexcept = default;
PoseTreeBuilder& PoseTreeBuilder::operator=(PoseTreeBuilder&&) noexcept = default;

PoseTree PoseTreeBuilder::build(const VisualHull& hull, const CurveSkeleton& skeleton) {
  return state_->build(hull, skeleton);
}

PoseTree PoseTreeBuilder::build(const VisualHull& hull) {
  return state_->build(hull, state_->thin(hull));
}

void PoseTreeBuilder::reset() {
  state_->reset();
}

}  // namespace markerless_mocap
