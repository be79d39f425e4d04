#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "markerless_mocap/products/body_pose.h"

namespace markerless_mocap {

/// One frame in the report; numbers are NaN if unknown.
struct ReportRow {
  int64_t stamp_ns = 0;
  PoseStatus status = PoseStatus::kLost;
  std::string reason;
  double mean_iou = 0.0;  ///< over the views
  double skeleton_error_m = 0.0;
};

struct ReportPicture {
  std::string caption;
  cv::Mat image;  ///< CV_8UC3
};

/// Content of the report.
struct ReportContent {
  std::string title;
  std::vector<std::string> remarks;  ///< lines at the top of the page
  std::vector<ReportRow> rows;
  std::vector<std::string> cameras;
  std::vector<double> iou_of_camera;  ///< mean over the frames; NaN without any
  std::vector<ReportPicture> pictures;
};

/// A self-contained HTML page: status band, overlap and error over time as SVG, mean overlap per
/// camera, images as JPEG.
std::string reportPage(const ReportContent& content);

}  // namespace markerless_mocap
