#include "ros/rig_collector.h"

#include <tf2/exceptions.h>

#include <algorithm>
#include <stdexcept>

#include "camera/blind_camera.h"
#include "camera/camera_difference.h"
#include "markerless_mocap/camera/rig_file.h"
#include "ros/calibration_change.h"
#include "ros/camera_conversions.h"
#include "text/joined.h"

namespace markerless_mocap {
namespace {

constexpr double kSettled = 0.5;   // s that a change must stay
constexpr double kMoving = 3.0;    // s until a camera that shakes is told
constexpr int kMaxWanderings = 8;  // changes

}  // namespace

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

std::string RigCollector::refusalOf(size_t camera, const sensor_msgs::CameraInfo& info) const {
  const auto [width, height] = image_sizes_[camera];
  const auto fits = [width = width, height = height](const sensor_msgs::CameraInfo& i) {
    return int64_t(i.width) == width && int64_t(i.height) == height;
  };
  if (width > 0 && !fits(info) && fits(*infos_[camera]))
    return "it says " + std::to_string(info.width) + " x " + std::to_string(info.height) +
           " pixels, the images have " + std::to_string(width) + " x " + std::to_string(height);
  geometry_msgs::Transform anywhere;
  anywhere.rotation.w = 1.0;
  try {
    Camera(calibrationFromMessage(cameras_[camera], info, anywhere));
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

std::string RigCollector::frameRefusal(size_t camera, const std::string& frame,
                                       const tf2::BufferCore& tf) const {
  if (frame.empty()) return "its frame_id is empty";
  for (size_t i = 0; i < cameras_.size(); ++i)
    if (i != camera && infos_[i] && infos_[i]->header.frame_id == frame)
      return "its frame_id " + frame + " is that of " + cameras_[i] + ", allowed is one of its own";
  return unplaced(camera, frame, tf);
}

std::string RigCollector::unplaced(size_t camera, const std::string& frame,
                                   const tf2::BufferCore& tf) const {
  if (frame.empty()) return "camera_info of " + cameras_[camera] + " has an empty frame_id";
  if (tf.canTransform(world_frame_, frame, ros::Time(0))) return "";
  return "tf does not connect " + frame + " of " + cameras_[camera] + " to " + world_frame_;
}

bool RigCollector::settleInfo(size_t camera, const tf2::BufferCore& tf, double now,
                              std::vector<std::string>* remarks) {
  std::optional<Candidate>& candidate = candidates_[camera];
  const std::string subject = "camera_info of " + cameras_[camera];
  Wandering& wandering = wanderings_[camera];
  if (wandering.changes >= kMaxWanderings) {
    wandering.changes = 1;
    wandering.told = true;
    remarks->push_back(subject + " changes all the time; what came first is used");
  }
  if (!candidate && now - wandering.last > kSettled) wandering = {};
  if (!candidate) return false;
  if (!candidate->refusal.empty()) {
    remarks->push_back(candidate->refusal);
    return false;
  }
  if (!candidate->since) judge(camera, now, &*candidate);
  const bool known_is_usable = refusalOf(camera, *infos_[camera]).empty();
  if (known_is_usable && now - *candidate->since < rest_) {
    if (candidate->misleads && !wandering.told)
      doubts_[camera] = subject + " has changed, it is left out until the new one stays";
    return false;
  }
  wandering = {};
  const std::string impossible = refusalOf(camera, candidate->info);
  const std::string why =
      impossible.empty() ? frameRefusal(camera, candidate->info.header.frame_id, tf) : impossible;
  const std::string said =
      subject + " has changed, " +
      (why.empty() ? "the new one is used" : "but the new one is not used: " + why);
  remarks->push_back(said);
  if (!impossible.empty()) candidate->refusal = said;
  if (!why.empty()) {
    // The frame may still become its own, or connected. The camera goes on where it was, unless its
    // lens is another one.
    if (impossible.empty() && candidate->misleads) doubts_[camera] = why;
    return false;
  }
  infos_[camera] = candidate->info;
  candidate.reset();
  placed_[camera].reset();
  return true;
}

void RigCollector::judge(size_t camera, double now, Candidate* candidate) {
  candidate->since = wanderings_[camera].last = now;
  if (wanderings_[camera].told || !refusalOf(camera, candidate->info).empty()) return;
  geometry_msgs::Transform anywhere;
  anywhere.rotation.w = 1.0;
  const auto seen = [&](const sensor_msgs::CameraInfo& info) {
    return Camera(calibrationFromMessage(cameras_[camera], info, anywhere));
  };
  try {
    candidate->misleads = seeDifferently(seen(*infos_[camera]), seen(candidate->info));
  } catch (const std::invalid_argument&) {
    // The one of before is no camera's, so it is not used.
  }
}

bool RigCollector::misleads(size_t camera, const Placed& placed) const {
  const auto from = [&](const geometry_msgs::Transform& pose) {
    return Camera(calibrationFromMessage(cameras_[camera], *infos_[camera], pose));
  };
  try {
    return seeDifferently(from(placed.used), from(placed.seen));
  } catch (const std::invalid_argument&) {
    return true;  // it has gone where no camera can be
  }
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

bool RigCollector::settlePose(size_t camera, const tf2::BufferCore& tf, double now,
                              std::vector<std::string>* remarks) {
  std::optional<Placed>& placed = placed_[camera];
  geometry_msgs::Transform pose;
  if (const std::string why = findPose(camera, tf, &pose); !why.empty()) {
    if (placed) remarks->push_back(why + "; " + cameras_[camera] + " is used where it was before");
    return false;
  }
  if (!placed) placed = Placed{pose, pose, now, now};
  if (isMoved(placed->seen, pose)) {
    placed->seen = pose;
    placed->seen_since = now;
  }
  if (!isMoved(placed->used, placed->seen)) {
    placed->used_until = now;
    return false;
  }
  if (now - placed->seen_since < rest_) {
    if (misleads(camera, *placed))
      doubts_[camera] = cameras_[camera] + " has moved by tf, it is left out until it rests";
    else if (now - placed->used_until > kMoving)
      remarks->push_back(cameras_[camera] + " moves by tf; it is used where it was before");
    return false;
  }
  remarks->push_back(cameras_[camera] + " has moved by " + distanceText(placed->used, pose) +
                     " by tf, its new pose is used");
  placed = Placed{pose, pose, now, now};
  return true;
}

RigChange RigCollector::settle(const tf2::BufferCore& tf, double now,
                               std::vector<std::string>* remarks) {
  if (file_) return RigChange::kNone;
  const bool paused = last_look_ && now - *last_look_ > kSettled;
  last_look_ = now;
  rest_ = paused ? 0.0 : kSettled;
  bool changed = false;
  std::vector<std::string> lacks(cameras_.size());
  for (size_t i = 0; i < cameras_.size(); ++i) {
    doubts_[i].clear();
    if (infos_[i]) {
      changed = settleInfo(i, tf, now, remarks) || changed;
      changed = settlePose(i, tf, now, remarks) || changed;
      if (!doubts_[i].empty()) remarks->push_back(doubts_[i]);
    }
    lacks[i] = lackOf(i, tf);
  }
  changed = lacking_.settle(lacks, now, remarks) || changed;
  for (size_t i = 0; i < cameras_.size(); ++i)
    if (lacking_.isLeftOut(i)) doubts_[i] = lacks[i];
  if (!changed) return RigChange::kNone;
  return paused ? RigChange::kAfterPause : RigChange::kWhileUsed;
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
