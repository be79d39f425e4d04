#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "markerless_mocap/products/body_pose.h"

namespace markerless_mocap {

/// One instant in the report; figures are NaN where there is none.
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

/// What the report shows.
struct ReportContent {
  std::string title;
  std::vector<std::string> remarks;  ///< that the page begins with, a sentence each
  std::vector<ReportRow> rows;
  std::vector<std::string> cameras;
  std::vector<double> iou_of_camera;  ///< mean over the instants; NaN without any
  std::vector<ReportPicture> pictures;
};

/// One HTML page that needs nothing beside it: status band, overlap and error over time as SVG,
/// mean overlap per camera, the pictures as JPEG within.
std::string reportPage(const ReportContent& content);

}  // namespace markerless_mocap
