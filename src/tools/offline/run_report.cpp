#include "tools/offline/run_report.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <utility>

#include "evaluation/body_silhouette.h"
#include "files/whole_file.h"
#include "markerless_mocap/products/silhouette_mask.h"
#include "markerless_mocap/silhouette/background_picture.h"
#include "ros/pose_conversions.h"
#include "tools/common/overlay.h"

namespace markerless_mocap {
namespace {

/// Links of parts that are not seen are not drawn.
std::vector<bool> seenLinks(const BodyModel& model, const BodyPose& pose) {
  std::vector<bool> seen(model.links().size(), true);
  for (const BodyJoint& joint : model.joints()) {
    const std::string base = joint.name.substr(0, joint.name.size() - model.id().size() - 1);
    seen[joint.child_link] = pose.part_seen[size_t(partOfJoint(base))];
  }
  return seen;
}

FrameStatus statusOf(PoseStatus status) {
  if (status == PoseStatus::kTracked) return FrameStatus::kTracked;
  return status == PoseStatus::kReinitialized ? FrameStatus::kReinitialized : FrameStatus::kLost;
}

double unknownShare(const cv::Mat& mask) {
  return mask.empty() ? NAN : cv::countNonZero(mask == kUnknownPixel) / double(mask.total());
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

RunReport::RunReport(std::string folder, const BodyModel& model, const CameraRig& rig,
                     std::optional<PoseFilter> filter, bool images)
    : folder_(std::move(folder)),
      model_(model),
      rig_(rig),
      filter_(std::move(filter)),
      images_(images),
      views_(images),
      has_recorded_masks_(rig.size(), false) {
  makeReportFolder(folder_);
  content_.cameras.resize(rig_.size());
  for (size_t i = 0; i < rig_.size(); ++i) content_.cameras[i].name = rig_[i].name();
}

std::vector<double> RunReport::add(const FrameSet& frame_set, const PipelineResult& result) {
  const size_t row = content_.rows.size();
  const std::vector<cv::Mat> bodies = bodyMasks(result.pose);
  const std::vector<double> overlaps = addViews(frame_set, result, bodies);
  const bool lost = result.pose.status == PoseStatus::kLost;
  content_.rows.push_back(
      {meanOfFinite(overlaps), lost ? NAN : result.pose.skeleton_error_m, result.pose.part_seen});
  addFrame(frame_set, result.pose);
  keepPictures(row, frame_set, result, bodies);
  return overlaps;
}

void RunReport::addFrame(const FrameSet& frame_set, const BodyPose& raw) {
  ResultFrame frame{frame_set.stamp_ns, statusOf(raw.status), raw.reason, {}, raw.part_sigma_m};
  const BodyPose pose = filter_ ? filter_->filtered(frame_set.stamp_ns, raw) : raw;
  if (pose.status != PoseStatus::kLost) {
    model_.forwardKinematics(pose.T_world_body, pose.angles, frame.T_world_link);
    const std::vector<bool> seen = seenLinks(model_, pose);
    for (size_t i = 0; i < seen.size(); ++i)
      if (!seen[i]) frame.T_world_link[i].matrix().setConstant(NAN);
  }
  content_.frames.push_back(std::move(frame));
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
    if (!images_)
      camera->background_source = "not shown: this report has no images";
    else if (!from_recording.empty() && from_recording[i])
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

void RunReport::keepPictures(size_t row, const FrameSet& frame_set, const PipelineResult& result,
                             const std::vector<cv::Mat>& bodies) {
  if (hulls_.wants(row)) hulls_.add(row, result.hull);
  if (views_.wants(row)) views_.add(row, rig_, frame_set.frames, result.masks, bodies);
  if (images_ && overlays_.wants(row))
    overlays_.add(row, overlayOf(rig_, frame_set.frames, result.masks, bodies), 1);
}

void RunReport::write(const std::string& title, const std::vector<std::string>& remarks) {
  content_.title = title;
  content_.remarks = remarks;
  for (const auto& [row, overlay] : overlays_.items()) {
    char name[32];
    std::snprintf(name, sizeof name, "/instant_%06zu.png", row);
    if (!cv::imwrite(folder_ + name, overlay.first))
      throw std::runtime_error("cannot write " + folder_ + name);
  }
  const PlayerContent player{&model_, true, &content_.frames, &rig_, &hulls_, &views_, nullptr, {}};
  writeWholeFile(folder_ + "/report.html", reportPage(content_, playerPart(player), model_).html());
}

}  // namespace markerless_mocap
