#include "nodes/visual_hull/camera_display.h"

#include <visualization_msgs/MarkerArray.h>

namespace markerless_mocap {
namespace {

constexpr double kInterval = 0.5, kSilence = 2.0;  // s
constexpr double kDepth = 0.5;                     // m

CameraHealth healthOf(const HullCameras& frame_set, size_t camera, bool present) {
  const std::string& reason = frame_set.reasons[camera];
  if (!present || !frame_set.usable[camera]) return {CameraHealth::kLeftOut, reason};
  return {reason.empty() ? CameraHealth::kUsed : CameraHealth::kDoubtful, reason};
}

}  // namespace

CameraDisplay::CameraDisplay(ros::NodeHandle& handle, size_t cameras)
    : health_(cameras),
      publisher_(handle.advertise<visualization_msgs::MarkerArray>("hull/cameras", 1, true)) {
  timer_ = handle.createWallTimer(ros::WallDuration(kInterval),
                                  gate_.guarded([this](const ros::WallTimerEvent&) { update(); }));
}

void CameraDisplay::setRig(const CameraRig& rig, const std_msgs::Header& header) {
  const std::lock_guard<std::mutex> lock(mutex_);
  rig_ = rig;
  header_ = header;
  changed_ = true;
}

void CameraDisplay::note(const HullCameras& frame_set, const std::vector<bool>& present) {
  const std::lock_guard<std::mutex> lock(mutex_);
  last_note_ = ros::SteadyTime::now().toSec();
  for (size_t i = 0; i < health_.size(); ++i) {
    const CameraHealth health = healthOf(frame_set, i, present[i]);
    changed_ = changed_ || health != health_[i];
    health_[i] = health;
  }
}

void CameraDisplay::update() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool silent = ros::SteadyTime::now().toSec() - last_note_ > kSilence;
  for (CameraHealth& health : health_) {
    if (!silent || health.state == CameraHealth::kSilent) continue;
    health = CameraHealth();
    changed_ = true;
  }
  if (!rig_ || !changed_) return;
  changed_ = false;
  publisher_.publish(cameraMarkers(*rig_, health_, header_, kDepth));
}

}  // namespace markerless_mocap
