#pragma once

#include <functional>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/fitting/body_tracker.h"
#include "markerless_mocap/hull/hull_carver.h"
#include "markerless_mocap/segmentation/body_segmenter.h"
#include "markerless_mocap/segmentation/part_memory.h"
#include "markerless_mocap/silhouette/silhouette_extractor.h"
#include "markerless_mocap/skeleton/pose_tree_builder.h"

namespace markerless_mocap {

/// Options of all stages.
struct PipelineOptions {
  SilhouetteOptions silhouette;
  HullOptions hull;
  SegmentationOptions segmentation;
  PoseTreeOptions pose_tree;
  TrackerOptions fitting;
};

/// Reads a configuration file's map: one section per stage (its kStage), each optional. Throws
/// std::invalid_argument on an unknown section or key, naming the nearest known one.
PipelineOptions loadPipelineOptions(const YAML::Node& root);

/// Calls `function(section, options)` for every stage, in the order of processing.
template <class Function>
void forEachStage(PipelineOptions& options, const Function& function) {
  function(SilhouetteOptions::kStage, options.silhouette);
  function(HullOptions::kStage, options.hull);
  function(SegmentationOptions::kStage, options.segmentation);
  function(PoseTreeOptions::kStage, options.pose_tree);
  function(TrackerOptions::kStage, options.fitting);
}

/// One camera's share of an instant; empty mats where missing.
struct CameraFrame {
  cv::Mat image;  ///< CV_8UC3 BGR or CV_8UC1
  cv::Mat mask;   ///< CV_8UC1 0 | 255; when given, background subtraction is passed by
};

/// Everything the stages make of one instant.
struct PipelineResult {
  bool learning = false;       ///< backgrounds are being learned, too few cameras have a mask yet;
                               ///< nothing else is filled
  std::vector<cv::Mat> masks;  ///< one per camera, CV_8UC1 0 | 255; empty where missing
  VisualHull hull;
  BodyParts parts;
  PoseTree tree;
  BodyPose pose;
};

/// The stages chained in one process; same code as the nodes. Silhouettes are made in parallel;
/// the result does not depend on the number of threads.
class Pipeline {
 public:
  /// Called with a stage's name (its kStage) when the stage is done with an instant.
  using StageListener = std::function<void(const char* stage)>;

  /// Throws std::invalid_argument on options or a rig that a stage refuses.
  Pipeline(CameraRig rig, const TrackerSources& sources, const PipelineOptions& options);

  /// \param stamp_ns capture time, nanoseconds
  /// \param frames one per camera of the rig, in its order; throws std::invalid_argument on a wrong
  ///   count, or an image or mask whose size is not its camera's (the sentence names it)
  PipelineResult process(int64_t stamp_ns, const std::vector<CameraFrame>& frames);

  const CameraRig& rig() const { return carver_.rig(); }
  /// The person's body now; process() changes it when it has been measured.
  const std::shared_ptr<const TrackedBody>& body() const { return tracker_->body(); }
  /// As BodyTracker::measureNow().
  void measureBodyNow() { tracker_->measureNow(); }
  void setStageListener(StageListener listener) { stage_done_ = std::move(listener); }

 private:
  void checkFrames(const std::vector<CameraFrame>& frames) const;
  /// False while too few cameras have learned their background.
  bool extractSilhouettes(const std::vector<CameraFrame>& frames, std::vector<cv::Mat>* masks);

  int min_views_;
  std::vector<SilhouetteExtractor> silhouettes_;
  HullCarver carver_;
  BodySegmenter segmenter_;
  PartMemory part_memory_;
  PoseTreeBuilder tree_builder_;
  std::unique_ptr<BodyTracker> tracker_;
  StageListener stage_done_ = [](const char*) {};
};

}  // namespace markerless_mocap
