#pragma once

#include <string>
#include <vector>

#include "markerless_mocap/pipeline/pipeline.h"
#include "tools/common/recording.h"
#include "tools/offline/report_page.h"

namespace markerless_mocap {

/// Throws std::runtime_error if the folder of a report cannot be made or written to.
void makeReportFolder(const std::string& folder);

/// Compares the fitted bodies with the masks: overlap of the silhouettes, and overlay images.
class RunReport {
 public:
  /// Creates the folder. Throws std::runtime_error if this fails.
  RunReport(std::string folder, const BodyModel& model, const CameraRig& rig);

  /// \return intersection over union of each view with a mask; empty if the pose is lost
  std::vector<double> add(const FrameSet& frame_set, const PipelineResult& result);
  /// The backgrounds to show, one per camera; nullptr: none.
  /// \param from_recording those that were learned from the whole recording, or no elements
  /// \param in_use those in use after the last frame set
  void addBackgrounds(const std::vector<SharedBackground>& from_recording,
                      const std::vector<SharedBackground>& in_use);
  /// Writes report.html and the overlays as PNG. Throws std::runtime_error if this fails.
  /// \param remarks lines at the top of the page
  void write(const std::string& title, const std::vector<std::string>& remarks = {});

 private:
  std::vector<cv::Mat> bodyMasks(const BodyPose& pose) const;
  std::vector<double> addViews(const FrameSet& frame_set, const PipelineResult& result,
                               const std::vector<cv::Mat>& bodies);
  void keepPicture(const FrameSet& frame_set, const PipelineResult& result,
                   const std::vector<cv::Mat>& bodies, const std::string& caption);

  std::string folder_;
  const BodyModel& model_;
  const CameraRig& rig_;
  ReportContent content_;
  std::vector<char> has_recorded_masks_;  ///< by camera
  std::vector<size_t> picture_rows_;      ///< row of each overlay
  size_t picture_stride_ = 1;             ///< an overlay is kept every this many rows
};

}  // namespace markerless_mocap
