#include "ros/pose_tree_markers.h"

#include <tf2_eigen/tf2_eigen.h>

#include <string>

#include "ros/segmentation_conversions.h"

namespace markerless_mocap {
namespace {

using visualization_msgs::Marker;

// Sizes of the markers, metres.
constexpr double kEdgeWidth = 0.012, kTipSize = 0.07, kTextAbove = 0.09;
constexpr double kNameSize = 0.07, kReasonSize = 0.05;
constexpr double kArrowLength = 0.4, kArrowWidth = 0.025, kArrowHead = 0.06;
constexpr float kFaint = 0.3f;

std_msgs::ColorRGBA colorMessage(const std::array<uint8_t, 3>& rgb, float alpha) {
  std_msgs::ColorRGBA color;
  color.r = rgb[0] / 255.0f;
  color.g = rgb[1] / 255.0f;
  color.b = rgb[2] / 255.0f;
  color.a = alpha;
  return color;
}

TreePart partAt(Extremity extremity) {
  constexpr TreePart kParts[kExtremityCount] = {TreePart::kNeck, TreePart::kLeftArm,
                                                TreePart::kRightArm, TreePart::kLeftLeg,
                                                TreePart::kRightLeg};
  return kParts[size_t(extremity)];
}

/// Builds the markers of one tree.
class MarkerSet {
 public:
  MarkerSet(const PoseTree& tree, const std_msgs::Header& header)
      : tree_(tree), header_(header), alpha_(tree.valid() ? 1.0f : kFaint) {}

  void addEdges() {
    Marker& edges = add("tree", 0, Marker::LINE_LIST, tree_.nodes.size() > 1);
    edges.scale.x = kEdgeWidth;
    for (const TreeNode& node : tree_.nodes) {
      if (node.parent < 0) continue;
      edges.points.push_back(tf2::toMsg(tree_.nodes[size_t(node.parent)].position));
      edges.points.push_back(tf2::toMsg(node.position));
      edges.colors.insert(edges.colors.end(), 2, colorMessage(treeColor(node.part), alpha_));
    }
  }

  void addTip(Extremity extremity) {
    const TreeExtremity& tip = tree_.extremity(extremity);
    const int id = int(extremity);
    const auto color = treeColor(partAt(extremity));
    Marker& sphere = add("tips", id, Marker::SPHERE, tip.node >= 0);
    sphere.pose.position = tf2::toMsg(tip.position);
    sphere.scale.x = sphere.scale.y = sphere.scale.z = kTipSize;
    sphere.color = colorMessage(color, alpha_);
    std::string name = toString(extremity);
    for (char& c : name)
      if (c == '_') c = ' ';
    Marker& text = addText("tip_names", id, name, tip.position, tip.node >= 0);
    text.scale.z = kNameSize;
    text.color = colorMessage(color, alpha_);
  }

  void addForward() {
    const bool known = tree_.origin >= 0 && !tree_.forward.isZero();
    Marker& arrow = add("forward", 0, Marker::ARROW, known);
    if (!known) return;
    const Eigen::Vector3d& from = tree_.nodes[size_t(tree_.origin)].position;
    const Eigen::Vector3d to = from + kArrowLength * tree_.forward;
    arrow.points = {tf2::toMsg(from), tf2::toMsg(to)};
    arrow.scale.x = kArrowWidth;
    arrow.scale.y = arrow.scale.z = kArrowHead;
    arrow.color = colorMessage({255, 255, 255}, alpha_);
  }

  void addReason() {
    const bool shown = !tree_.valid() && !tree_.nodes.empty();
    Eigen::Vector3d at(0.0, 0.0, 2 * kTextAbove);
    if (shown) at += tree_.nodes.front().position;
    Marker& text = addText("reason", 0, tree_.reason, at, shown);
    text.scale.z = kReasonSize;
    text.color = colorMessage({255, 255, 255}, 1.0f);
  }

  const visualization_msgs::MarkerArray& markers() const { return markers_; }

 private:
  Marker& add(const char* group, int id, int32_t type, bool shown) {
    markers_.markers.emplace_back();
    Marker& marker = markers_.markers.back();
    marker.header = header_;
    marker.ns = group;
    marker.id = id;
    marker.type = type;
    marker.action = shown ? Marker::ADD : Marker::DELETE;
    marker.pose.orientation.w = 1.0;
    return marker;
  }

  Marker& addText(const char* group, int id, const std::string& words, const Eigen::Vector3d& below,
                  bool shown) {
    Marker& text = add(group, id, Marker::TEXT_VIEW_FACING, shown);
    text.text = words;
    text.pose.position = tf2::toMsg(Eigen::Vector3d(below + Eigen::Vector3d(0.0, 0.0, kTextAbove)));
    return text;
  }

  const PoseTree& tree_;
  const std_msgs::Header& header_;
  float alpha_;
  visualization_msgs::MarkerArray markers_;
};

}  // namespace

std::array<uint8_t, 3> treeColor(TreePart part) {
  if (part == TreePart::kNone) return {255, 255, 255};
  return partColor(PartLabel(int(part) - int(TreePart::kTorso)));
}

visualization_msgs::MarkerArray treeMarkers(const PoseTree& tree, const std_msgs::Header& header) {
  MarkerSet set(tree, header);
  set.addEdges();
  for (int i = 0; i < kExtremityCount; ++i) set.addTip(Extremity(i));
  set.addForward();
  set.addReason();
  return set.markers();
}

}  // namespace markerless_mocap
