#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>
#include <tf2_ros/transform_listener.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "markerless_mocap/camera/rig_file.h"
#include "ros/camera_conversions.h"
#include "ros/rig_recorder.h"
#include "tools/check/check_recording.h"
#include "tools/common/recorded_cameras.h"

namespace markerless_mocap {
namespace {

constexpr int kQueue = 30;       // images
constexpr double kBehind = 0.5;  // s after which only the stamps of an image are looked at
constexpr int kThreads = 4;

std::map<std::string, std::string> runningTopics() {
  ros::master::V_TopicInfo topics;
  if (!ros::master::getTopics(topics)) throw std::runtime_error("there is no ROS master");
  std::map<std::string, std::string> types;
  for (const ros::master::TopicInfo& topic : topics) types[topic.name] = topic.datatype;
  return types;
}

/// One camera that runs. Its callbacks may come from several threads.
class LiveCamera {
 public:
  LiveCamera(ros::NodeHandle& handle, const RecordedCamera& camera,
             const SilhouetteOptions& silhouette, double picture_every)
      : picture_every_(picture_every),
        recorder_(camera.name, silhouette, camera.image_topic.empty()) {
    listen<sensor_msgs::CameraInfo>(handle, camera.info_topic, &LiveCamera::takeInfo);
    const std::string& topic =
        camera.image_topic.empty() ? camera.silhouette_topic : camera.image_topic;
    if (topic.size() > 11 && topic.compare(topic.size() - 11, 11, "/compressed") == 0)
      listen<sensor_msgs::CompressedImage>(handle, topic,
                                           &LiveCamera::takeImage<sensor_msgs::CompressedImage>);
    else
      listen<sensor_msgs::Image>(handle, topic, &LiveCamera::takeImage<sensor_msgs::Image>);
  }

  void useCalibration(const CameraCalibration& calibration) {
    const std::lock_guard<std::mutex> lock(mutex_);
    recorder_.useCalibration(calibration);
  }

  SeenCamera seen(const tf2::BufferCore& tf, const std::string& world, double seconds) {
    const std::lock_guard<std::mutex> lock(mutex_);
    recorder_.forgetBefore(nanosecondsOf(ros::Time::now()) - std::llround(1e9 * seconds));
    return recorder_.seen(tf, world);
  }

 private:
  template <class Message, class Take>
  void listen(ros::NodeHandle& handle, const std::string& topic, Take take) {
    if (topic.empty()) return;
    subscribers_.push_back(
        handle.subscribe<Message>(topic, kQueue,
                                  boost::function<void(const ros::MessageEvent<Message const>&)>(
                                      [this, take](const ros::MessageEvent<Message const>& event) {
                                        const std::lock_guard<std::mutex> lock(mutex_);
                                        (this->*take)(event);
                                      })));
  }

  void takeInfo(const ros::MessageEvent<sensor_msgs::CameraInfo const>& event) {
    recorder_.add(*event.getMessage(), nanosecondsOf(event.getReceiptTime()));
  }

  template <class Message>
  void takeImage(const ros::MessageEvent<Message const>& event) {
    const ros::Time received = event.getReceiptTime();
    const bool picture = (received - last_picture_).toSec() > picture_every_;
    if (picture) last_picture_ = received;
    const bool behind = (ros::Time::now() - received).toSec() > kBehind;
    recorder_.add(*event.getMessage(), nanosecondsOf(received), {!behind, picture});
  }

  double picture_every_;
  ros::Time last_picture_;
  std::mutex mutex_;
  CameraRecorder recorder_;
  std::vector<ros::Subscriber> subscribers_;
};

class LiveRig {
 public:
  LiveRig(const CheckArguments& arguments, const PipelineOptions& pipeline)
      : arguments_(arguments), listener_(tf_) {
    rig_.world_frame = arguments.world_frame;
    if (pipeline.hull.volume == "explicit")
      rig_.volume = {pipeline.hull.volume_min, pipeline.hull.volume_max};
    const auto cameras = listCameras(runningTopics(), arguments.cameras, "the running system");
    std::vector<std::string> names;
    for (const RecordedCamera& camera : cameras) {
      cameras_.emplace_back(handle_, camera, pipeline.silhouette, arguments.live / kPictures);
      names.push_back(camera.name);
    }
    if (arguments.rig.empty()) return;
    const auto calibrations = camerasNamed(names, readRig(arguments.rig), arguments.rig);
    for (size_t i = 0; i < cameras_.size(); ++i) cameras_[i].useCalibration(calibrations[i]);
  }

  SeenRig seen() {
    SeenRig rig = rig_;
    for (LiveCamera& camera : cameras_)
      rig.cameras.push_back(camera.seen(tf_, rig.world_frame, arguments_.live));
    return rig;
  }

 private:
  CheckArguments arguments_;
  SeenRig rig_;
  ros::NodeHandle handle_;
  tf2_ros::Buffer tf_;
  tf2_ros::TransformListener listener_;
  std::deque<LiveCamera> cameras_;
};

diagnostic_msgs::DiagnosticStatus statusOf(const std::string& camera, const Findings& findings) {
  diagnostic_msgs::DiagnosticStatus status;
  status.name = "check_recording: " + (camera.empty() ? std::string("rig") : camera);
  status.hardware_id = camera;
  status.message = "nothing wrong was found";
  for (const Finding& finding : findings) {
    if (finding.camera != camera) continue;
    const bool first = status.values.empty();
    status.message = first ? finding.what : status.message + ", " + finding.what;
    const auto level = finding.severity == Severity::kError     ? status.ERROR
                       : finding.severity == Severity::kWarning ? status.WARN
                                                                : status.OK;
    status.level = std::max<uint8_t>(status.level, level);
    diagnostic_msgs::KeyValue value;
    value.key = finding.what;
    value.value = finding.evidence + "; " + finding.remedy;
    status.values.push_back(value);
  }
  return status;
}

/// One status for the rig, for each camera, and for each pair that a finding names.
diagnostic_msgs::DiagnosticArray diagnosticsOf(const CheckResult& result) {
  diagnostic_msgs::DiagnosticArray array;
  array.header.stamp = ros::Time::now();
  std::vector<std::string> names = result.cameras;
  names.insert(names.begin(), "");
  for (const Finding& finding : result.findings)
    if (std::find(names.begin(), names.end(), finding.camera) == names.end())
      names.push_back(finding.camera);
  for (const std::string& name : names) array.status.push_back(statusOf(name, result.findings));
  return array;
}

}  // namespace

CheckResult checkLive(const CheckArguments& arguments, const PipelineOptions& pipeline) {
  ros::AsyncSpinner spinner(kThreads);
  LiveRig rig(arguments, pipeline);
  ros::NodeHandle handle;
  auto diagnostics = handle.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 10);
  spinner.start();
  std::optional<CheckResult> result;
  do {
    ros::Duration(arguments.live).sleep();
    if (!ros::ok()) break;
    result = resultOf(rig.seen(), "live");
    diagnostics.publish(diagnosticsOf(*result));
  } while (arguments.repeat);
  spinner.stop();
  if (!result) throw std::runtime_error("interrupted before anything was checked");
  return *result;
}

}  // namespace markerless_mocap
