#pragma once

#include <any>
#include <functional>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/hull/hull_carver.h"
#include "markerless_mocap/pipeline/make_body_tracker.h"
#include "markerless_mocap/segmentation/body_segmenter.h"
#include "markerless_mocap/segmentation/part_tracker.h"
#include "markerless_mocap/silhouette/silhouette_extractor.h"
#include "markerless_mocap/skeleton/pose_tree_builder.h"
#include "markerless_mocap/tracking/body_tracker.h"

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

/// What the cameras saw at one instant.
struct FrameSet {
  int64_t stamp_ns = 0;             ///< capture time
  std::vector<CameraFrame> frames;  ///< in the order of the rig
  std::any owner;                   ///< keeps pixels alive that the frames' mats only point to
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
  std::shared_ptr<const TrackedBody> body;  ///< whose pose it is
};

/// The stages chained in one process; same code as the nodes. The result does not depend on the
/// number of threads, nor on whether instants are processed one by one or in a stream.
class Pipeline {
 public:
  /// Called in place of a stage's work on one instant, which it must do; `stage` is its kStage. In
  /// a stream several threads call it.
  using StageWatch = std::function<void(const char* stage, const std::function<void()>& work)>;
  /// Nothing when there are no more instants.
  using Source = std::function<std::optional<FrameSet>()>;
  using Sink = std::function<void(const FrameSet&, const PipelineResult&)>;

  /// Throws std::invalid_argument on options or a rig that a stage refuses.
  Pipeline(CameraRig rig, const PersonResources& sources, const PipelineOptions& options);

  /// \param stamp_ns capture time, nanoseconds
  /// \param frames one per camera of the rig, in its order; throws std::invalid_argument on a wrong
  ///   count, or an image or mask whose size is not its camera's (the sentence names it)
  PipelineResult process(int64_t stamp_ns, const std::vector<CameraFrame>& frames);

  /// Processes all instants of the source, each stage being at work on another one. Source and sink
  /// are called side by side with the stages, each in the order of time and never twice at once.
  /// Throws as process() and what source and sink throw.
  void processStream(const Source& source, const Sink& sink);

  const CameraRig& rig() const { return carver_.rig(); }
  /// The person's body now; it changes when it has been measured. Not while a stream is processed:
  /// there, results have it.
  const std::shared_ptr<const TrackedBody>& body() const { return tracker_->body(); }
  /// As BodyTracker::estimateShapeNow().
  void estimateShapeNow() { tracker_->estimateShapeNow(); }
  void setStageWatch(StageWatch watch) { watch_ = std::move(watch); }

 private:
  struct Work {
    FrameSet instant;
    PipelineResult result;
  };
  struct Stage;
  static const std::vector<Stage>& stages();

  void run(const Stage& stage, Work& work);
  void checkFrames(const std::vector<CameraFrame>& frames) const;
  void extractSilhouettes(const FrameSet& instant, PipelineResult* result);
  void carve(const FrameSet& instant, PipelineResult* result);
  void segment(const FrameSet& instant, PipelineResult* result);
  void buildTree(const FrameSet& instant, PipelineResult* result);
  void track(const FrameSet& instant, PipelineResult* result);

  int min_views_;
  std::vector<SilhouetteExtractor> silhouettes_;
  HullCarver carver_;
  BodySegmenter segmenter_;
  PartTracker part_memory_;
  PoseTreeBuilder tree_builder_;
  std::unique_ptr<BodyTracker> tracker_;
  StageWatch watch_ = [](const char*, const std::function<void()>& work) { work(); };
};

}  // namespace markerless_mocap
