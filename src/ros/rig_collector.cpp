#include "ros/rig_collector.h"

#include <algorithm>
#include <stdexcept>

#include "markerless_mocap/camera/rig_file.h"
#include "ros/camera_conversions.h"

namespace markerless_mocap {
namespace {

bool sameCalibration(const sensor_msgs::CameraInfo& a, const sensor_msgs::CameraInfo& b) {
  return a.header.frame_id == b.header.frame_id && a.width == b.width && a.height == b.height &&
         a.distortion_model == b.distortion_model && a.K == b.K && a.D == b.D;
}

}  // namespace

RigCollector::RigCollector(std::vector<std::string> cameras, std::string world_frame,
                           const std::string& rig_file)
    : cameras_(std::move(cameras)), world_frame_(std::move(world_frame)), infos_(cameras_.size()) {
  if (rig_file.empty()) return;
  const std::vector<CameraCalibration> rig = readRig(rig_file);
  const std::vector<CameraCalibration> wanted = camerasNamed(cameras_, rig, rig_file);
  file_.emplace(wanted.begin(), wanted.end());
  std::string spare;
  for (const CameraCalibration& camera : rig)
    if (std::find(cameras_.begin(), cameras_.end(), camera.name) == cameras_.end())
      spare += (spare.empty() ? "" : ", ") + camera.name;
  if (!spare.empty()) unused_cameras_ = rig_file + " also has " + spare + ", which is not used";
}

std::vector<double> RigCollector::timeOffsets() const {
  std::vector<double> offsets;
  bool any = false;
  for (const Camera& camera : file_.value_or(CameraRig())) {
    offsets.push_back(camera.calibration().time_offset);
    any = any || offsets.back() != 0.0;
  }
  return any ? offsets : std::vector<double>();
}

bool RigCollector::add(size_t camera, const sensor_msgs::CameraInfo& info) {
  if (file_) return false;
  std::optional<sensor_msgs::CameraInfo>& known = infos_.at(camera);
  if (known && sameCalibration(*known, info)) return false;
  known = info;
  return true;
}

std::string RigCollector::missing(const tf2::BufferCore& tf) const {
  if (file_) return "";
  std::string without_info;
  for (size_t i = 0; i < cameras_.size(); ++i)
    if (!infos_[i]) without_info += (without_info.empty() ? "" : ", ") + cameras_[i];
  if (!without_info.empty()) return "no camera_info has been received from " + without_info;
  for (size_t i = 0; i < cameras_.size(); ++i) {
    const std::string& frame = infos_[i]->header.frame_id;
    if (frame.empty()) return "camera_info of " + cameras_[i] + " has an empty frame_id";
    if (!tf.canTransform(world_frame_, frame, ros::Time(0)))
      return "tf does not connect " + frame + " of " + cameras_[i] + " to " + world_frame_;
  }
  return "";
}

CameraRig RigCollector::rig(const tf2::BufferCore& tf) const {
  if (file_) return *file_;
  const std::string reason = missing(tf);
  if (!reason.empty()) throw std::invalid_argument(reason);
  CameraRig rig;
  for (size_t i = 0; i < cameras_.size(); ++i) {
    const auto transform =
        tf.lookupTransform(world_frame_, infos_[i]->header.frame_id, ros::Time(0));
    rig.emplace_back(calibrationFromMessage(cameras_[i], *infos_[i], transform.transform));
  }
  return rig;
}

}  // namespace markerless_mocap
