#pragma once

#include <vector>

#include "capture/virtual_studio.h"
#include "evaluation/joint_track.h"
#include "fleischmann/fleischmann_fitness.h"

namespace markerless_mocap {

/// A view without what lies far from the person.
struct CroppedView {
  cv::Rect part;
  cv::Mat silhouette, image;  ///< of the part: CV_8UC1 both
};

/// One instant of a film.
struct SequenceFrame {
  int64_t stamp_ns = 0;
  std::vector<CroppedView> views;
  FleischmannVector truth;  ///< parameters of the driven body
};

/// A person filmed with exact masks, kept in memory.
struct FleischmannSequence {
  CameraRig rig;
  std::shared_ptr<const BodyModel> body;  ///< with the person's limb lengths
  double fps = 0.0;
  std::vector<SequenceFrame> frames;
  JointTrack joints;  ///< the true fifteen of each frame
};

/// Films `frames` instants from the first one of the motion. Throws as VirtualStudio.
/// \param progress called with the number of frames that are done
FleischmannSequence filmOf(const StudioOptions& studio, const StudioFiles& files, int frames,
                           const std::function<void(int)>& progress);

/// Whole images again, black where nothing was kept.
std::vector<FleischmannView> wholeViews(const FleischmannSequence& film, size_t frame);

}  // namespace markerless_mocap
