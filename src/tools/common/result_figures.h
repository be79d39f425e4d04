#pragma once

#include <cstdint>
#include <string>

#include "markerless_mocap/products/body_pose.h"

namespace markerless_mocap {

/// What a table of many recordings says about the results of one.
class ResultFigures {
 public:
  /// Adds a frame set, in the order of time.
  /// \param overlap BodyPose::silhouette_overlap
  void add(int64_t stamp_ns, PoseStatus status, double overlap,
           const std::array<double, kPartCount>& part_sigma_m);
  /// A sentence about the calibration; empty: none.
  void setCalibrationFinding(const std::string& finding) { calibration_finding_ = finding; }

  /// frame_sets, seconds (first to last stamp), tracked, reinitialized, lost, silhouette_overlap
  /// (mean, 0 to 1) and expected_error_m (mean over frames and limbs' ends), both null if unknown,
  /// and calibration.
  std::string json() const;

 private:
  struct Mean {
    double sum = 0.0;
    int64_t count = 0;
    void add(double value);
  };

  int64_t frame_sets_ = 0, tracked_ = 0, reinitialized_ = 0;
  int64_t first_ns_ = 0, last_ns_ = 0;
  Mean overlap_, expected_error_m_;
  std::string calibration_finding_;
};

}  // namespace markerless_mocap
