#include "markerless_mocap/pipeline/pipeline.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace markerless_mocap {
namespace {

void checkSize(const Camera& camera, const cv::Mat& pixels, const char* what) {
  if (pixels.empty() || (pixels.cols == camera.width() && pixels.rows == camera.height())) return;
  throw std::invalid_argument(std::string(what) + " of camera " + camera.name() + " is " +
                              std::to_string(pixels.cols) + " x " + std::to_string(pixels.rows) +
                              " pixels, its calibration says " + std::to_string(camera.width()) +
                              " x " + std::to_string(camera.height()));
}

std::vector<HullView> viewsOf(const std::vector<CameraFrame>& frames,
                              const std::vector<cv::Mat>& masks) {
  std::vector<HullView> views(frames.size());
  for (size_t i = 0; i < frames.size(); ++i)
    if (!masks[i].empty()) views[i] = {masks[i], frames[i].image};
  return views;
}

std::vector<cv::Mat> imagesOf(const std::vector<CameraFrame>& frames) {
  std::vector<cv::Mat> images;
  for (const CameraFrame& frame : frames) images.push_back(frame.image);
  return images;
}

}  // namespace

Pipeline::Pipeline(CameraRig rig, const TrackerSources& sources, const PipelineOptions& options)
    : min_views_(options.hull.min_views),
      carver_(std::move(rig), options.hull),
      segmenter_(options.segmentation),
      tree_builder_(options.pose_tree),
      tracker_(makeBodyTracker(carver_.rig(), sources, options.fitting)) {
  for (size_t i = 0; i < carver_.rig().size(); ++i) silhouettes_.emplace_back(options.silhouette);
}

PipelineResult Pipeline::process(int64_t stamp_ns, const std::vector<CameraFrame>& frames) {
  checkFrames(frames);
  PipelineResult result;

  result.learning = !extractSilhouettes(frames, &result.masks);
  stage_done_(SilhouetteOptions::kStage);
  if (result.learning) return result;

  result.hull = carver_.carve(viewsOf(frames, result.masks));
  stage_done_(HullOptions::kStage);

  result.parts = segmenter_.segment(result.hull, stamp_ns, &part_memory_);
  stage_done_(SegmentationOptions::kStage);

  result.tree = tree_builder_.build(result.hull);
  stage_done_(PoseTreeOptions::kStage);

  result.pose = tracker_->update(
      {stamp_ns, result.masks, imagesOf(frames), result.hull, result.parts, result.tree});
  stage_done_(TrackerOptions::kStage);
  return result;
}

void Pipeline::checkFrames(const std::vector<CameraFrame>& frames) const {
  if (frames.size() != rig().size())
    throw std::invalid_argument("pipeline got " + std::to_string(frames.size()) +
                                " frames, the rig has " + std::to_string(rig().size()) +
                                " cameras");
  for (size_t i = 0; i < frames.size(); ++i) {
    checkSize(rig()[i], frames[i].image, "image");
    checkSize(rig()[i], frames[i].mask, "mask");
  }
}

bool Pipeline::extractSilhouettes(const std::vector<CameraFrame>& frames,
                                  std::vector<cv::Mat>* masks) {
  std::vector<cv::Mat> found(frames.size());
  std::vector<char> learning(frames.size(), false);
  tbb::parallel_for(size_t(0), frames.size(), [&](size_t i) {
    if (!frames[i].mask.empty()) {
      found[i] = frames[i].mask;
    } else if (!frames[i].image.empty()) {
      SilhouetteResult silhouette = silhouettes_[i].update(frames[i].image);
      found[i] = silhouette.mask;
      learning[i] = silhouette.state == SilhouetteState::kLearning;
    }
  });
  const auto ready =
      std::count_if(found.begin(), found.end(), [](const cv::Mat& mask) { return !mask.empty(); });
  const bool any_learning = std::count(learning.begin(), learning.end(), true) > 0;
  if (any_learning && ready < min_views_) return false;
  *masks = std::move(found);
  return true;
}

}  // namespace markerless_mocap
