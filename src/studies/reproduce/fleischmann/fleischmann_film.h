#pragma once

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <memory>
#include <optional>
#include <vector>

#include "evaluation/joint_track.h"
#include "fleischmann/fleischmann_fitness.h"
#include "studies/reproduce/paper.h"
#include "tools/common/recording.h"

namespace markerless_mocap {

/// What is true in a capture.
struct FilmTruth {
  std::shared_ptr<const BodyModel> body;  ///< with the true limb lengths
  std::vector<FleischmannVector> poses;   ///< parameters of the body in each frame
  JointTrack joints;                      ///< markerNames() of the person in each frame
};

/// From the options of the capture alone; takes seconds. Throws as VirtualStudio.
FilmTruth filmTruth(const Capture& capture);

/// One frame of a capture.
struct FilmFrame {
  int64_t stamp_ns = 0;
  std::vector<FleischmannView> views;  ///< empty where an image is missing
};

/// The views of a capture, frame by frame.
class FilmReader {
 public:
  /// \param exact silhouettes without the mask_damage of the capture
  FilmReader(const std::string& bag, bool exact);
  ~FilmReader();
  /// Nothing after the last frame.
  std::optional<FilmFrame> next();
  const CameraRig& rig() const { return recording_.rig(); }

 private:
  struct ExactMasks;
  Recording recording_;
  std::unique_ptr<ExactMasks> exact_;  ///< null: the damaged ones
};

/// The frame with this number. Throws std::runtime_error if the capture is shorter.
FilmFrame frameOf(const Capture& capture, size_t number, bool exact);

}  // namespace markerless_mocap
