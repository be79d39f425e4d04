#include "ros/rig_collector.h"

#include <tf2/exceptions.h>

#include <algorithm>
#include <stdexcept>

#include "camera/blind_camera.h"
#include "markerless_mocap/camera/rig_file.h"
#include "ros/calibration_change.h"
#include "ros/camera_conversions.h"
#include "text/joined.h"

namespace markerless_mocap {
RigCollector::RigCollector(std::vector<std::string> cameras, std::string world_frame,
                           const std::string& rig_file, size_t required)
    : cameras_(std::move(cameras)),
      world_frame_(std::move(world_frame)),
      lacking_(cameras_, std::min(required, cameras_.size())),
      infos_(cameras_.size()),
      candidates_(cameras_.size()),
      wanderings_(cameras_.size()),
      placed_(cameras_.size()),
      doubts_(cameras_.size()),
      image_sizes_(cameras_.size(), {0, 0}) {
  if (rig_file.empty()) return;
  const std::vector<CameraCalibration> rig = readRig(rig_file);
  const std::vector<CameraCalibration> wanted = camerasNamed(cameras_, rig, rig_file);
  file_.emplace(wanted.begin(), wanted.end());
  std::string spare;
  for (const CameraCalibration& camera : rig)
    if (std::find(cameras_.begin(), cameras_.end(), camera.name) == cameras_.end())
      addWord(&spare, camera.name);
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
  std::optional<Candidate>& candidate = candidates_[camera];
  if (!known) {
    known = info;
    return !lacking_.isLeftOut(camera);
  }
  if (sameCalibration(*known, info)) {
    candidate.reset();
  } else if (!candidate || !sameCalibration(candidate->info, info)) {
    candidate = Candidate{info, std::nullopt, "", false};
    ++wanderings_[camera].changes;
  }
  return false;
}

void RigCollector::noteImageSize(size_t camera, int width, int height) {
  image_sizes_.at(camera) = {width, height};
}

std::string RigCollector::unplaced(size_t camera, const std::string& frame,
                                   const tf2::BufferCore& tf) const {
  if (frame.empty()) return "camera_info of " + cameras_[camera] + " has an empty frame_id";
  if (tf.canTransform(world_frame_, frame, ros::Time(0))) return "";
  return "tf does not connect " + frame + " of " + cameras_[camera] + " to " + world_frame_;
}

std::string RigCollector::findPose(size_t camera, const tf2::BufferCore& tf,
                                   geometry_msgs::Transform* pose) const {
  const sensor_msgs::CameraInfo& info = *infos_[camera];
  try {
    const std::string why = unplaced(camera, info.header.frame_id, tf);
    if (!why.empty()) return why;
    *pose = tf.lookupTransform(world_frame_, info.header.frame_id, ros::Time(0)).transform;
    const std::optional<Placed>& placed = placed_[camera];
    if (!placed || isMoved(placed->seen, *pose))
      Camera(calibrationFromMessage(cameras_[camera], info, *pose));
  } catch (const std::exception& error) {  // of tf, or no camera can be there
    return error.what();
  }
  return "";
}

std::string RigCollector::lackOf(size_t camera, const tf2::BufferCore& tf) const {
  if (!infos_[camera]) return "no camera_info has been received from " + cameras_[camera];
  geometry_msgs::Transform pose;
  return placed_[camera] ? "" : findPose(camera, tf, &pose);
}

std::string RigCollector::missing(const tf2::BufferCore& tf) const {
  if (file_) return "";
  std::string without_info;
  for (size_t i = 0; i < cameras_.size(); ++i)
    if (!infos_[i] && !lacking_.isLeftOut(i)) addWord(&without_info, cameras_[i]);
  if (!without_info.empty()) return "no camera_info has been received from " + without_info;
  for (size_t i = 0; i < cameras_.size(); ++i) {
    if (placed_[i] || lacking_.isLeftOut(i)) continue;
    if (std::string why = unplaced(i, infos_[i]->header.frame_id, tf); !why.empty()) return why;
  }
  return "";
}

bool RigCollector::dependsOn(const std::string& frame, const tf2::BufferCore& tf) const {
  constexpr int kDeepest = 64;  // frames; more are a loop
  for (const std::optional<sensor_msgs::CameraInfo>& info : infos_) {
    std::string at = info ? info->header.frame_id : "";
    for (int i = 0; i < kDeepest && !at.empty(); ++i) {
      if (at == frame) return true;
      std::string parent;
      at = tf._getParent(at, ros::Time(0), parent) ? parent : "";
    }
  }
  return false;
}

CameraRig RigCollector::rig(const tf2::BufferCore& tf) const {
  if (file_) return *file_;
  const std::string reason = missing(tf);
  if (!reason.empty()) throw std::invalid_argument(reason);
  CameraRig rig;
  for (size_t i = 0; i < cameras_.size(); ++i) {
    if (lacking_.isLeftOut(i)) {
      rig.push_back(blindCamera(cameras_[i]));
      continue;
    }
    // A camera that moves is where it was before, or doubtOf() would not tell its error.
    const geometry_msgs::Transform pose =
        placed_[i]
            ? placed_[i]->used
            : tf.lookupTransform(world_frame_, infos_[i]->header.frame_id, ros::Time(0)).transform;
    rig.emplace_back(calibrationFromMessage(cameras_[i], *infos_[i], pose));
  }
  return rig;
}

}  // namespace markerless_mocap
