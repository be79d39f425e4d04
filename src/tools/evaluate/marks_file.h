#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "evaluation/joint_track.h"
#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// The marks of one instant.
struct MarkedFrame {
  double time_s = 0.0;  ///< after `start_s`
  /// By the name of the point and of the camera, pixels.
  std::map<std::string, std::map<std::string, Eigen::Vector2d>> points;
};

/// Marks that somebody set by hand in the images of a recording.
struct MarksFile {
  double start_s = NAN;   ///< stamp of time 0, s; NaN: the first frame of the results
  double sigma_px = 5.0;  ///< standard deviation of a mark
  std::vector<MarkedFrame> frames;
};

/// Reads a file of marks. docs/report.md describes it. Throws std::runtime_error if
/// it cannot be read, std::invalid_argument with the file, the place and what is allowed.
MarksFile readMarks(const std::string& path);

/// Points of one person from marks.
struct MarkedTrack {
  JointTrack joints;  ///< bodyPointNames(); NaN without two marks that agree
  size_t marks = 0;   ///< that were used
  double residual_rms_px = NAN, residual_max_px = NAN;  ///< of the marks that were used
  double sigma_mm = NAN;  ///< root mean square of the points' expected errors: by the larger of
                          ///< sigma_px and the residual
  std::vector<std::string> disagreements;  ///< one sentence for each mark that was left out
};

/// The points that the marks' rays meet. Where one of three or more rays does not agree with the
/// others it is left out; two that do not agree give no point. A mark agrees if it is within four
/// sigma_px of the projected point. Throws std::invalid_argument if a camera is not in the rig, or
/// a mark is outside its image.
MarkedTrack triangulated(const MarksFile& marks, const CameraRig& rig, int64_t start_ns);

}  // namespace markerless_mocap
