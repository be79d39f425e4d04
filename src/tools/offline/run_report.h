#pragma once

#include <string>
#include <vector>

#include "markerless_mocap/pipeline/pipeline.h"
#include "tools/common/recording.h"
#include "tools/offline/report_page.h"

namespace markerless_mocap {

/// Holds the fitted bodies against the masks: overlap of their silhouettes and pictures of both.
class RunReport {
 public:
  /// Creates the folder. Throws std::runtime_error if that is not possible.
  RunReport(std::string folder, const BodyModel& model, const CameraRig& rig);

  /// \return intersection over union of each view that has a mask; empty when the pose is lost
  std::vector<double> add(const FrameSet& frame_set, const PipelineResult& result);
  /// Writes report.html and the pictures as PNG. Throws std::runtime_error if it cannot.
  /// \param remarks that the page begins with, a sentence each
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
  std::vector<size_t> picture_rows_;  ///< row of each picture
  size_t picture_stride_ = 1;         ///< every how many rows a picture is kept
};

}  // namespace markerless_mocap
