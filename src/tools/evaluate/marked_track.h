#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "evaluation/joint_track.h"
#include "markerless_mocap/camera/camera.h"
#include "tools/evaluate/marks_file.h"

namespace markerless_mocap {

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
