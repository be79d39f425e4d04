#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/capture/body_motion.h"
#include "markerless_mocap/capture/renderer.h"
#include "markerless_mocap/capture/studio_options.h"

namespace markerless_mocap {

/// All cameras at one instant, with the truth.
struct StudioInstant {
  int64_t time_ns = 0;          ///< since the first instant
  std::vector<cv::Mat> images;  ///< by camera, CV_8UC3 BGR, with sensor noise
  std::vector<cv::Mat> masks;   ///< by camera, CV_8UC1, 0 | 255, exact
  bool person = false;          ///< false while the room is empty; then there is no truth below
  BodyState body;
  std::vector<Eigen::Vector3d> markers;  ///< markerPositions(), world metres
};

/// A body's own shape, moving before a ring of cameras in a room. Each instant is a function of its
/// index alone, so any can be asked for, from any thread, and the same options give the same bytes.
class VirtualStudio {
 public:
  /// \param urdf_template text of urdf/human.urdf.in
  /// \param body_id of the person
  /// Throws std::invalid_argument on bad options, template or id.
  VirtualStudio(const std::string& urdf_template, const std::string& body_id,
                const StudioOptions& options);

  const StudioOptions& options() const { return options_; }
  const CameraRig& rig() const { return rig_; }
  const BodyModel& model() const { return *model_; }
  const std::string& urdf() const { return urdf_; }
  /// Empty-room instants and those of the motion.
  int instantCount() const;
  /// \param index from 0; the first `background_frames` show the empty room, beyond
  ///   instantCount() the motion goes on. Throws std::invalid_argument below 0.
  StudioInstant render(int index) const;

 private:
  StudioOptions options_;
  std::string urdf_;
  std::shared_ptr<const BodyModel> model_;
  WalkAndWave motion_;
  CameraRig rig_;
  std::vector<ViewRenderer> renderers_;  ///< by camera
};

}  // namespace markerless_mocap
