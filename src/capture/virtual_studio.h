#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "capture/body_state.h"
#include "capture/studio_options.h"
#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Files of the package that the studio needs.
struct StudioFiles {
  std::string urdf_template;   ///< text of urdf/human.urdf.in
  std::string motions_folder;  ///< path of config/motions
};

/// All cameras at one instant, with the truth.
struct StudioFrameSet {
  int64_t time_ns = 0;               ///< since the first instant
  std::vector<cv::Mat> images;       ///< by camera, CV_8UC3 BGR; empty where dropped
  std::vector<cv::Mat> silhouettes;  ///< by camera, CV_8UC1, 0 | 255; damaged; empty where dropped
  std::vector<cv::Mat> masks;        ///< by camera, CV_8UC1, 0 | 255, exact
  bool person = false;  ///< false while the room is empty; then there is no truth below
  BodyState body;       ///< of body()
  std::vector<Eigen::Vector3d> points;  ///< of groundTruthNames(), world metres
};

class StudioScene;
class StudioCameras;

/// A dressed person, moving before a rig of cameras in a room. Each instant is a function of its
/// index alone, so any can be asked for, from any thread, and the same options give the same bytes.
class VirtualStudio {
 public:
  /// \param body_id of the URDF body that is driven by the person
  /// Throws std::invalid_argument or std::runtime_error with one sentence on bad options, files or
  /// id and when the motion leaves the stage.
  VirtualStudio(const StudioOptions& options, const StudioFiles& files, const std::string& body_id);
  ~VirtualStudio();

  const StudioOptions& options() const { return options_; }
  /// The cameras as their calibration tells them, off by calibration_error_px.
  const CameraRig& rig() const;
  /// Where the cameras really are.
  const CameraRig& trueRig() const;
  /// The URDF body that the person drives.
  const BodyModel& body() const;
  const std::string& urdf() const;
  double stature() const;  ///< of the person, metres
  /// Empty-room instants and those of the motion.
  int frameSetCount() const;
  /// \param index from 0; the first `background_frames` show the empty room, beyond
  ///   frameSetCount() the motion goes on. Throws std::invalid_argument below 0.
  StudioFrameSet render(int index) const;

 private:
  void film(int index, double seconds, StudioFrameSet* frame_set) const;

  StudioOptions options_;
  std::unique_ptr<const StudioCameras> cameras_;
  std::unique_ptr<const StudioScene> scene_;
};

}  // namespace markerless_mocap
