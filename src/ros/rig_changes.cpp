// How RigCollector takes over what changes about the cameras.
#include <stdexcept>

#include "camera/camera_difference.h"
#include "ros/calibration_change.h"
#include "ros/camera_conversions.h"
#include "ros/rig_collector.h"

namespace markerless_mocap {
namespace {

constexpr double kSettled = 0.5;   // s that a change must stay
constexpr double kMoving = 3.0;    // s until a camera that shakes is told
constexpr int kMaxWanderings = 8;  // changes

}  // namespace

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

bool RigCollector::settleInfo(size_t camera, const tf2::BufferCore& tf, double now,
                              std::vector<std::string>* remarks) {
  watchWandering(camera, now, remarks);
  std::optional<Candidate>& candidate = candidates_[camera];
  if (!candidate) return false;
  if (!candidate->refusal.empty()) {
    remarks->push_back(candidate->refusal);
    return false;
  }
  if (!candidate->since) judge(camera, now, &*candidate);
  const bool known_is_usable = refusalOf(camera, *infos_[camera]).empty();
  if (known_is_usable && now - *candidate->since < rest_) {
    if (candidate->misleads && !wanderings_[camera].told)
      doubts_[camera] = "camera_info of " + cameras_[camera] +
                        " has changed, it is left out until the new one stays";
    return false;
  }
  wanderings_[camera] = {};
  return takeInfo(camera, tf, remarks);
}

void RigCollector::watchWandering(size_t camera, double now, std::vector<std::string>* remarks) {
  Wandering& wandering = wanderings_[camera];
  if (wandering.changes >= kMaxWanderings) {
    wandering.changes = 1;
    wandering.told = true;
    remarks->push_back("camera_info of " + cameras_[camera] +
                       " changes all the time; what came first is used");
  }
  if (!candidates_[camera] && now - wandering.last > kSettled) wandering = {};
}

bool RigCollector::takeInfo(size_t camera, const tf2::BufferCore& tf,
                            std::vector<std::string>* remarks) {
  std::optional<Candidate>& candidate = candidates_[camera];
  const std::string impossible = refusalOf(camera, candidate->info);
  const std::string why =
      impossible.empty() ? frameRefusal(camera, candidate->info.header.frame_id, tf) : impossible;
  const std::string said =
      "camera_info of " + cameras_[camera] + " has changed, " +
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

}  // namespace markerless_mocap
