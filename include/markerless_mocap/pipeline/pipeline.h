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

/// Reads the map of a configuration file: one optional section per stage, named by its kStage.
/// Throws std::invalid_argument on an unknown section or key; the message names the most similar
/// known one.
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

/// The part of a frame set that comes from one camera. A mat is empty if it is missing.
struct CameraFrame {
  cv::Mat image;  ///< CV_8UC3 BGR or CV_8UC1
  cv::Mat mask;   ///< CV_8UC1 0 | 128 unknown | 255; if given, background subtraction is skipped
  double later_s = 0.0;  ///< s, how much later than the frame set's stamp it was taken
};

/// Images or masks of all cameras at one time.
struct FrameSet {
  int64_t stamp_ns = 0;             ///< capture time
  std::vector<CameraFrame> frames;  ///< in the order of the rig
  std::any owner;  ///< keeps the pixels alive if the mats of `frames` only refer to them
};

/// The pose of an earlier frame set.
struct EarlierPose {
  int64_t stamp_ns;  ///< capture time
  BodyPose pose;
};

/// The results of all stages for one frame set.
struct PipelineResult : FrameProducts {
  bool learning = false;  ///< too few cameras have learned their background; all other members are
                          ///< empty
  std::vector<cv::Mat>
      masks;  ///< one per camera, CV_8UC1 0 | 128 unknown | 255; empty where missing
  BodyPose pose;
  std::shared_ptr<const TrackedBody> body;  ///< the body that the poses refer to
  /// Poses of frame sets right before that had none, in the order of time; see
  /// Pipeline::followBack().
  std::vector<EarlierPose> earlier_poses;
};

class LostFrameSets;

/// All stages in one process, with the same code as the nodes. The result depends neither on the
/// number of threads nor on whether frame sets are processed one by one or in a stream.
class Pipeline {
 public:
  /// Called instead of the work of a stage on one frame set; it must call `work`. `stage` is the
  /// stage's kStage. In a stream, it is called from several threads.
  using StageWatch = std::function<void(const char* stage, const std::function<void()>& work)>;
  /// Returns nothing after the last frame set.
  using Source = std::function<std::optional<FrameSet>()>;
  using Sink = std::function<void(const FrameSet&, const PipelineResult&)>;

  /// Throws std::invalid_argument if a stage rejects its options or the rig.
  Pipeline(CameraRig rig, const PersonResources& resources, const PipelineOptions& options);
  ~Pipeline();

  /// \param stamp_ns capture time, nanoseconds
  /// \param frames one per camera, in the order of the rig. Throws std::invalid_argument if their
  ///   number is wrong, or if an image or mask differs in size from its camera; the message names
  ///   the camera.
  PipelineResult process(int64_t stamp_ns, const std::vector<CameraFrame>& frames);

  /// Processes all frame sets of the source. The stages work in parallel, each on a different frame
  /// set. Source and sink run in parallel with the stages; each is called in the order of time and
  /// never concurrently with itself. Throws as process(), and what source and sink throw.
  void processStream(const Source& source, const Sink& sink);

  /// Backgrounds from an earlier pass, one per camera, or none; nullptr: it is learned from the
  /// first images. Throws std::invalid_argument if their number is wrong.
  void useBackgrounds(const std::vector<SharedBackground>& backgrounds);
  /// Shows a frame set to the silhouettes alone: their backgrounds follow the light. Throws as
  /// process().
  void followLight(const FrameSet& frame_set);
  /// The backgrounds in use, one per camera, as SilhouetteExtractor::background(). Do not call this
  /// while a stream is processed.
  std::vector<SharedBackground> backgrounds() const;

  const CameraRig& rig() const { return carver_.rig(); }
  /// The current body of the person; it changes after its shape has been estimated. Do not call
  /// this while a stream is processed: use PipelineResult::body there.
  const std::shared_ptr<const TrackedBody>& body() const { return tracker_->body(); }
  /// As BodyTracker::estimateShapeNow().
  void estimateShapeNow() { tracker_->estimateShapeNow(); }
  void setStageWatch(StageWatch watch) { watch_ = std::move(watch); }
  /// What is made only of frame sets where the tracker asks for it, and is empty in the results of
  /// the others. The poses are the same.
  enum class OnDemand {
    kNothing,
    kParts,           ///< parts and tree
    kPartsAndVoxels,  ///< the hull's voxels, too; its status and its cameras are always there
  };
  void setOnDemand(OnDemand products) { on_demand_ = products; }
  /// From now on, once the person has been found, it is followed back through the frame sets
  /// without a pose right before, as far as it can be: PipelineResult::earlier_poses. The poses of
  /// a stream then begin with the person, not with the time that it takes to find it: its sink gets
  /// results with these poses, and those without a pose later. At most kMostEarlierPoses frame sets
  /// are kept in memory for it, with their images.
  void followBack();
  static constexpr size_t kMostEarlierPoses = 30;

 private:
  struct Work {
    FrameSet frame_set;
    PipelineResult result;
    HullDraft draft;  ///< as long as the result's hull lacks its voxels
  };
  struct Stage;
  class Products;
  static const std::vector<Stage>& stages();

  void run(const Stage& stage, Work& work);
  void checkFrames(const std::vector<CameraFrame>& frames) const;
  void extractSilhouettes(Work& work);
  void carve(Work& work);
  void completeHull(Work& work);
  void segment(Work& work);
  void buildTree(Work& work);
  void makeParts(Work& work);
  void track(Work& work);

  int min_views_;
  OnDemand on_demand_ = OnDemand::kNothing;
  std::vector<SilhouetteExtractor> silhouettes_;
  HullCarver carver_;
  BodySegmenter segmenter_;
  PartTracker part_tracker_;
  PoseTreeBuilder tree_builder_;
  std::unique_ptr<BodyTracker> tracker_;
  std::unique_ptr<LostFrameSets> lost_;  ///< null: they are not wanted
  StageWatch watch_ = [](const char*, const std::function<void()>& work) { work(); };
};

}  // namespace markerless_mocap
