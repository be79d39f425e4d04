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

/// The images of all cameras at one time, with the ground truth.
struct StudioFrameSet {
  int64_t time_ns = 0;          ///< time since the first frame set
  std::vector<cv::Mat> images;  ///< by camera, CV_8UC3 BGR; empty where dropped
  /// By camera, CV_8UC1, 0 | 255; with damage; empty where dropped.
  std::vector<cv::Mat> silhouettes;
  std::vector<cv::Mat> masks;  ///< by camera, CV_8UC1, 0 | 255, exact
  bool person = false;         ///< false while the room is empty; then the fields below are not set
  BodyState body;              ///< state of body()
  std::vector<Eigen::Vector3d> points;  ///< positions of groundTruthNames(), world metres
};

struct FilmTime;
class StudioScene;
class StudioCameras;

/// Renders a dressed person who moves in front of a rig of cameras in a room. Each frame set
/// depends on its index only: frame sets can be rendered in any order and from any thread, and the
/// same options give the same bytes.
class VirtualStudio {
 public:
  /// \param body_id id of the URDF body that follows the person
  /// Throws std::invalid_argument or std::runtime_error on invalid options, files or id, and if the
  /// motion leaves the capture volume.
  VirtualStudio(const StudioOptions& options, const StudioFiles& files, const std::string& body_id);
  ~VirtualStudio();

  const StudioOptions& options() const { return options_; }
  /// The cameras as calibrated, with an error of calibration_error_px.
  const CameraRig& rig() const;
  /// The true cameras.
  const CameraRig& trueRig() const;
  /// The URDF body that follows the person.
  const BodyModel& body() const;
  const std::string& urdf() const;
  double stature() const;  ///< stature of the person, metres
  /// Number of frame sets: those of the empty room and those of the motion.
  int frameSetCount() const;
  /// \param index from 0; the first `background_frames` show the empty room; beyond frameSetCount()
  ///   the motion continues. Throws std::invalid_argument below 0.
  StudioFrameSet render(int index) const;

 private:
  void film(int index, const FilmTime& time, StudioFrameSet* frame_set) const;

  StudioOptions options_;
  std::unique_ptr<const StudioCameras> cameras_;
  std::unique_ptr<const StudioScene> scene_;
};

}  // namespace markerless_mocap
