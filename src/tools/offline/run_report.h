#pragma once

#include <string>
#include <vector>

#include "markerless_mocap/pipeline/pipeline.h"
#include "tools/common/recording.h"
#include "tools/offline/report_page.h"

namespace markerless_mocap {

/// Compares the fitted bodies with the masks: overlap of the silhouettes, and overlay images.
class RunReport {
 public:
  /// Creates the folder. Throws std::runtime_error if this fails.
  RunReport(std::string folder, const BodyModel& model, const CameraRig& rig);

  /// \return intersection over union of each view with a mask; empty if the pose is lost
  std::vector<double> add(const FrameSet& frame_set, const PipelineResult& result);
  /// Writes report.html and the overlays as PNG. Throws std::runtime_error if this fails.
  /// \param remarks lines at the top of the page
  void write(const std::string& title, const std::vector<std::string>& remarks = {});

 private:
  std::vector<cv::Mat> bodyMasks(const BodyPose& pose) const;
  void keepPicture(const FrameSet& frame_set, const PipelineResult& result,
                   const std::vector<cv::Mat>& bodies, const std::string& caption);

  std::string folder_;
  const BodyModel& model_;
  const CameraRig& rig_;
  ReportContent content_;
  std::vector<double> iou_sum_;
  std::vector<int> iou_count_;
  std::vector<size_t> picture_rows_;  ///< row of each overlay
  size_t picture_stride_ = 1;         ///< an overlay is kept every this many rows
};

}  // namespace markerless_mocap
