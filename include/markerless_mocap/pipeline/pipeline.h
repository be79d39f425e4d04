#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/fitting/pose_tracker.h"
#include "markerless_mocap/hull/hull_carver.h"
#include "markerless_mocap/segmentation/body_segmenter.h"
#include "markerless_mocap/silhouette/silhouette_extractor.h"

namespace markerless_mocap {

/// Options of all stages.
struct PipelineOptions {
  SilhouetteOptions silhouette;
  HullOptions hull;
  SegmentationOptions segmentation;
  FittingOptions fitting;
};

/// Reads a configuration file's map: one section per stage (its kStage). Throws
/// std::invalid_argument on an unknown section or key.
PipelineOptions loadPipelineOptions(const YAML::Node& root);

/// One camera's share of an instant; empty mats where missing.
struct CameraFrame {
  cv::Mat image;  ///< CV_8UC3 BGR or CV_8UC1
  cv::Mat mask;   ///< CV_8UC1 0 | 255; when given, background subtraction is passed by
};

/// Everything the stages make of one instant.
struct PipelineResult {
  bool learning = false;  ///< the background is being learned; nothing else is filled
  std::vector<cv::Mat> masks;
  VisualHull hull;
  BodyParts parts;
  BodyPose pose;
};

/// The stages chained in one process; same code as the nodes.
class Pipeline {
 public:
  Pipeline(CameraRig rig, std::shared_ptr<const BodyModel> model, const PipelineOptions& options);
  PipelineResult process(int64_t stamp_ns, const std::vector<CameraFrame>& frames);

 private:
  std::vector<SilhouetteExtractor> silhouettes_;
  HullCarver carver_;
  BodySegmenter segmenter_;
  PoseTracker tracker_;
};

}  // namespace markerless_mocap
