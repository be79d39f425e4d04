#pragma once

#include <optional>
#include <string>

#include "contour/orientation_sampler.h"
#include "contour/self_calibration.h"
#include "markerless_mocap/pipeline/pipeline.h"

namespace markerless_mocap {

/// Compares the calibration with the person's contours in a run of the contour method. It changes
/// nothing.
class CalibrationCheck {
 public:
  /// \param pipeline of the run; its body must have been measured, otherwise nothing is checked
  CalibrationCheck(const Pipeline& pipeline, const TrackerOptions& options);

  void add(const FrameSet& frame_set, const PipelineResult& result);
  /// Sentences that say whether the metre seems to be wrong, which cameras seem to be rotated, and
  /// how to correct that; one per line, empty if there is nothing to be said.
  std::string finding() const;

 private:
  CameraRig rig_;
  ContourOptions options_;
  std::optional<ContourBody> body_;
  std::optional<OrientationSampler> sampler_;
};

/// The sentence of CalibrationCheck::finding() for an estimate.
std::string calibrationFinding(const OrientationRefinement& estimate);

/// Adds a frame with its result to the samples of a calibration.
void addSample(const FrameSet& frame_set, const PipelineResult& result,
               OrientationSampler* sampler);

}  // namespace markerless_mocap
