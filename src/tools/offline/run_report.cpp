#include "tools/offline/run_report.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <utility>

#include "evaluation/body_silhouette.h"
#include "markerless_mocap/products/silhouette_mask.h"
#include "markerless_mocap/silhouette/background_picture.h"
#include "ros/package_files.h"
#include "ros/pose_conversions.h"
#include "tools/common/overlay.h"
#include "tools/offline/report_cameras.h"

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

double unknownShare(const cv::Mat& mask) {
  return mask.empty() ? NAN : cv::countNonZero(mask == kUnknownPixel) / double(mask.total());
}

std::vector<cv::Mat> viewsOf(const CameraRig& rig, const FrameSet& frame_set,
                             const std::vector<cv::Mat>& masks,
                             const std::vector<cv::Mat>& bodies) {
  std::vector<cv::Mat> views;
  for (size_t i = 0; i < rig.size(); ++i)
    views.push_back(
        evidenceOf(rig[i], frame_set.frames[i], masks[i], bodies.empty() ? cv::Mat() : bodies[i]));
  return views;
}

void show(const Background& background, const std::string& source, ReportCamera* camera) {
  const BackgroundPicture picture = pictureOf(background);
  camera->background = unknownTinted(picture.colors, picture.unknown);
  camera->background_unknown = unknownFraction(background);
  camera->background_source = source;
}

}  // namespace

void makeReportFolder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || access(folder.c_str(), W_OK | X_OK) != 0)
    throw std::runtime_error("cannot make the folder " + folder + " or write into it");
}

RunReport::RunReport(std::string folder, const BodyModel& model, const CameraRig& rig)
    : folder_(std::move(folder)), model_(model), rig_(rig), has_recorded_masks_(rig.size(), false) {
  makeReportFolder(folder_);
  content_.cameras.resize(rig_.size());
  for (size_t i = 0; i < rig_.size(); ++i) content_.cameras[i].name = rig_[i].name();
}

std::vector<double> RunReport::add(const FrameSet& frame_set, const PipelineResult& result) {
  const std::vector<cv::Mat> bodies = bodyMasks(result.pose);
  const std::vector<double> overlaps = addViews(frame_set, result, bodies);
  const bool lost = result.pose.status == PoseStatus::kLost;
  const double mean = meanOfFinite(overlaps);
  content_.rows.push_back({frame_set.stamp_ns, result.pose.status, result.pose.reason, mean,
                           lost ? NAN : result.pose.skeleton_error_m, result.pose.part_seen,
                           result.pose.part_sigma_m});
  keepPicture(frame_set, result, bodies, captionOf(frame_set, result.pose, mean));
  return overlaps;
}

std::vector<double> RunReport::addViews(const FrameSet& frame_set, const PipelineResult& result,
                                        const std::vector<cv::Mat>& bodies) {
  std::vector<double> overlaps;
  for (size_t i = 0; i < rig_.size(); ++i) {
    const cv::Mat& mask = result.masks[i];
    const bool comparable = !bodies.empty() && !mask.empty();
    const double iou = comparable ? maskIou(bodies[i], mask) : NAN;
    content_.cameras[i].iou_of_row.push_back(iou);
    content_.cameras[i].unknown_of_row.push_back(unknownShare(mask));
    has_recorded_masks_[i] |= !frame_set.frames[i].mask.empty();
    if (comparable) overlaps.push_back(iou);
  }
  return overlaps;
}

void RunReport::addBackgrounds(const std::vector<SharedBackground>& from_recording,
                               const std::vector<SharedBackground>& in_use) {
  for (size_t i = 0; i < rig_.size(); ++i) {
    ReportCamera* camera = &content_.cameras[i];
    if (!from_recording.empty() && from_recording[i])
      show(*from_recording[i], "learned from the whole recording", camera);
    else if (in_use[i])
      show(*in_use[i], "learned from the first images, as it is at the end of the run", camera);
    else if (has_recorded_masks_[i])
      camera->background_source = "none, as the masks were recorded";
    else
      camera->background_source = "none to show: no images, or a model without a picture of it";
  }
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
  content_.pictures.push_back({caption, overlayOf(rig_, frame_set.frames, result.masks, bodies),
                               viewsOf(rig_, frame_set, result.masks, bodies)});
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
  for (size_t i = 0; i < picture_rows_.size(); ++i) {
    char name[32];
    std::snprintf(name, sizeof name, "/instant_%06zu.png", picture_rows_[i]);
    if (!cv::imwrite(folder_ + name, content_.pictures[i].image))
      throw std::runtime_error("cannot write " + folder_ + name);
  }
  writeText(folder_ + "/report.html", reportPage(content_));
}

}  // namespace markerless_mocap
