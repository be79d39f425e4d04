#include "tools/evaluate/evaluation_tree.h"

#include <rosbag/view.h>

#include <stdexcept>

#include "ros/camera_conversions.h"
#include "ros/pose_tree_conversions.h"
#include "tools/common/bag_io.h"
#include "tools/common/tree_labels.h"

namespace markerless_mocap {
namespace {

constexpr const char* kTopic = "/pose_tree";
constexpr const char* kMissing = "missing";

/// Name of a joint in the ground truth: the base of the neck is called thorax there.
std::string truthName(TreeJoint joint) {
  return joint == TreeJoint::kNeck ? "thorax" : toString(joint);
}

Eigen::Matrix3Xd jointsOf(const PoseTree& tree) {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Constant(3, kTreeJointCount, NAN);
  for (int i = 0; i < kTreeJointCount; ++i)
    if (const auto& joint = tree.joints[size_t(i)]; joint && tree.valid()) points.col(i) = *joint;
  return points;
}

}  // namespace

TreeRecord readTrees(const std::string& path) {
  rosbag::Bag bag;
  openForReading(path, bag);
  TreeRecord record;
  for (int i = 0; i < kTreeJointCount; ++i) record.joints.names.push_back(truthName(TreeJoint(i)));
  for (const rosbag::MessageInstance& entry : rosbag::View(bag, rosbag::TopicQuery(kTopic))) {
    const auto message = messageOf<PoseTreeMsg>(entry);
    if (!message) continue;
    const int64_t stamp = nanosecondsOf(message->header.stamp);
    // Time starts again in a loop or a second recording; only the first pass is used.
    if (!record.stamps_ns.empty() && stamp <= record.stamps_ns.back()) continue;
    const PoseTree tree = poseTreeFromMessage(*message);
    record.world_frame = message->header.frame_id;
    record.stamps_ns.push_back(stamp);
    record.labels.push_back(labelsOf(tree));
    record.statuses.emplace_back(toString(tree.status));
    record.reasons.push_back(tree.reason);
    record.joints.add(stamp, jointsOf(tree));
  }
  return record;
}

TreeEvaluation evaluateTrees(const JointTrack& truth, const std::string& world_frame,
                             const TreeRecord& trees, int64_t tolerance_ns) {
  if (trees.world_frame != world_frame)
    throw std::runtime_error("the pose trees are in the frame " + trees.world_frame +
                             ", the ground truth in " + world_frame + ": they cannot be compared");
  TreeEvaluation out;
  std::vector<LabelledExtremities> labels;
  for (const int index : matchStamps(truth.stamps_ns, trees.stamps_ns, tolerance_ns)) {
    const bool said = index >= 0;
    labels.push_back(said ? trees.labels[size_t(index)] : LabelledExtremities());
    out.reasons.push_back(said ? trees.reasons[size_t(index)] : "");
    ++out.status_counts[said ? trees.statuses[size_t(index)] : kMissing];
  }
  out.labels = labelErrors(truth, labels);
  out.joints = trees.joints.names;
  const JointTrack real = truth.select(out.joints);
  for (const auto& distances : markerDistances(real, alignedTo(real, trees.joints)))
    out.joint_errors_mm.push_back(summaryStatistics(distances));
  return out;
}

}  // namespace markerless_mocap
