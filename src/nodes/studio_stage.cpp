#include "nodes/studio_stage.h"

#include <ros/master.h>
#include <ros/param.h>
#include <rosgraph_msgs/Clock.h>
#include <tf2_eigen/tf2_eigen.h>

#include <algorithm>

#include "markerless_mocap/ros/camera_conversions.h"
#include "markerless_mocap/ros/image_conversions.h"
#include "markerless_mocap/ros/pose_conversions.h"
#include "nodes/body_description.h"
#include "nodes/publish_shared.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kClockStart = 1000'000'000'000;  // nanoseconds

std::string opticalFrame(const Camera& camera) {
  return camera.name() + "_optical";
}

}  // namespace

StudioStage::StudioStage(ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                         const StudioOptions& options, const StudioNodeOptions& node_options)
    : handle_(handle),
      node_options_(node_options),
      studio_(readUrdfTemplate(node_options.urdf_template), node_options.body_id, options),
      status_(handle, private_handle, "virtual studio") {
  ros::param::set("/human_description_" + node_options_.body_id, studio_.urdf());
  advertise(handle);
  publishRig();
  timer_ = handle.createWallTimer(ros::WallDuration(1.0 / options.fps),
                                  gate_.guarded([this](const ros::WallTimerEvent&) { tick(); }));
}

void StudioStage::advertise(ros::NodeHandle& handle) {
  for (const Camera& camera : studio_.rig()) {
    images_.push_back(handle.advertise<sensor_msgs::Image>(camera.name() + "/image_raw", 4));
    infos_.push_back(handle.advertise<sensor_msgs::CameraInfo>(camera.name() + "/camera_info", 4));
  }
  truth_ = handle.advertise<sensor_msgs::JointState>("ground_truth/joint_states", 4);
  if (node_options_.clock) clock_ = handle.advertise<rosgraph_msgs::Clock>("/clock", 4);
}

void StudioStage::publishRig() {
  std::vector<geometry_msgs::TransformStamped> transforms;
  for (const Camera& camera : studio_.rig()) {
    transforms.push_back(tf2::eigenToTransform(camera.calibration().T_world_camera));
    transforms.back().header.frame_id = node_options_.world_frame;
    transforms.back().child_frame_id = opticalFrame(camera);
  }
  static_broadcaster_.sendTransform(transforms);
}

bool StudioStage::isAwaited() const {
  if (!node_options_.wait_for_silhouettes) return true;
  ros::master::V_TopicInfo advertised;
  ros::master::getTopics(advertised);
  for (size_t i = 0; i < images_.size(); ++i) {
    const std::string topic = handle_.resolveName(studio_.rig()[i].name() + "/silhouette");
    const bool known = std::any_of(advertised.begin(), advertised.end(),
                                   [&](const auto& info) { return info.name == topic; });
    if (!known || images_[i].getNumSubscribers() == 0) return false;
  }
  return true;
}

void StudioStage::tick() {
  if (next_ == 0 && !isAwaited()) {
    status_.waiting("the film starts when the silhouette of every camera is advertised");
    return;
  }
  const StudioInstant instant = studio_.render(next_++);
  const ros::Time stamp =
      node_options_.clock ? rosTime(kClockStart + instant.time_ns) : ros::Time::now();
  publish(instant, stamp);
  status_.count("instants");
  status_.good(instant.person ? "the person is in the room" : "the room is empty");
}

void StudioStage::publish(const StudioInstant& instant, const ros::Time& stamp) {
  if (node_options_.clock) {
    rosgraph_msgs::Clock clock;
    clock.clock = stamp;
    clock_.publish(clock);
  }
  std_msgs::Header header;
  header.stamp = stamp;
  for (size_t i = 0; i < images_.size(); ++i) {
    header.frame_id = opticalFrame(studio_.rig()[i]);
    sensor_msgs::CameraInfo info = messageFromCalibration(studio_.rig()[i].calibration());
    info.header = header;
    infos_[i].publish(info);
    publishShared(images_[i], messageFromMat(instant.images[i], header));
  }
  header.frame_id = node_options_.world_frame;
  if (instant.person) publishTruth(instant, header);
}

void StudioStage::publishTruth(const StudioInstant& instant, const std_msgs::Header& header) {
  BodyPose pose;
  pose.status = PoseStatus::kTracked;
  pose.T_world_body = instant.body.T_world_body;
  pose.angles = instant.body.angles;
  pose.part_seen.fill(true);
  truth_.publish(jointStateFromPose(studio_.model(), pose, header));
  broadcaster_.sendTransform(linkTransforms(studio_.model(), pose, header));
}

}  // namespace markerless_mocap
