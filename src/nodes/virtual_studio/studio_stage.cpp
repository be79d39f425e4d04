#include "nodes/virtual_studio/studio_stage.h"

#include <ros/param.h>
#include <rosgraph_msgs/Clock.h>

#include "camera/rig_calibrations.h"
#include "capture/ground_truth.h"
#include "nodes/common/master_answers.h"
#include "nodes/common/publish_shared.h"
#include "resources/resources.h"
#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"
#include "ros/package_files.h"
#include "ros/pose_conversions.h"
#include "ros/truth_conversions.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kClockStart = 1000'000'000'000;  // nanoseconds

StudioFiles filesFor(const StudioNodeOptions& options) {
  return {options.urdf_template.empty() ? humanUrdfTemplate()
                                        : readUrdfTemplate(options.urdf_template, options.body_id),
          packageFile("config/motions")};
}

}  // namespace

StudioStage::StudioStage(ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                         const StudioOptions& options, const StudioNodeOptions& node_options)
    : handle_(handle),
      node_options_(node_options),
      studio_(options, filesFor(node_options), node_options.body_id),
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
    masks_.push_back(
        handle.advertise<sensor_msgs::Image>("ground_truth/" + camera.name() + "/silhouette", 4));
  }
  joints_ = handle.advertise<JointPositions>("ground_truth/joints", 4);
  joint_states_ = handle.advertise<sensor_msgs::JointState>("ground_truth/joint_states", 4);
  if (node_options_.clock) clock_ = handle.advertise<rosgraph_msgs::Clock>("/clock", 4);
}

void StudioStage::publishRig() {
  static_broadcaster_.sendTransform(
      transformsOf(calibrationsOf(studio_.rig()), ros::Time(0), node_options_.world_frame)
          .transforms);
}

bool StudioStage::isAwaited() const {
  if (!node_options_.wait_for_silhouettes) return true;
  const auto advertised = advertisedTopics();
  if (!advertised) return false;
  for (size_t i = 0; i < images_.size(); ++i) {
    const std::string topic = handle_.resolveName(studio_.rig()[i].name() + "/silhouette");
    if (!advertised->count(topic) || images_[i].getNumSubscribers() == 0) return false;
  }
  return true;
}

void StudioStage::tick() {
  if (next_ == 0 && !isAwaited()) {
    status_.waiting("waiting until the silhouettes of all cameras are advertised");
    return;
  }
  const StudioFrameSet frame_set = studio_.render(next_++);
  const ros::Time stamp =
      node_options_.clock ? rosTime(kClockStart + frame_set.time_ns) : ros::Time::now();
  publish(frame_set, stamp);
  status_.count("frame sets");
  status_.ok(frame_set.person ? "the person is in the room" : "the room is empty");
}

void StudioStage::publish(const StudioFrameSet& frame_set, const ros::Time& stamp) {
  if (node_options_.clock) {
    rosgraph_msgs::Clock clock;
    clock.clock = stamp;
    clock_.publish(clock);
  }
  std_msgs::Header header;
  header.stamp = stamp;
  for (size_t i = 0; i < images_.size(); ++i) {
    header.frame_id = opticalFrame(studio_.rig()[i].name());
    publishCamera(i, frame_set, header);
  }
  header.frame_id = node_options_.world_frame;
  if (frame_set.person) publishTruth(frame_set, header);
}

void StudioStage::publishCamera(size_t i, const StudioFrameSet& frame_set,
                                const std_msgs::Header& header) {
  if (masks_[i].getNumSubscribers() > 0)
    publishShared(masks_[i], messageFromMat(frame_set.masks[i], header));
  if (frame_set.images[i].empty()) return;
  sensor_msgs::CameraInfo info = messageFromCalibration(studio_.rig()[i].calibration());
  info.header = header;
  infos_[i].publish(info);
  publishShared(images_[i], messageFromMat(frame_set.images[i], header));
}

void StudioStage::publishTruth(const StudioFrameSet& frame_set, const std_msgs::Header& header) {
  joints_.publish(messageFromPoints(groundTruthNames(), frame_set.points, header));
  joint_states_.publish(messageFromAngles(studio_.body(), frame_set.body.angles, header));
  BodyPose pose;
  pose.status = PoseStatus::kTracked;
  pose.T_world_body = frame_set.body.T_world_body;
  pose.angles = frame_set.body.angles;
  pose.part_seen.fill(true);
  broadcaster_.sendTransform(linkTransforms(studio_.body(), pose, header));
}

}  // namespace markerless_mocap
