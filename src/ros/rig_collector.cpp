#include "ros/rig_collector.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "camera/camera_difference.h"
#include "markerless_mocap/camera/rig_file.h"
#include "ros/camera_conversions.h"

namespace markerless_mocap {
namespace {

bool sameCalibration(const sensor_msgs::CameraInfo& a, const sensor_msgs::CameraInfo& b) {
  return a.header.frame_id == b.header.frame_id && a.width == b.width && a.height == b.height &&
         a.distortion_model == b.distortion_model && a.K == b.K && a.D == b.D;
}

constexpr double kSettled = 0.5;   // s that a change must stay
constexpr double kMoving = 3.0;    // s until a camera that shakes is told
constexpr int kMaxWanderings = 8;  // changes
constexpr double kMoved = 1e-3;    // m
constexpr double kTurned = 5e-4;   // rad; a tenth of a pixel in most cameras

double distance(const geometry_msgs::Transform& a, const geometry_msgs::Transform& b) {
  const auto &p = a.translation, &q = b.translation;
  return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
}

double angle(const geometry_msgs::Transform& a, const geometry_msgs::Transform& b) {
  const auto &p = a.rotation, &q = b.rotation;
  const Eigen::Quaterniond from(p.w, p.x, p.y, p.z), to(q.w, q.x, q.y, q.z);
  return from.angularDistance(to);
}

bool isMoved(const geometry_msgs::Transform& from, const geometry_msgs::Transform& to) {
  return distance(from, to) > kMoved || angle(from, to) > kTurned;
}

std::string distanceText(const geometry_msgs::Transform& from, const geometry_msgs::Transform& to) {
  char text[64];
  std::snprintf(text, sizeof text, "%.3f m and %.1f degrees", distance(from, to),
                angle(from, to) * 180.0 / M_PI);
  return text;
}

}  // namespace

RigCollector::RigCollector(std::vector<std::string> cameras, std::string world_frame,
                           const std::string& rig_file)
    : cameras_(std::move(cameras)),
      world_frame_(std::move(world_frame)),
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
  std::optional<Candidate>& candidate = candidates_[camera];
  if (!known) {
    known = info;
    return true;
  }
  if (sameCalibration(*known, info)) {
    candidate.reset();
  } else if (!candidate || !sameCalibration(candidate->info, info)) {
    candidate = Candidate{info, std::nullopt, false, false};
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
  if (!candidate || candidate->refused) return false;
  if (!candidate->since) judge(camera, now, &*candidate);
  if (now - *candidate->since < rest_) {
    if (candidate->misleads && !wandering.told)
      doubts_[camera] = subject + " has changed, it is left out until the new one stays";
    return false;
  }
  wandering = {};
  std::string why = refusalOf(camera, candidate->info);
  candidate->refused = !why.empty();
  const std::string& frame = candidate->info.header.frame_id;
  if (why.empty()) why = frame.empty() ? "its frame_id is empty" : unplaced(camera, frame, tf);
  remarks->push_back(subject + " has changed, " +
                     (why.empty() ? "the new one is used" : "but the new one is not used: " + why));
  if (!why.empty()) {
    // Not refused: its frame may still be connected. The camera goes on where it was, unless its
    // lens is another one.
    if (!candidate->refused && candidate->misleads) doubts_[camera] = why;
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

bool RigCollector::settlePose(size_t camera, const tf2::BufferCore& tf, double now,
                              std::vector<std::string>* remarks) {
  const std::string& frame = infos_[camera]->header.frame_id;
  if (!tf.canTransform(world_frame_, frame, ros::Time(0))) return false;
  const geometry_msgs::Transform pose =
      tf.lookupTransform(world_frame_, frame, ros::Time(0)).transform;
  std::optional<Placed>& placed = placed_[camera];
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
  for (size_t i = 0; i < cameras_.size(); ++i) {
    if (!infos_[i]) continue;
    doubts_[i].clear();
    changed = settleInfo(i, tf, now, remarks) || changed;
    changed = settlePose(i, tf, now, remarks) || changed;
    if (!doubts_[i].empty()) remarks->push_back(doubts_[i]);
  }
  if (!changed) return RigChange::kNone;
  return paused ? RigChange::kAfterPause : RigChange::kWhileUsed;
}

std::string RigCollector::missing(const tf2::BufferCore& tf) const {
  if (file_) return "";
  std::string without_info;
  for (size_t i = 0; i < cameras_.size(); ++i)
    if (!infos_[i]) without_info += (without_info.empty() ? "" : ", ") + cameras_[i];
  if (!without_info.empty()) return "no camera_info has been received from " + without_info;
  for (size_t i = 0; i < cameras_.size(); ++i)
    if (std::string why = unplaced(i, infos_[i]->header.frame_id, tf); !why.empty()) return why;
  return "";
}

CameraRig RigCollector::rig(const tf2::BufferCore& tf) const {
  if (file_) return *file_;
  const std::string reason = missing(tf);
  if (!reason.empty()) throw std::invalid_argument(reason);
  CameraRig rig;
  for (size_t i = 0; i < cameras_.size(); ++i) {
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
