#include "tools/offline/run_report.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <utility>

#include "evaluation/body_silhouette.h"
#include "evaluation/joint_error.h"
#include "files/whole_file.h"
#include "markerless_mocap/products/silhouette_mask.h"
#include "markerless_mocap/silhouette/background_picture.h"
#include "ros/pose_conversions.h"
#include "tools/common/overlay.h"
#include "tracking/part_of_joint.h"

namespace markerless_mocap {
namespace {

/// Links of parts that are not seen are not drawn.
std::vector<bool> seenLinks(const BodyModel& model, const BodyPose& pose) {
  std::vector<bool> seen(model.links().size());
  for (size_t link = 0; link < seen.size(); ++link)
    seen[link] = pose.part_seen[size_t(partOfLink(model, int(link)))];
  return seen;
}

FrameStatus statusOf(PoseStatus status) {
  if (status == PoseStatus::kTracked) return FrameStatus::kTracked;
  return status == PoseStatus::kReinitialized ? FrameStatus::kReinitialized : FrameStatus::kLost;
}

/// With the first.
template <class Item>
void keepEverySecond(std::vector<Item>* items) {
  size_t kept = 0;
  for (size_t i = 0; i < items->size(); i += 2) std::swap((*items)[kept++], (*items)[i]);
  items->resize(kept);
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
                     std::optional<PoseFilter> filter, bool images, size_t max_frames)
    : folder_(std::move(folder)),
      model_(model),
      rig_(rig),
      filter_(std::move(filter)),
      images_(images),
      max_frames_(max_frames),
      views_(images),
      has_recorded_masks_(rig.size(), false) {
  makeReportFolder(folder_);
  content_.cameras.resize(rig_.size());
  for (size_t i = 0; i < rig_.size(); ++i) content_.cameras[i].name = rig_[i].name();
}

std::vector<double> RunReport::add(const FrameSet& frame_set, const PipelineResult& result) {
  const bool shown = frame_sets_++ % step_ == 0;
  const std::vector<cv::Mat> bodies = bodyMasks(result.pose);
  const std::vector<double> ious = overlapsOf(frame_set, result, bodies);
  std::vector<double> overlaps;
  for (const double iou : ious)
    if (!std::isnan(iou)) overlaps.push_back(iou);
  ResultFrame frame = frameOf(frame_set, result.pose);  // the filter needs all frames
  if (!shown) return overlaps;
  const size_t row = content_.rows.size();
  const bool lost = result.pose.status == PoseStatus::kLost;
  content_.rows.push_back({summaryStatistics(overlaps).mean,
                           lost ? NAN : result.pose.skeleton_error_m, result.pose.part_seen});
  content_.frames.push_back(std::move(frame));
  for (size_t i = 0; i < ious.size(); ++i) {
    content_.cameras[i].iou_of_row.push_back(ious[i]);
    content_.cameras[i].unknown_of_row.push_back(unknownShare(result.masks[i]));
  }
  keepPictures(row, frame_set, result, bodies);
  if (content_.rows.size() > max_frames_) halveFrames();
  return overlaps;
}

void RunReport::halveFrames() {
  keepEverySecond(&content_.rows);
  keepEverySecond(&content_.frames);
  for (ReportCamera& camera : content_.cameras) {
    keepEverySecond(&camera.iou_of_row);
    keepEverySecond(&camera.unknown_of_row);
  }
  hulls_.halveFrames();
  views_.halveFrames();
  overlays_.halveFrames();
  step_ *= 2;
}

ResultFrame RunReport::frameOf(const FrameSet& frame_set, const BodyPose& raw) {
  ResultFrame frame{frame_set.stamp_ns, statusOf(raw.status), raw.reason, {}, raw.part_sigma_m};
  const BodyPose pose = filter_ ? filter_->filtered(frame_set.stamp_ns, raw) : raw;
  if (pose.status != PoseStatus::kLost) {
    model_.forwardKinematics(pose.T_world_body, pose.angles, frame.T_world_link);
    const std::vector<bool> seen = seenLinks(model_, pose);
    for (size_t i = 0; i < seen.size(); ++i)
      if (!seen[i]) frame.T_world_link[i].matrix().setConstant(NAN);
  }
  return frame;
}

std::vector<double> RunReport::overlapsOf(const FrameSet& frame_set, const PipelineResult& result,
                                          const std::vector<cv::Mat>& bodies) {
  std::vector<double> overlaps;
  for (size_t i = 0; i < rig_.size(); ++i) {
    const cv::Mat& mask = result.masks[i];
    const bool comparable = !bodies.empty() && !mask.empty();
    overlaps.push_back(comparable ? maskIou(bodies[i], mask) : NAN);
    has_recorded_masks_[i] |= !frame_set.frames[i].mask.empty();
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
  if (step_ > 1)
    content_.remarks.push_back("This page shows one in " + std::to_string(step_) + " of " +
                               std::to_string(frame_sets_) +
                               " frame sets, and its figures are those of these; the bag has all.");
  for (const auto& [row, overlay] : overlays_.items()) {
    char name[32];
    std::snprintf(name, sizeof name, "/instant_%06zu.png", row * step_);
    if (!cv::imwrite(folder_ + name, overlay.first))
      throw std::runtime_error("cannot write " + folder_ + name);
  }
  const PlayerContent player{&model_, true, &content_.frames, &rig_, &hulls_, &views_, nullptr, {}};
  writeWholeFile(folder_ + "/report.html", reportPage(content_, playerPart(player), model_).html());
}

}  // namespace markerless_mocap
