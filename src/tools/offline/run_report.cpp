#include "tools/offline/run_report.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numeric>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <utility>

#include "evaluation/body_silhouette.h"
#include "ros/package_files.h"
#include "ros/pose_conversions.h"
#include "tools/common/overlay.h"

namespace markerless_mocap {
namespace {

constexpr size_t kMaxPictures = 8;

/// Links of parts that are not seen are not drawn.
std::vector<bool> seenLinks(const BodyModel& model, const BodyPose& pose) {
  std::vector<bool> seen(model.links().size(), true);
  for (const BodyJoint& joint : model.joints()) {
    const std::string base = joint.name.substr(0, joint.name.size() - model.id().size() - 1);
    seen[joint.child_link] = pose.part_seen[size_t(partOfJoint(base))];
  }
  return seen;
}

double meanOf(const std::vector<double>& values) {
  return values.empty() ? NAN : std::accumulate(values.begin(), values.end(), 0.0) / values.size();
}

std::string captionOf(const FrameSet& frame_set, const BodyPose& pose, double mean_iou) {
  char text[96];
  std::snprintf(text, sizeof text, "%.3f s, %s", frame_set.stamp_ns * 1e-9, toString(pose.status));
  std::string caption = text;
  if (std::isfinite(mean_iou)) {
    std::snprintf(text, sizeof text, ", mean IoU %.2f", mean_iou);
    caption += text;
  }
  return pose.reason.empty() ? caption : caption + ": " + pose.reason;
}

}  // namespace

RunReport::RunReport(std::string folder, const BodyModel& model, const CameraRig& rig)
    : folder_(std::move(folder)),
      model_(model),
      rig_(rig),
      iou_sum_(rig.size(), 0.0),
      iou_count_(rig.size(), 0) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw std::runtime_error("cannot make the folder " + folder_);
  for (const Camera& camera : rig_) content_.cameras.push_back(camera.name());
}

std::vector<double> RunReport::add(const FrameSet& frame_set, const PipelineResult& result) {
  const std::vector<cv::Mat> bodies = bodyMasks(result.pose);
  std::vector<double> overlaps;
  for (size_t i = 0; i < bodies.size(); ++i) {
    if (result.masks[i].empty()) continue;
    overlaps.push_back(maskIou(bodies[i], result.masks[i]));
    iou_sum_[i] += overlaps.back();
    ++iou_count_[i];
  }
  const bool lost = result.pose.status == PoseStatus::kLost;
  const double mean = meanOf(overlaps);
  content_.rows.push_back({frame_set.stamp_ns, result.pose.status, result.pose.reason, mean,
                           lost ? NAN : result.pose.skeleton_error_m});
  keepPicture(frame_set, result, bodies, captionOf(frame_set, result.pose, mean));
  return overlaps;
}

std::vector<cv::Mat> RunReport::bodyMasks(const BodyPose& pose) const {
  if (pose.status == PoseStatus::kLost) return {};
  LinkPoses T_world_link;
  model_.forwardKinematics(pose.T_world_body, pose.angles, T_world_link);
  const std::vector<bool> seen = seenLinks(model_, pose);
  std::vector<cv::Mat> bodies;
  for (const Camera& camera : rig_)
    bodies.push_back(bodySilhouette(model_, T_world_link, camera, seen));
  return bodies;
}

void RunReport::keepPicture(const FrameSet& frame_set, const PipelineResult& result,
                            const std::vector<cv::Mat>& bodies, const std::string& caption) {
  const size_t row = content_.rows.size() - 1;
  if (row % picture_stride_ != 0) return;
  content_.pictures.push_back({caption, overlayOf(rig_, frame_set.frames, result.masks, bodies)});
  picture_rows_.push_back(row);
  if (picture_rows_.size() <= kMaxPictures) return;
  // Too many overlays: every second one is removed, and the stride is doubled.
  picture_stride_ *= 2;
  for (size_t i = 0; 2 * i < picture_rows_.size(); ++i) {
    picture_rows_[i] = picture_rows_[2 * i];
    content_.pictures[i] = content_.pictures[2 * i];
  }
  picture_rows_.resize((picture_rows_.size() + 1) / 2);
  content_.pictures.resize(picture_rows_.size());
}

void RunReport::write(const std::string& title, const std::vector<std::string>& remarks) {
  content_.title = title;
  content_.remarks = remarks;
  content_.iou_of_camera.clear();
  for (size_t i = 0; i < rig_.size(); ++i)
    content_.iou_of_camera.push_back(iou_count_[i] ? iou_sum_[i] / iou_count_[i] : NAN);
  for (size_t i = 0; i < picture_rows_.size(); ++i) {
    char name[32];
    std::snprintf(name, sizeof name, "/instant_%06zu.png", picture_rows_[i]);
    if (!cv::imwrite(folder_ + name, content_.pictures[i].image))
      throw std::runtime_error("cannot write " + folder_ + name);
  }
  writeText(folder_ + "/report.html", reportPage(content_));
}

}  // namespace markerless_mocap
