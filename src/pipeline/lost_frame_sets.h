#pragma once

#include <deque>

#include "markerless_mocap/pipeline/pipeline.h"

namespace markerless_mocap {

/// The last frame sets without a pose, up to Pipeline::kMostEarlierPoses, for a tracker that
/// follows the person back to them.
class LostFrameSets {
 public:
  /// \param masks those that the tracker got
  void add(const FrameSet& frame_set, std::vector<cv::Mat> masks, const FrameProducts& products);
  /// Poses of the frame sets that the tracker gets back to from its last one, in the order of time.
  /// Forgets all frame sets.
  std::vector<EarlierPose> followedBackBy(BodyTracker& tracker);

 private:
  struct Lost {
    int64_t stamp_ns;
    std::vector<cv::Mat> masks, images;
    std::vector<double> later_s;
    ReadyProducts products;
    std::any owner;  ///< of the images
  };

  std::deque<Lost> lost_;
};

/// By camera.
std::vector<cv::Mat> imagesOf(const std::vector<CameraFrame>& frames);
std::vector<double> latenessOf(const std::vector<CameraFrame>& frames);

}  // namespace markerless_mocap
