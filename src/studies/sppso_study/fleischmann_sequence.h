#pragma once

#include <vector>

#include "capture/virtual_studio.h"
#include "evaluation/joint_track.h"
#include "fleischmann/fleischmann_fitness.h"

namespace markerless_mocap {

/// A view cropped to the person.
struct CroppedView {
  cv::Rect part;
  cv::Mat silhouette, image;  ///< CV_8UC1, cropped to `part`
};

/// One frame of a sequence.
struct SequenceFrame {
  int64_t stamp_ns = 0;
  std::vector<CroppedView> views;
  FleischmannVector truth;  ///< true parameters of the body
};

/// Rendered images of a person with exact masks, kept in memory.
struct FleischmannSequence {
  CameraRig rig;
  std::shared_ptr<const BodyModel> body;  ///< with the true limb lengths
  double fps = 0.0;
  std::vector<SequenceFrame> frames;
  JointTrack joints;  ///< true markerNames() of each frame
};

/// Renders the first `frames` frames of the motion. Throws as VirtualStudio.
/// \param progress called with the number of finished frames
FleischmannSequence filmOf(const StudioOptions& studio, const StudioFiles& files, int frames,
                           const std::function<void(int)>& progress);

/// The views at full size, black outside the cropped part.
std::vector<FleischmannView> wholeViews(const FleischmannSequence& film, size_t frame);

}  // namespace markerless_mocap
