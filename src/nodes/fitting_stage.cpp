#include "nodes/fitting_stage.h"

#include <stdexcept>

#include "markerless_mocap/ros/camera_conversions.h"
#include "markerless_mocap/ros/hull_conversions.h"
#include "markerless_mocap/ros/pose_conversions.h"
#include "markerless_mocap/ros/segmentation_conversions.h"
#include "nodes/publish_shared.h"

namespace markerless_mocap {
namespace {

// While a pose is fitted the newest wait, and the hulls are ahead of their segmentation.
constexpr uint32_t kQueue = 2;
constexpr uint32_t kHullQueue = 12;

AssemblerOptions exactStamps() {
  AssemblerOptions options;
  options.tolerance = 0.0;
  options.min_streams = 3;
  options.deadline = 2.0;  // the segmentation of an instant may lag behind the hulls by this
  return options;
}

}  // namespace

FittingStage::FittingStage(ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                           const FittingOptions& options, const FittingNodeOptions& node_options)
    : description_(node_options, options.stature),
      tracker_(description_.model(), options),
      assembler_(kStreams, exactStamps()),
      status_(handle, private_handle, "pose fitting"),
      announcer_(handle, node_options.body_id) {
  joint_states_ = handle.advertise<sensor_msgs::JointState>(
      "/humans/bodies/" + node_options.body_id + "/joint_states", 4);
  pose_ = handle.advertise<BodyPoseMsg>("pose", 4);
  subscribe(handle);
}

void FittingStage::subscribe(ros::NodeHandle& handle) {
  subscribers_.push_back(handle.subscribe<VoxelGrid>(
      "hull/grid", 1, gate_.guarded([this](const VoxelGridConstPtr& grid) { grid_ = grid; })));
  subscribers_.push_back(handle.subscribe<BodyPartsMsg>(
      "segmentation/parts", kQueue, gate_.guarded([this](const BodyPartsMsg::ConstPtr& parts) {
        receive(kParts, parts->header, {parts, nullptr});
      })));
  const auto subscribe_cloud = [&](const char* topic, uint32_t queue, Stream stream) {
    subscribers_.push_back(handle.subscribe<sensor_msgs::PointCloud2>(
        topic, queue, gate_.guarded([this, stream](const sensor_msgs::PointCloud2ConstPtr& cloud) {
          receive(stream, cloud->header, {nullptr, cloud});
        })));
  };
  subscribe_cloud("segmentation/points", kQueue, kLabels);
  subscribe_cloud("hull/points", kHullQueue, kHull);
}

void FittingStage::receive(Stream stream, const std_msgs::Header& header, Item item) {
  const uint64_t jumps = assembler_.counts().time_jumps_back;
  const auto instants = assembler_.add(stream, nanosecondsOf(header.stamp), std::move(item));
  if (assembler_.counts().time_jumps_back != jumps) tracker_.reset();
  for (const auto& instant : instants) publish(fit(instant), instant.items[kHull].cloud->header);
  status_.set("instants", assembler_.counts().complete);
  status_.set("abandoned instants", assembler_.counts().abandoned);
  status_.set("duplicate or late", assembler_.counts().duplicate + assembler_.counts().late);
  status_.set("time went back", assembler_.counts().time_jumps_back);
}

BodyPose FittingStage::fit(const InstantAssembler<Item>::Instant& instant) {
  try {
    if (!grid_) throw std::invalid_argument("no hull/grid has come yet");
    const VisualHull hull = hullFromMessage(*instant.items[kHull].cloud, *grid_);
    BodyParts parts = partsFromMessage(*instant.items[kParts].parts);
    parts.labels = labelsFromMessage(*instant.items[kLabels].cloud);
    return tracker_.update(instant.stamp_ns, parts, hull);
  } catch (const std::exception& error) {
    BodyPose lost;
    lost.reason = error.what();
    return lost;
  }
}

void FittingStage::publish(const BodyPose& pose, const std_msgs::Header& header) {
  const BodyModel& model = *description_.model();
  const bool tracked = pose.status != PoseStatus::kLost;
  status_.count(toString(pose.status));
  if (tracked) {
    joint_states_.publish(jointStateFromPose(model, pose, header));
    broadcaster_.sendTransform(rootTransform(model, pose, header));
    status_.good(pose.reason.empty() ? "the pose is followed" : pose.reason);
  } else {
    status_.problem(pose.reason);
  }
  announcer_.announce(tracked, header.stamp);
  publishShared(pose_, messageFromPose(model, pose, header));
}

}  // namespace markerless_mocap
